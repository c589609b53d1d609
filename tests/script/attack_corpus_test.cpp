// SPDX-License-Identifier: MIT
// The hostile scripts of attacks/, in one process; headless_tests run them in a process of their
// own.
#include "tests/support/attack_corpus.h"

#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

using namespace hyrax;

namespace {

// A single library call that no count sees into: only the watchdog of another process ends it.
bool needs_watchdog(const Attack& attack) {
    return attack.name.starts_with("20_") || attack.name.starts_with("21_") ||
           attack.name.starts_with("72_");
}

}  // namespace

TEST_CASE("every attack ends as its first line says, and honest scripts go on") {
    const std::string honest = "local n = 0 hyrax.every(0.1, function() n = n + 1 print(n) end)";
    std::size_t tried = 0;
    for (const Attack& attack : attacks()) {
        if (needs_watchdog(attack)) {
            continue;
        }
        CAPTURE(attack.name);
        // A part of the usual budget: what never ends does so sooner.
        const bool endless = attack.end == Attack::End::kill;
        FakeWorld world(ScriptLimits{.load_units = endless ? 2'000'000 : 20'000'000});
        const PetKey pet = world.add_pet();
        world.load({{"first.lua", honest}, {attack.name, attack.text}, {"last.lua", honest}});
        world.play(0.5);
        CAPTURE(world.errors());
        CHECK(ended_as_it_must(attack, world.errors()));
        CHECK(world.said().contains("4\n4\n"));
        CHECK(world.find(pet) != nullptr);
        CHECK(world.log.size() <= 120);
        ++tried;
    }
    CHECK(tried > 40);
}
