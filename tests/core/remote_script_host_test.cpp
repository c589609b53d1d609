// SPDX-License-Identifier: MIT
#include "daemon/core/remote_script_host.h"

#include "tests/core/remote_scripts.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace hyrax;

TEST_CASE("no process without a script, none after the last one") {
    Remote remote;
    remote.host.load({});
    remote.frame();
    CHECK(remote.process.starts == 0);
    CHECK(remote.host.watch_due() == never);

    remote.host.load(three);
    CHECK(remote.process.starts == 0);
    remote.frame();
    CHECK(remote.process.starts == 1);
    CHECK(remote.loaded() == Names{"a.lua", "b.lua", "c.lua"});
    CHECK(remote.process.heard_of<wire::Load>().at(0).scripts == 3);

    remote.process.answer();
    remote.frame();
    remote.process.answer();
    remote.host.load({});
    remote.frame();
    CHECK(remote.process.alive);  // until they have heard of it
    CHECK(remote.process.heard_of<wire::Load>().at(1).scripts == 0);
    ScriptOutput last_words;
    last_words.commands = {command::Stop{7}};
    remote.process.answer(last_words);
    remote.host.watch(remote.now);
    CHECK(remote.host.take_output()->commands.size() == 1);
    CHECK_FALSE(remote.process.alive);
    CHECK_FALSE(remote.host.busy());
    CHECK(remote.host.watch_due() == never);
}

TEST_CASE("one run is under way at a time, and its answer comes once") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    CHECK(remote.host.busy());
    remote.frame();
    CHECK(remote.process.heard_of<wire::Run>().size() == 1);

    ScriptOutput said;
    said.commands = {command::Stop{7}};
    said.listening.add(EventKind::land);
    said.next_wake = 5;
    remote.process.answer(said);
    remote.host.watch(remote.now);
    CHECK_FALSE(remote.host.busy());
    const auto output = remote.host.take_output();
    REQUIRE(output);
    CHECK(std::get<command::Stop>(output->commands.at(0)).pet == 7);
    CHECK(output->next_wake == 5);
    CHECK_FALSE(remote.host.take_output());

    // While the next run is under way, the daemon keeps listening for what it listened for.
    CHECK(remote.host.run({}, {}).listening == said.listening);
    CHECK(remote.process.heard_of<wire::Run>().size() == 2);
    CHECK(remote.process.starts == 1);
}

TEST_CASE("a script that hangs is named and stays out, the others start again") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    remote.process.answer();
    remote.frame();
    CHECK(
        remote.hang(1) == "b.lua: gave no sign of life for 250 ms of processor time (a library "
                          "call without an end?); stopped until it is loaded again"
    );
    CHECK(remote.process.kills == 1);
    CHECK(remote.process.starts == 2);
    CHECK(remote.loaded() == Names{"a.lua", "c.lua"});

    // Another file is saved: the culprit's text is still the same.
    remote.host.load({{"a.lua", "new"}, {"b.lua", "b"}});
    remote.process.answer();
    remote.frame();
    CHECK(remote.loaded().back() == "a.lua");
    // The user mends it.
    remote.host.load({{"a.lua", "new"}, {"b.lua", "better"}});
    remote.process.answer();
    remote.frame();
    CHECK(remote.loaded().back() == "b.lua");
    CHECK(remote.process.starts == 2);
}

TEST_CASE("a process that starts again knows what scripts have kept and are set to") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    ScriptOutput said;
    said.commands = {command::Store{"b.lua", "n", {std::int64_t{3}}}};
    remote.process.answer(said);
    remote.host.watch(remote.now);
    std::vector<ScriptSource> set = three;
    set[1].store = {{"n", {std::int64_t{3}}}};
    set[2].config = {{"speed", {1.5}}};
    remote.host.load(set);
    remote.frame();
    remote.process.crash();
    remote.frame();
    remote.frame(std::vector<ScriptEvent>{}, 20 * ticks_per_second);
    CHECK(remote.process.starts == 2);
    const auto sources = remote.process.heard_of<ScriptSource>();
    REQUIRE(sources.size() == 3);
    CHECK(sources[1].store == ScriptTable{{"n", {std::int64_t{3}}}});
    CHECK(sources[2].config == ScriptTable{{"speed", {1.5}}});
}

TEST_CASE("with nobody left to run there is no process") {
    Remote remote;
    remote.host.load({{"a.lua", "a"}});
    remote.frame();
    remote.hang(0);
    CHECK_FALSE(remote.process.alive);
    CHECK(remote.process.starts == 1);
    remote.host.load({{"a.lua", "a"}});
    remote.frame();
    CHECK(remote.process.starts == 1);
}

TEST_CASE("beats keep a busy script alive, up to three seconds in one call") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    remote.process.pulse.enter(2);
    remote.frame();
    for (int i = 0; i < 14; ++i) {
        *remote.process.used += 200 * ms;
        remote.process.pulse.beat();
        CHECK_FALSE(remote.frame());
    }
    remote.process.pulse.enter(2);
    *remote.process.used += 200 * ms;
    CHECK_FALSE(remote.frame());
    std::optional<ScriptOutput> output;
    for (int i = 0; i < 16 && !output; ++i) {
        *remote.process.used += 200 * ms;
        remote.process.pulse.beat();
        output = remote.frame();
    }
    REQUIRE(output);
    CHECK(output->log.at(0).text.starts_with("c.lua: used more than 3 s"));
}

TEST_CASE("time on the wall is not held against a script whose processor time is known") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    remote.process.pulse.enter(0);
    CHECK_FALSE(remote.frame({}, 3'600 * ticks_per_second));
    CHECK(remote.host.busy());
}

TEST_CASE("where it is not known, the wall counts in small steps") {
    Remote remote;
    remote.process.used.reset();
    remote.host.load(three);
    remote.frame();
    remote.process.pulse.enter(0);
    CHECK_FALSE(remote.frame({}, 3'600 * ticks_per_second));  // the machine slept
    int looks = 0;
    while (!remote.frame({}, 50 * ms)) {
        ++looks;
    }
    CHECK(looks >= 18);
    CHECK(looks <= 22);
}

TEST_CASE("there, a process that has not begun with a script has ten seconds") {
    Remote remote;
    remote.process.used.reset();
    remote.host.load(three);
    remote.frame();
    int looks = 0;
    while (!remote.frame({}, 50 * ms)) {
        ++looks;
    }
    CHECK(looks >= 195);
    CHECK(looks <= 205);
}

TEST_CASE("a crash is the fault of the script that was running, an end from outside nobody's") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    remote.process.pulse.enter(1);
    remote.process.be_killed();
    auto output = remote.frame();
    REQUIRE(output);
    CHECK(output->log.at(0).text == "it ended its process (signal 9)");
    CHECK(output->next_wake == 0);
    CHECK(remote.process.starts == 2);
    CHECK(remote.loaded().size() == 3);

    remote.process.pulse.enter(1);
    remote.process.crash();
    output = remote.frame();
    REQUIRE(output);
    CHECK(output->log.at(0).text.starts_with("b.lua: ended its process (signal 11); stopped"));
    CHECK(remote.loaded() == Names{"a.lua", "c.lua"});
}

TEST_CASE("what was said before the end counts") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    ScriptOutput said;
    said.commands = {command::Stop{7}};
    remote.process.answer(said);
    remote.process.be_killed();
    const auto output = remote.frame();
    REQUIRE(output);
    CHECK(output->commands.size() == 1);
    CHECK(output->next_wake == 0);
}

TEST_CASE("a process that always dies is started less and less often") {
    Remote remote;
    remote.host.load(three);
    for (int i = 0; i < 1'000; ++i) {  // ten seconds
        remote.frame();
        remote.process.be_killed();
    }
    CHECK(remote.process.starts >= 6);
    CHECK(remote.process.starts <= 10);
    CHECK(remote.host.watch_due() > remote.now);
}

TEST_CASE("a process that cannot be started is told once and tried again") {
    Remote remote;
    remote.process.refuses_to_start = true;
    remote.host.load(three);
    int told = 0;
    for (int i = 0; i < 100; ++i) {
        told += remote.frame().has_value() ? 1 : 0;
    }
    CHECK(told == 1);
    remote.process.refuses_to_start = false;
    for (int i = 0; i < 100; ++i) {
        remote.frame();
    }
    CHECK(remote.process.starts == 1);
}

TEST_CASE("a process that speaks out of turn or nonsense is ended") {
    for (const bool nonsense : {false, true}) {
        Remote remote;
        remote.host.load(three);
        remote.frame();
        remote.process.pulse.enter(2);
        if (nonsense) {
            remote.process.to_say.assign(100, std::byte{0x55});
        } else {
            wire::encode_answer(remote.process.to_say, 12'345, {});
        }
        const auto output = remote.frame();
        REQUIRE(output);
        CHECK(output->log.at(0).text.starts_with("c.lua: broken message: "));
        CHECK(remote.process.kills == 1);
        CHECK(remote.loaded() == Names{"a.lua", "b.lua"});
    }
}

TEST_CASE("scripts that their limits ended do not run again after a new start") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    ScriptOutput said;
    said.ended = {2, 999};
    remote.process.answer(said);
    remote.frame();
    remote.process.be_killed();
    remote.frame();
    CHECK(remote.loaded() == Names{"a.lua", "b.lua"});
}
