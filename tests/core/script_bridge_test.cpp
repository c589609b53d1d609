// SPDX-License-Identifier: MIT
#include "tests/core/script_bridge_stage.h"

#include <doctest/doctest.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

using namespace hyrax;

TEST_CASE("without scripts nothing runs and nothing wakes") {
    Engine engine({{"hyrax", {10, 10}}}, {}, 1);
    ScriptBridge none(nullptr);
    none.load({});
    none.run(engine, {}, 1'000'000);
    CHECK(none.next_wake() == never);
}

TEST_CASE("a pet keeps the key that its script made") {
    Stage stage;
    stage.recorder.answer.commands = {
        command::Spawn{key, {.at = Vec2{5.0, 6.0}, .owner = "test.lua"}}
    };
    stage.run();
    REQUIRE(stage.engine.size() == 1);

    stage.recorder.answer.commands = {command::Fling{key, {7.0, 8.0}}};
    stage.run();
    REQUIRE(stage.recorder.world.pets.size() == 1);
    CHECK(stage.recorder.world.pets[0].key == key);
    CHECK(stage.recorder.world.pets[0].owner == "test.lua");
    CHECK(stage.recorder.world.pets[0].position == Vec2{5.0, 6.0});
    CHECK(stage.recorder.world.pets[0].spawned_at == Vec2{5.0, 6.0});
    REQUIRE(stage.recorder.world.kinds.size() == 1);
    CHECK(stage.recorder.world.kinds[0].name == "hyrax");
    REQUIRE(stage.recorder.events.size() == 1);
    CHECK(stage.recorder.events[0].pet == key);
    stage.engine.for_each([](PetId, const Pet& pet) { CHECK(pet.velocity() == Vec2{7.0, 8.0}); });
}

TEST_CASE("a removed pet's events still carry its key, then the key is forgotten") {
    Stage stage;
    stage.recorder.answer.next_wake = 0;
    stage.recorder.answer.commands = {command::Spawn{key, {.tag = "stage"}}};
    stage.run();
    stage.run();
    stage.recorder.answer.commands = {command::Remove{key}};
    stage.run(1);
    CHECK(stage.engine.size() == 0);
    stage.run(1);
    REQUIRE(stage.recorder.events.size() >= 1);
    CHECK(stage.recorder.events[0].event.kind == EventKind::remove);
    CHECK(stage.recorder.events[0].event.tag == "stage");
    CHECK(stage.recorder.events[0].pet == key);

    // The slot's next owner is not reached through the old key.
    const auto fresh = stage.engine.spawn({});
    REQUIRE(fresh);
    stage.recorder.answer.commands = {command::Fling{key, {99.0, 0.0}}};
    stage.run(1);
    CHECK(stage.engine.find(*fresh)->velocity() == Vec2{});
}

TEST_CASE("other pets have keys made from their ids") {
    Stage stage;
    const auto id = stage.engine.spawn({});
    REQUIRE(id);
    stage.run();
    REQUIRE(stage.recorder.world.pets.size() == 1);
    const PetKey seen = stage.recorder.world.pets[0].key;
    CHECK((seen & script_made_key) == 0);
    stage.recorder.answer.commands = {command::SetTag{seen, "mine"}};
    stage.recorder.answer.next_wake = 0;
    stage.bridge.load({{"test.lua", ""}});
    stage.run(1);
    CHECK(stage.engine.find(*id)->tag == "mine");
}

TEST_CASE("winds of scripts add up, and what is left of one goes with the other") {
    Stage stage;
    const auto blow = [&stage](std::vector<ScriptCommand> commands) {
        stage.recorder.answer.commands = std::move(commands);
        stage.recorder.answer.next_wake = 0;
        stage.run(1);
        return stage.engine.wind();
    };
    CHECK(blow({command::Wind{"a", {300.0, 10.0}}}) == Vec2{300.0, 10.0});
    CHECK(blow({command::Wind{"b", {-100.0, 5.0}}}) == Vec2{200.0, 15.0});
    CHECK(blow({command::Wind{"a", {100.0, 0.0}}}) == Vec2{0.0, 5.0});
    CHECK(stage.engine.integrator() == Integrator::rk45);
    CHECK(blow({command::Wind{"a", {}}, command::Wind{"b", {}}}) == Vec2{});
    CHECK(stage.engine.integrator() == Integrator::event_driven);
}

TEST_CASE("who is given up is told of once") {
    Stage stage;
    stage.recorder.answer.given_up = {"rock"};
    stage.run();
    CHECK(stage.bridge.take_given_up() == std::vector<std::string>{"rock"});
    CHECK(stage.bridge.take_given_up().empty());
}

TEST_CASE("who is retired loses its pets, and gets no more until it is loaded again") {
    Stage stage;
    stage.recorder.answer.commands = {
        command::Spawn{key, {.owner = "rock"}}, command::Spawn{key + 1, {.owner = "other"}}
    };
    stage.run();
    REQUIRE(stage.engine.size() == 2);
    stage.bridge.retire(stage.engine, "rock");
    CHECK(stage.engine.size() == 1);
    stage.recorder.answer.commands = {command::Spawn{key + 2, {.owner = "rock"}}};
    stage.recorder.answer.next_wake = 0;
    stage.run(1);
    CHECK(stage.engine.size() == 1);
    stage.bridge.load({{"rock", ""}});
    stage.recorder.answer.commands = {command::Spawn{key + 3, {.owner = "rock"}}};
    stage.run(2);
    CHECK(stage.engine.size() == 2);
}

TEST_CASE("looks and walks reach the engine; what is not for it is kept for somebody else") {
    Stage stage;
    stage.recorder.answer.commands = {command::Spawn{key, {.at = Vec2{100.0, 590.0}}}};
    stage.run();
    stage.recorder.answer.commands = {
        command::WalkTo{key, 300.0, 50.0},
        command::Play{key, "idle", true, 10.0},
        command::Say{key, "hello", 2.0},
        command::SetScale{key, 2.0},
        command::Face{key, true},
        command::Store{"a.lua", "k", {true}},
        command::Notify{"a.lua", "text"},
        command::Hotkey{"a.lua", 1, "f5", "label"},
    };
    stage.recorder.answer.next_wake = 0;
    stage.run(1);
    stage.engine.for_each([](PetId, const Pet& pet) {
        REQUIRE(pet.walk.has_value());
        CHECK(pet.walk->target == 300.0);
        CHECK(pet.walk->speed == 50.0);
        REQUIRE(pet.playing.has_value());
        CHECK(pet.playing->fps == 10.0);
        REQUIRE(pet.speech.has_value());
        CHECK(pet.speech->text == "hello");
        CHECK(pet.scale == 2.0);
        CHECK(pet.faces_left);
    });
    const auto wishes = stage.bridge.take_wishes();
    REQUIRE(wishes.size() == 3);
    CHECK(std::get<command::Store>(wishes[0]).key == "k");
    CHECK(std::get<command::Hotkey>(wishes[2]).keys == "f5");
    CHECK(stage.bridge.take_wishes().empty());
    stage.run(2);
    CHECK(stage.recorder.world.pets[0].scale == 2.0);
}

TEST_CASE("who is to stay does not walk: no pet while quiet, none on the ground while calm") {
    for (const bool quiet : {true, false}) {
        CAPTURE(quiet);
        Stage stage;
        stage.recorder.answer.commands = {command::Spawn{key, {.at = Vec2{100.0, 590.0}}}};
        stage.run();
        stage.bridge.set_quiet(quiet);
        stage.bridge.set_calm(!quiet);
        stage.recorder.answer.commands = {
            command::WalkTo{key, 300.0, 50.0}, command::SetTag{key, "heard"}
        };
        stage.recorder.answer.next_wake = 0;
        stage.run(1);
        stage.engine.for_each([](PetId, const Pet& pet) {
            CHECK_FALSE(pet.walk.has_value());
            CHECK(pet.tag == "heard");
        });
    }
}

TEST_CASE("pets that meet keep their keys, and the end is told to scripts that are loaded") {
    Stage stage;
    stage.recorder.answer.commands = {
        command::Spawn{key, {.at = Vec2{100.0, 100.0}}},
        command::Spawn{key + 1, {.at = Vec2{200.0, 100.0}, .velocity = {-500.0, 0.0}}},
    };
    stage.run();
    bool met = false;
    for (Ticks now = 0; now < ticks_per_second; now += ticks_per_second / 60) {
        stage.engine.advance(now);
        stage.recorder.events.clear();
        stage.run(now);
        for (const ScriptEvent& event : stage.recorder.events) {
            if (event.event.kind == EventKind::collide) {
                CHECK(event.pet == key);
                CHECK(event.other == key + 1);
                met = true;
            }
        }
    }
    CHECK(met);
    CHECK_FALSE(stage.recorder.world.ending);
    stage.bridge.end(stage.engine, {}, {ticks_per_second, 0}, {});
    CHECK(stage.recorder.world.ending);
}

TEST_CASE("the latest error of each script is kept until scripts are loaded") {
    Stage stage;
    stage.recorder.answer.log = {
        {LogLevel::warning, "a.lua", "careful"},
        {LogLevel::error, "a.lua", "a.lua:1: first"},
        {LogLevel::error, "a.lua", "    a.lua:1: in main chunk"},
        {LogLevel::error, "a.lua", "a.lua:2: second"},
        {LogLevel::error, "b.lua", "b.lua:1: other"},
    };
    stage.run();
    const std::map<std::string, std::string> latest{
        {"a.lua", "a.lua:2: second"}, {"b.lua", "b.lua:1: other"}
    };
    CHECK(stage.bridge.errors() == latest);
    stage.bridge.load({{"a.lua", "x"}});
    CHECK(stage.bridge.errors().empty());
}

TEST_CASE("scripts run only when an event, a timer or a load asks for it") {
    Stage stage;
    stage.recorder.answer.next_wake = 500;
    stage.run(0);
    CHECK(stage.recorder.runs == 1);
    stage.run(499);
    CHECK(stage.recorder.runs == 1);
    stage.run(500);
    CHECK(stage.recorder.runs == 2);
    REQUIRE(stage.engine.spawn({}));
    stage.run(501);
    CHECK(stage.recorder.runs == 3);
}

TEST_CASE("a frame carries out so many commands, the others wait for the next ones") {
    Stage stage;
    const auto id = stage.engine.spawn({});
    REQUIRE(id);
    stage.run();
    const PetKey seen = stage.recorder.world.pets.at(0).key;
    for (std::size_t i = 1; i <= ScriptBridge::most_commands + 1; ++i) {
        stage.recorder.answer.commands.push_back(command::SetTag{seen, std::to_string(i)});
    }
    stage.recorder.answer.next_wake = 0;
    stage.bridge.load({{"test.lua", ""}});
    stage.run(1);
    CHECK(stage.engine.find(*id)->tag == "1000");
    CHECK(stage.bridge.next_wake() == 0);
    const int runs = stage.recorder.runs;
    stage.run(2);
    CHECK(stage.engine.find(*id)->tag == "1001");
    CHECK(stage.recorder.runs == runs);  // scripts wait for their own commands
    stage.run(3);
    CHECK(stage.recorder.runs == runs + 1);
}

TEST_CASE("a key that is taken makes no second pet") {
    Stage stage;
    stage.recorder.answer.commands = {command::Spawn{key, {}}, command::Spawn{key, {}}};
    stage.run();
    CHECK(stage.engine.size() == 1);
}

TEST_CASE("while scripts are busy events wait, the oldest of too many are dropped") {
    Recorder recorder;
    auto busy_host = std::make_unique<BusyHost>(recorder);
    BusyHost& host = *busy_host;
    Engine engine({{"hyrax", {10, 10}}}, {}, 1);
    engine.set_arena(Arena({{{0, 0, 800, 600}, {0, 0, 800, 600}, true, {}}}, FloorEdge::screen));
    ScriptBridge bridge(std::move(busy_host));
    bridge.load({{"test.lua", ""}});
    bridge.run(engine, {}, 0);
    CHECK(recorder.runs == 1);

    ScriptOutput output;
    output.listening = EventMask::all();
    host.output = output;
    host.is_busy = true;
    const auto id = engine.spawn({});
    REQUIRE(id);
    for (std::size_t i = 0; i < ScriptBridge::most_events + 10; ++i) {
        engine.click(*id, i < 20 ? Button::left : Button::right);
        bridge.run(engine, {}, 1);
    }
    CHECK(recorder.runs == 1);
    CHECK(bridge.next_wake() == never);

    host.is_busy = false;
    bridge.run(engine, {}, 2);
    CHECK(recorder.runs == 2);
    CHECK(recorder.events.size() == ScriptBridge::most_events);
    CHECK(recorder.events.at(9).event.button == Button::left);
    CHECK(recorder.events.at(10).event.button == Button::right);
    bridge.run(engine, {}, 3);
    CHECK(recorder.runs == 2);
}
