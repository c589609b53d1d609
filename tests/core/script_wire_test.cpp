// SPDX-License-Identifier: MIT
#include "tests/core/script_wire_samples.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <tuple>

using namespace hyrax;
using namespace hyrax::wire;

namespace {

// What a reader says of a message whose byte at this place is another; the place may be counted
// from the end.
std::string problem_with(Bytes message, std::ptrdiff_t place, unsigned byte) {
    const auto index = place < 0 ? static_cast<std::ptrdiff_t>(message.size()) + place : place;
    message[static_cast<std::size_t>(index)] = static_cast<std::byte>(byte);
    const auto decoded = decode_answer(body(message));
    return decoded ? "" : decoded.error().message;
}

Bytes answer_with(const ScriptCommand& command) {
    ScriptOutput output;
    output.commands = {command};
    Bytes bytes;
    encode_answer(bytes, 1, output);
    return bytes;
}

Bytes answer_with(const ScriptOutput& output) {
    Bytes bytes;
    encode_answer(bytes, 1, output);
    return bytes;
}

}  // namespace

TEST_CASE("what is written is read again") {
    Samples samples(1);
    for (int i = 0; i < 500; ++i) {
        const ScriptWorld world = samples.world();
        const std::vector<ScriptEvent> events = samples.events();
        Bytes bytes;
        encode_run(bytes, 77, world, events);
        const auto decoded = decode_to_host(body(bytes));
        REQUIRE(decoded);
        const Run& run = std::get<Run>(*decoded);
        CHECK(run.number == 77);
        CHECK(run.world.now == world.now);
        CHECK(run.world.monitors == world.monitors);
        REQUIRE(run.world.pets.size() == world.pets.size());
        for (std::size_t p = 0; p < world.pets.size(); ++p) {
            const PetView& a = run.world.pets[p];
            const PetView& b = world.pets[p];
            CHECK(
                std::tie(a.key, a.kind, a.owner, a.tag, a.position, a.velocity, a.box) ==
                std::tie(b.key, b.kind, b.owner, b.tag, b.position, b.velocity, b.box)
            );
            CHECK(
                std::tie(a.state, a.faces_left, a.spawned_at) ==
                std::tie(b.state, b.faces_left, b.spawned_at)
            );
            CHECK(a.scale == b.scale);
            CHECK(run.world.kinds[p].name == world.kinds[p].name);
            CHECK(run.world.kinds[p].animations == world.kinds[p].animations);
            CHECK(run.world.pressed_hotkeys[p].script == world.pressed_hotkeys[p].script);
            CHECK(run.world.pressed_hotkeys[p].id == world.pressed_hotkeys[p].id);
        }
        CHECK(run.world.cursor == world.cursor);
        CHECK(run.world.windows == world.windows);
        CHECK(run.world.ending == world.ending);
        REQUIRE(run.events.size() == events.size());
        for (std::size_t e = 0; e < events.size(); ++e) {
            CHECK(run.events[e].event == events[e].event);
            CHECK(run.events[e].pet == events[e].pet);
            CHECK(run.events[e].other == events[e].other);
        }
    }
}

TEST_CASE("sources, limits and answers are read again") {
    Samples samples(2);
    Bytes bytes;
    ScriptSource source{.name = "a.lua", .text = std::string("print(1)\0", 9)};
    encode(bytes, source);
    CHECK(std::get<ScriptSource>(decode_to_host(body(bytes)).value()) == source);
    for (int i = 0; i < 200; ++i) {
        bytes.clear();
        source = samples.source();
        encode(bytes, source);
        CHECK(std::get<ScriptSource>(decode_to_host(body(bytes)).value()) == source);
    }

    bytes.clear();
    Load load = samples.load();
    load.limits.callback_time = std::chrono::milliseconds(123);
    load.limits.notice_pause = std::chrono::seconds(7);
    load.limits.unload_units = 11;
    load.limits.store = 12;
    load.limits.speech = 13;
    encode(bytes, load);
    const Load read = std::get<Load>(decode_to_host(body(bytes)).value());
    CHECK(read.scripts == load.scripts);
    CHECK(read.anew == load.anew);
    CHECK(read.limits.pets == load.limits.pets);
    CHECK(read.limits.callback_time == load.limits.callback_time);
    CHECK(read.limits.seed == load.limits.seed);
    CHECK(read.limits.notice_pause == load.limits.notice_pause);
    CHECK(read.limits.unload_units == 11);
    CHECK(read.limits.store == 12);
    CHECK(read.limits.speech == 13);

    ScriptOutput output;
    output.commands = {command::Spawn{script_made_key | 5U, {.kind = "rock", .tag = "t"}}};
    output.log = {{LogLevel::warning, "a.lua", "careful"}};
    output.listening.add(EventKind::land);
    output.next_wake = 99;
    output.ended = {3};
    output.tests = {{"a.lua", "falls", "a.lua:2: expected 2, got 1", 0.5}};
    output.open_tests = 4;
    output.uses = {{"a.lua", 1'000, 2'000, 3, output.listening}};
    const Answer answer = decode_answer(body(answer_with(output))).value();
    CHECK(std::get<command::Spawn>(answer.output.commands.at(0)).options.kind == "rock");
    CHECK(answer.output.log.at(0).level == LogLevel::warning);
    CHECK(answer.output.log.at(0).text == "careful");
    CHECK(answer.output.listening == output.listening);
    CHECK(answer.output.next_wake == 99);
    CHECK(answer.output.ended == output.ended);
    REQUIRE(answer.output.tests.size() == 1);
    CHECK(answer.output.tests[0].name == "falls");
    CHECK(answer.output.tests[0].problem == "a.lua:2: expected 2, got 1");
    CHECK(answer.output.tests[0].seconds == 0.5);
    CHECK(answer.output.open_tests == 4);
    CHECK(answer.output.uses == output.uses);
}

TEST_CASE("commands of looks, walks and wishes are read again") {
    ScriptOutput output;
    output.commands = {
        command::WalkTo{1, 300.0, 50.0},
        command::Play{2, "cheer", true, 10.0},
        command::Say{3, "hello", 2.0},
        command::SetScale{4, 2.0},
        command::Face{5, true},
        command::Store{"a.lua", "k", {ScriptValue::List{{true}, {1.5}, {"x"}}}},
        command::Notify{"a.lua", "text"},
        command::Hotkey{"a.lua", 6, "f5", "label"},
        command::Wind{"a.lua", {-3.0, 4.5}},
    };
    const auto read = decode_answer(body(answer_with(output))).value().output.commands;
    REQUIRE(read.size() == output.commands.size());
    const auto& walk = std::get<command::WalkTo>(read[0]);
    CHECK(std::tie(walk.pet, walk.x, walk.speed) == std::make_tuple(PetKey{1}, 300.0, 50.0));
    const auto& play = std::get<command::Play>(read[1]);
    CHECK(play.animation == "cheer");
    CHECK(play.loop == true);
    CHECK(play.fps == 10.0);
    CHECK(std::get<command::Say>(read[2]).text == "hello");
    CHECK(std::get<command::Say>(read[2]).seconds == 2.0);
    CHECK(std::get<command::SetScale>(read[3]).scale == 2.0);
    CHECK(std::get<command::Face>(read[4]).left);
    const auto& store = std::get<command::Store>(read[5]);
    CHECK(store.key == "k");
    CHECK(store.value == std::get<command::Store>(output.commands[5]).value);
    CHECK(std::get<command::Notify>(read[6]).text == "text");
    const auto& hotkey = std::get<command::Hotkey>(read[7]);
    CHECK(hotkey.id == 6);
    CHECK(hotkey.keys == "f5");
    CHECK(hotkey.label == "label");
    CHECK(std::get<command::Wind>(read[8]).script == "a.lua");
    CHECK(std::get<command::Wind>(read[8]).velocity == Vec2{-3.0, 4.5});
}

TEST_CASE("values are bounded in depth and size, and their tables are in order") {
    const auto stored = [](ScriptValue value) {
        return answer_with(command::Store{"a.lua", "k", std::move(value)});
    };
    const auto read = [](const Bytes& bytes) {
        const auto answer = decode_answer(body(bytes)).value();
        return std::get<command::Store>(answer.output.commands.at(0)).value;
    };
    ScriptValue deep{true};
    for (std::size_t i = 0; i < deepest_value + 20; ++i) {
        deep = {ScriptValue::List{deep}};
    }
    const ScriptValue cut = read(stored(deep));
    std::size_t depth = 0;
    for (const ScriptValue* at = &cut; const auto* list = std::get_if<ScriptValue::List>(&at->data);
         at = &list->front()) {
        ++depth;
    }
    CHECK(depth == deepest_value);

    const ScriptValue wide{ScriptValue::List(most_values, ScriptValue{true})};
    CHECK(decode_answer(body(stored(wide))).error().message.contains("too many values"));

    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(decode_answer(body(stored({nan}))).error().message.contains("not finite"));

    const auto problem = [](const Bytes& bytes) {
        return decode_answer(body(bytes)).error().message;
    };
    CHECK(problem(stored({ScriptTable{{"b", {true}}, {"a", {true}}}})).contains("not in order"));
    CHECK(problem(stored({ScriptTable{{"a", {true}}, {"a", {true}}}})).contains("not in order"));
    // Behind the header, number, count, command, "a.lua" and "k".
    CHECK(problem_with(stored({true}), 33, 9).contains("no such value"));
}

TEST_CASE("a message that nests deeper than any value is refused") {
    Bytes bytes = answer_with(command::Store{"a.lua", "k", {}});
    const std::ptrdiff_t value = 33;
    REQUIRE(bytes[value] == std::byte{0});
    Bytes nested;
    for (std::size_t i = 0; i < 100'000; ++i) {
        for (const unsigned byte : {5U, 1U, 0U, 0U, 0U}) {
            nested.push_back(static_cast<std::byte>(byte));
        }
    }
    bytes.insert(bytes.begin() + value, nested.begin(), nested.end());
    CHECK(decode_answer(body(bytes)).error().message.contains("too deep in others"));
}

TEST_CASE("every message encodes to its own bytes again") {
    Samples samples(3);
    for (int i = 0; i < 300; ++i) {
        const ScriptOutput output = samples.output();  // with NaN here and there
        const Bytes once = answer_with(output);
        CHECK(answer_with(decode_answer(body(once)).value().output) == once);
    }
}

TEST_CASE("what a host must not say is refused by name") {
    ScriptOutput output;
    output.log = {{LogLevel::error, "a", "b"}};
    const Bytes logged = answer_with(output);
    CHECK(problem_with(logged, 4, 9).contains("another version"));
    CHECK(problem_with(logged, 5, 9).contains("no such message"));
    CHECK(problem_with(logged, 5, 0).contains("no answer"));
    // After number and count of commands and lines: the level of the first line.
    CHECK(problem_with(logged, 22, 3).contains("no such choice"));
    CHECK(problem_with(logged, 27, '\n').contains("control character"));
    CHECK(problem_with(logged, 23, 200).contains("longer than its message"));
    CHECK(problem_with(logged, 25, 1).contains("too long"));
    CHECK(problem_with(logged, 14, 120).contains("list is longer"));
    CHECK(problem_with(logged, 17, 50).contains("too many"));

    const Bytes spawned = answer_with(command::Spawn{script_made_key, {}});
    CHECK(problem_with(spawned, 18, 200).contains("no such command"));
    CHECK(problem_with(spawned, 26, 0).contains("key of the daemon's"));

    const Bytes empty = answer_with(ScriptOutput{});
    CHECK(problem_with(empty, 25, 0x80).contains("no such event"));
    CHECK(problem_with(empty, 25, 0).empty());
    Bytes longer = empty;
    longer.push_back({});
    CHECK(decode_answer(body(longer)).error().message.contains("follows its end"));
    longer.resize(longer.size() - 2);
    CHECK(decode_answer(body(longer)).error().message.contains("ends too early"));
}

TEST_CASE("the world holds finite numbers only, commands any") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Bytes bytes;
    encode_run(bytes, 1, {.now = 0, .pets = {{.position = {nan, 0.0}}}, .monitors = {}}, {});
    CHECK(decode_to_host(body(bytes)).error().message.contains("not finite"));
    CHECK(decode_answer(body(answer_with(command::Fling{1, {nan, nan}}))));
}

TEST_CASE("what is above a limit is cut when it is written") {
    ScriptOutput output;
    output.commands.assign(most_commands + 10, command::Stop{1});
    output.log.assign(most_lines + 10, {LogLevel::info, "a", std::string(9'000, 'x') + "\n"});
    const auto decoded = decode_answer(body(answer_with(output)));
    REQUIRE(decoded);
    CHECK(decoded->output.commands.size() == most_commands);
    CHECK(decoded->output.log.size() == most_lines);
    CHECK(decoded->output.log[0].text.size() == longest_line);
}

TEST_CASE("a stream is cut into messages wherever it breaks") {
    Samples samples(4);
    std::vector<Bytes> messages;
    Bytes all;
    for (int i = 0; i < 20; ++i) {
        messages.push_back(samples.message());
        all.insert(all.end(), messages.back().begin(), messages.back().end());
    }
    MessageStream stream(longest_to_host);
    std::size_t found = 0;
    for (std::size_t at = 0; at < all.size();) {
        const std::size_t size = std::min(all.size() - at, 1 + samples.below(300));
        stream.add(std::span(all).subspan(at, size));
        at += size;
        while (true) {
            const auto next = stream.next();
            REQUIRE(next);
            if (!*next) {
                break;
            }
            REQUIRE(found < messages.size());
            CHECK(std::ranges::equal(**next, body(messages[found])));
            ++found;
        }
    }
    CHECK(found == messages.size());
}

TEST_CASE("a length above the limit breaks the stream at once") {
    MessageStream stream(100);
    const std::uint32_t length = 101;
    stream.add(std::as_bytes(std::span(&length, 1)));
    CHECK(stream.next().error().message.contains("101 bytes, at most 100"));
}
