// SPDX-License-Identifier: MIT
// How scripts in a process of their own hear of the daemon's end, and what they lose with it.
#include "daemon/core/script_bridge.h"
#include "tests/core/remote_scripts.h"

#include <chrono>

using namespace hyrax;

namespace {

using std::chrono::milliseconds;

struct Scene {
    Scene() {
        auto made =
            std::make_unique<RemoteScriptHost>(std::make_unique<FakeScriptChannel>(process));
        bridge.emplace(std::move(made));
        bridge->load({{"a.lua", "a"}});
    }
    void frame() {
        now += 10 * ms;
        bridge->watch(now);
        bridge->run(engine, {}, now);
    }
    // What the bridge was left to carry out.
    std::size_t end(milliseconds patience) {
        bridge->end(engine, {}, {now, now}, patience);
        return bridge->take_wishes().size();
    }
    ScriptOutput keeping(std::string key) const {
        ScriptOutput output;
        output.commands = {command::Store{"a.lua", std::move(key), {true}}};
        return output;
    }
    bool told_of_the_end() const {
        const auto runs = process.heard_of<wire::Run>();
        return !runs.empty() && runs.back().world.ending;
    }

    FakeProcess process;
    Engine engine{{{"hyrax", {10, 10}}}, {}, 1};
    std::optional<ScriptBridge> bridge;
    Ticks now = 0;
};

}  // namespace

TEST_CASE("the end waits for the answer before it and for its own") {
    Scene scene;
    scene.frame();
    scene.process.while_waited_for = [&] {
        scene.process.answer(scene.keeping(scene.told_of_the_end() ? "last" : "before"));
    };
    CHECK(scene.end(milliseconds(10'000)) == 2);
    CHECK(scene.told_of_the_end());
}

TEST_CASE("the end does not wait for scripts that hang, nor start any") {
    Scene scene;
    scene.frame();
    scene.process.while_waited_for = [] {};
    CHECK(scene.end(milliseconds(5)) == 0);
    CHECK_FALSE(scene.told_of_the_end());

    Scene dying;
    dying.frame();
    dying.process.while_waited_for = [&] { dying.process.crash(); };
    CHECK(dying.end(milliseconds(10'000)) == 0);
    CHECK(dying.process.starts == 1);
    CHECK(dying.bridge->take_loss());
}

TEST_CASE("the end carries out more than a frame does") {
    Scene scene;
    scene.frame();
    ScriptOutput much;
    for (std::size_t i = 0; i < ScriptBridge::most_commands + 7; ++i) {
        much.commands.emplace_back(command::Store{"a.lua", "k", {true}});
    }
    scene.process.answer(much);
    scene.process.while_waited_for = [&] { scene.process.answer(); };
    CHECK(scene.end(milliseconds(10'000)) == ScriptBridge::most_commands + 7);
    CHECK(scene.told_of_the_end());
}

TEST_CASE("a process that goes, for whatever reason, takes what was asked of the desktop along") {
    Remote hanging;
    hanging.host.load(three);
    hanging.frame();
    hanging.process.pulse.enter(1);
    hanging.frame();
    *hanging.process.used += 260 * ms;
    const auto found_out = hanging.frame();
    REQUIRE(found_out);
    CHECK(found_out->lost);

    Remote leaving;
    leaving.host.load(three);
    leaving.frame();
    leaving.process.answer();
    const auto usual = leaving.frame();
    REQUIRE(usual);
    CHECK_FALSE(usual->lost);
    leaving.process.answer();
    leaving.host.load({});
    leaving.frame();
    leaving.frame();
    leaving.process.answer();
    const auto last = leaving.frame();
    REQUIRE(last);
    CHECK(last->lost);
    CHECK_FALSE(leaving.process.alive);
}
