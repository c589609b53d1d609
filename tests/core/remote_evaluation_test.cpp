// SPDX-License-Identifier: MIT
// Texts of a developer for scripts in a process of their own: none of them stays without an answer.
#include "tests/core/remote_scripts.h"

#include <doctest/doctest.h>

using namespace hyrax;

namespace {

const ScriptWorld asking{
    .now = 1, .pets = {}, .monitors = {}, .evaluations = {{7, "b.lua", "x"}, {8, "a.lua", "y"}}
};

}  // namespace

TEST_CASE("evaluations go to the process, and its answers come back") {
    Remote remote;
    remote.host.load(three);
    remote.host.run(asking, {});
    const std::vector<wire::Run> runs = remote.process.heard_of<wire::Run>();
    REQUIRE(runs.at(0).world.evaluations.size() == 2);
    CHECK(runs[0].world.evaluations[0].text == "x");
    ScriptOutput said;
    said.evaluated = {{7, true, "5\n6", "printed\n"}};
    remote.process.answer(said);
    remote.host.watch(remote.now);
    auto output = remote.host.take_output();
    REQUIRE(output);
    REQUIRE(output->evaluated.size() == 1);
    CHECK(output->evaluated[0].text == "5\n6");

    // The other one is still open when the process crashes.
    remote.frame();
    remote.process.pulse.enter(0);
    remote.process.crash();
    output = remote.frame();
    REQUIRE(output);
    REQUIRE(output->evaluated.size() == 1);
    CHECK(output->evaluated[0].id == 8);
    CHECK_FALSE(output->evaluated[0].good);
}

TEST_CASE("a text that hangs is answered by the watchdog") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    remote.process.answer();
    remote.host.watch(remote.now);
    remote.host.take_output();
    remote.host.run(asking, {});
    remote.process.pulse.enter(1);
    remote.frame();
    *remote.process.used += 240 * ms;
    CHECK_FALSE(remote.frame());
    *remote.process.used += 20 * ms;
    const auto output = remote.frame();
    REQUIRE(output);
    REQUIRE(output->evaluated.size() == 2);
    CHECK(output->evaluated[0].id == 7);
    CHECK(output->evaluated[0].text.starts_with("b.lua: "));
    CHECK(output->evaluated[0].text.contains("stopped"));
    CHECK(remote.host.ended() == Names{"b.lua"});
}

TEST_CASE("without a process the answer comes at once") {
    Remote remote;
    remote.process.refuses_to_start = true;
    remote.host.load(three);
    const ScriptOutput output = remote.host.run(asking, {});
    CHECK(output.evaluated.size() == 2);
}

TEST_CASE("a text that was stopped starts again with another turn") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    remote.hang(1);
    remote.frame();
    CHECK(remote.loaded() == Names{"a.lua", "c.lua"});
    std::vector<ScriptSource> anew = three;
    anew[1].turn = 1;
    remote.process.answer();
    remote.host.load(anew);
    remote.frame();
    CHECK(remote.process.heard_of<ScriptSource>().back().turn == 0);
    CHECK(remote.loaded() == Names{"a.lua", "c.lua", "a.lua", "b.lua", "c.lua"});
    CHECK(remote.host.ended().empty());
}
