// SPDX-License-Identifier: MIT
// What a developer types into a script that runs.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace hyrax;

namespace {

/// A script, and what it answers.
struct Talk {
    explicit Talk(const std::string& text = "", const ScriptLimits& limits = {}) : world(limits) {
        world.load(text);
    }

    std::vector<Evaluated> ask(std::string text, std::string script = "test.lua") {
        world.world.evaluations = {{++last_id, std::move(script), std::move(text)}};
        world.run();
        world.world.evaluations.clear();
        return world.last.evaluated;
    }
    std::string value(std::string text) {
        const std::vector<Evaluated> answers = ask(std::move(text));
        REQUIRE(answers.size() == 1);
        CHECK(answers[0].id == last_id);
        CHECK_MESSAGE(answers[0].good, answers[0].text);
        return answers[0].text;
    }
    std::string error(std::string text, std::string script = "test.lua") {
        const std::vector<Evaluated> answers = ask(std::move(text), std::move(script));
        REQUIRE(answers.size() == 1);
        CHECK_FALSE_MESSAGE(answers[0].good, answers[0].text);
        return answers[0].text;
    }

    FakeWorld world;
    std::uint64_t last_id = 0;
};

}  // namespace

TEST_CASE("values are shown as people read them") {
    Talk talk;
    CHECK(talk.value("1 + 2") == "3");
    CHECK(talk.value("1, nil, true, 0.5") == "1, nil, true, 0.5");
    CHECK(talk.value(R"("a\n\"b\"\0")") == R"("a\n\"b\"\x00")");
    CHECK(talk.value("{}") == "{}");
    CHECK(
        talk.value("{1, 'two', x = {3}, y = {}, ['a b'] = true, [10] = 5}") ==
        R"({1, "two", ["a b"] = true, [10] = 5, x = {...}, y = {}})"
    );
    CHECK(talk.value("").empty());
    CHECK(talk.value("-- nothing").empty());
    CHECK(
        talk.value("setmetatable({}, {__tostring = function() return 'I am it' end})") == "I am it"
    );
    CHECK(talk.value("hyrax.spawn{tag = 'x'}").starts_with("pet"));
    CHECK(talk.value("print").starts_with("function"));
}

TEST_CASE("answers have an end, however much there is to show") {
    Talk talk;
    CHECK(talk.value("('x'):rep(5000)").size() < 1'100);
    const std::string many = talk.value(
        "(function() local t = {} for i = 1, 30000 do t[i] = i end t.last = 1 return t end)()"
    );
    CHECK(many.starts_with("{1, 2, 3, "));
    CHECK(many.ends_with("...}"));
    CHECK(many.size() < 1'000);
    CHECK(
        talk.value("table.unpack((function() local t = {} for i = 1, 100 do t[i] = ('y'):rep(900) "
                   "end return t end)())")
            .size() <= 8'000
    );
}

TEST_CASE("globals are those of the script, and its state goes on") {
    Talk talk("count = 3 local hidden = 5");
    CHECK(talk.value("count") == "3");
    CHECK(talk.value("hidden") == "nil");
    CHECK(talk.value("count = count + 1").empty());
    CHECK(talk.value("return count") == "4");
    CHECK(talk.value("hyrax.every(0.1, function() count = count + 1 end)") != "");
    talk.world.play(0.35);
    CHECK(talk.value("count") == "7");
}

TEST_CASE("errors are told with their line, and not in the log") {
    Talk talk;
    CHECK(
        talk.error("local x = 1\nlocal y\ny.z = x") ==
        "eval:3: attempt to index a nil value (local 'y')"
    );
    CHECK(talk.error("for").ends_with("near <eof>"));
    CHECK(talk.error("1 +* 2") == "eval:1: unexpected symbol near '1'");
    CHECK(talk.error("error({})") == "the error object is a table value");
    CHECK(talk.error("hyrax.pet_of_mine()").contains("eval:1: "));
    CHECK(talk.error("\x1BLua") != "");
    CHECK(talk.world.errors().empty());
    for (int i = 0; i < 100; ++i) {
        talk.error("error 'again'");
    }
    CHECK(talk.value("1") == "1");  // Not paused, as a script with so many errors would be.
}

TEST_CASE("what is printed is part of the answer") {
    Talk talk;
    const std::vector<Evaluated> answers = talk.ask("print('a', 1) hyrax.log.warn('b') return 2");
    REQUIRE(answers.size() == 1);
    CHECK(answers[0].text == "2");
    CHECK(answers[0].printed == "a 1\nb\n");
    CHECK(talk.world.said() == "a 1\n");
}

TEST_CASE("what waits answers when it has waited") {
    Talk talk;
    CHECK(talk.ask("print 'begins' local s = hyrax.wait(0.5) return s >= 0.5").empty());
    talk.world.play(0.3);
    CHECK(talk.world.last.evaluated.empty());
    CHECK(talk.value("1") == "1");
    std::vector<Evaluated> answers;
    for (int i = 0; i < 60 && answers.empty(); ++i) {
        talk.world.play(1.0 / 60);
        answers = talk.world.last.evaluated;
    }
    REQUIRE(answers.size() == 1);
    CHECK(answers[0].id == 1);
    CHECK(answers[0].text == "true");
    CHECK(answers[0].printed == "begins\n");

    // Nobody may listen any more: an error is also in the log.
    CHECK(talk.ask("hyrax.wait(0.1) error('late')").empty());
    talk.world.play(0.2);
    CHECK(talk.world.errors().contains("eval:1: late"));
}

TEST_CASE("what never ends ends the script, and the answer says so") {
    Talk talk("x = 1");
    CHECK(talk.ask("hyrax.wait(5)").empty());
    const std::vector<Evaluated> answers = talk.ask("while true do end");
    REQUIRE(answers.size() == 2);
    CHECK(answers[1].id == 2);
    CHECK_FALSE(answers[1].good);
    CHECK(answers[1].text.starts_with("test.lua: eval:1: used more than "));
    CHECK(answers[0].id == 1);
    CHECK_FALSE(answers[0].good);
    CHECK(talk.error("x") == "test.lua does not run");
}

TEST_CASE("only scripts that run are asked") {
    Talk talk("error('no')");
    CHECK(talk.error("1") == "test.lua does not run");
    CHECK(talk.error("1", "other.lua") == "other.lua does not run");

    Talk waiting;
    CHECK(waiting.ask("hyrax.wait(5)").empty());
    waiting.world.load("", "other.lua");
    REQUIRE(waiting.world.last.evaluated.size() == 1);
    CHECK(waiting.world.last.evaluated[0].text == "test.lua: was unloaded");
}

TEST_CASE("the same text starts again with another turn") {
    FakeWorld world;
    ScriptSource source{.name = "test.lua", .text = "print 'starts'"};
    world.load({source});
    world.load({source});
    CHECK(world.said() == "starts\n");
    source.turn = 1;
    world.load({source});
    CHECK(world.said() == "starts\nstarts\n");
}
