// SPDX-License-Identifier: MIT
// hyrax.test: the tests that scripts bring.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <string>

using namespace hyrax;

namespace {

FakeWorld tested(const std::string& text, double seconds = 10.0) {
    FakeWorld world;
    world.load({{.name = "test.lua", .text = text, .testing = true}});
    world.play(seconds);
    return world;
}

// The problem of the first case.
std::string problem(const std::string& body) {
    const FakeWorld world = tested("hyrax.test.case('x', function() " + body + " end)");
    REQUIRE(world.tests.size() >= 1);
    CHECK(world.last.open_tests == 0);
    return world.tests[0].problem;
}

}  // namespace

TEST_CASE("cases run one after the other in the pets' time, each without pets of the one before") {
    const FakeWorld world = tested(R"(
        local test = hyrax.test
        test.case("first", function()
            local p = hyrax.spawn{ x = 0, y = 0 }
            test.advance(1.5)
            test.expect(p.y > 0, "it falls")
            test.near(1, 1 + 1e-9)
        end)
        test.case("second", function() test.equal(#hyrax.pets(), 0) end)
        test.case("third", function() test.equal(1 + 1, 3, "sum") end)
        test.case("fourth", function() test.fails(function() error("boom") end, "boom") end)
    )");
    REQUIRE(world.tests.size() == 4);
    CHECK(world.tests[0].script == "test.lua");
    CHECK(world.tests[0].name == "first");
    CHECK(world.tests[0].problem == "");
    CHECK(world.tests[0].seconds >= 1.5);
    CHECK(world.tests[1].problem == "");
    CHECK(world.tests[2].problem == "test.lua:10: 'sum': expected 3, got 2");
    CHECK(world.tests[3].problem == "");
    CHECK(world.last.open_tests == 0);
}

TEST_CASE("what fails a case") {
    CHECK(problem("hyrax.test.expect(false)").contains("expected something true, got false"));
    CHECK(problem("hyrax.test.expect(1 > 2, 'order')").contains("'order': expected something"));
    CHECK(problem("hyrax.test.near(1, 2, 0.5)").contains("expected 2 +- 0.5, got 1"));
    CHECK(problem("hyrax.test.fails(function() end)").contains("expected an error, got none"));
    CHECK(problem("hyrax.test.fails(error, 'x')").contains("expected an error with 'x'"));
    CHECK(problem("hyrax.spwan()").contains("attempt to call a nil value"));
    CHECK(problem("hyrax.after(0.1, function() error('later') end) hyrax.test.advance(0.5)")
              .contains("later"));
    CHECK(problem("while true do end").contains("stopped"));
    CHECK(problem("hyrax.test.equal('a', 'a')") == "");
}

TEST_CASE("errors outside of cases, and the end of the script, are failures of their own") {
    FakeWorld world = tested("hyrax.test.case('x', function() end) error('main')");
    REQUIRE(world.tests.size() == 1);
    CHECK(world.tests[0].name == "outside of cases");
    CHECK(world.tests[0].problem == "test.lua:1: main");
    world = tested("while true do end");
    REQUIRE(world.tests.size() == 1);
    CHECK(world.tests[0].problem.contains("work units"));
}

TEST_CASE("without testing there is no hyrax.test") {
    CHECK(errors_of("assert(hyrax.test == nil)") == "");
}
