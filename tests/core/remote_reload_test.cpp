// SPDX-License-Identifier: MIT
// Texts that change while the process runs, and which of them may run.
#include "tests/core/remote_scripts.h"

#include <algorithm>

using namespace hyrax;

TEST_CASE("everything loaded anew lets a script in again, but not after three kills") {
    Remote remote;
    for (int i = 1; i <= 3; ++i) {
        remote.host.renew();
        remote.host.load(three);
        remote.frame();
        CHECK(std::ranges::count(remote.loaded(), "a.lua") == 1);
        const std::string line = remote.hang(0);
        CHECK(line.ends_with("stays out until its text changes") == (i == 3));
        CHECK(remote.given_up == (i == 3 ? Names{"a.lua"} : Names{}));
        remote.process.answer();
        remote.frame();
        remote.process.answer();
    }
    remote.host.renew();
    remote.host.load(three);
    remote.frame();
    CHECK(std::ranges::count(remote.loaded(), "a.lua") == 0);
}

TEST_CASE("the text before stands in for one that hangs or fails") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    remote.process.answer();
    remote.frame();
    remote.host.load({{"a.lua", "bad"}, {"b.lua", "b"}, {"c.lua", "c"}});
    SUBCASE("it hangs") {
        remote.process.answer();
        remote.frame();
        CHECK(remote.hang(0).ends_with("; its text before this one goes on"));
    }
    SUBCASE("it fails, and later the process dies") {
        remote.process.answer();
        remote.frame();
        ScriptOutput said;
        said.ended = {0};
        remote.process.answer(said);
        remote.frame();
        remote.process.be_killed();
        remote.frame();
    }
    REQUIRE(remote.process.heard_of<ScriptSource>().size() == 3);
    CHECK(remote.process.heard_of<ScriptSource>()[0].text == "a");
    // It is mended.
    remote.process.answer();
    remote.frame();
    remote.host.load({{"a.lua", "better"}, {"b.lua", "b"}, {"c.lua", "c"}});
    remote.process.answer();
    remote.frame();
    CHECK(remote.process.heard_of<ScriptSource>().at(3).text == "better");
}

TEST_CASE("scripts that are replaced while they work are heard, then replaced") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    remote.host.load({{"d.lua", "d"}});
    remote.frame();
    CHECK(remote.loaded().size() == 3);
    ScriptOutput said;
    said.listening.add(EventKind::land);
    remote.process.answer(said);
    const auto output = remote.frame();
    REQUIRE(output);
    CHECK(output->listening == said.listening);
    CHECK(output->next_wake == 0);
    CHECK(remote.loaded().back() == "d.lua");
    CHECK(remote.process.starts == 1);
}

TEST_CASE("what a script keeps does not let it in again") {
    Remote remote;
    remote.host.load(three);
    remote.frame();
    remote.process.answer();
    remote.frame();
    remote.hang(1);
    std::vector<ScriptSource> again = three;
    again[1].store = {{"n", {true}}};
    remote.host.load(again);
    remote.process.answer();
    remote.frame();
    CHECK(std::ranges::count(remote.loaded(), "b.lua") == 0);
}
