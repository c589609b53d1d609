// SPDX-License-Identifier: MIT
#include "daemon/core/remembered.h"

#include "daemon/core/wall_time.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

using namespace hyrax;

TEST_CASE("remembered: what was written is read again") {
    const Remembered all{
        .hidden = true,
        .hidden_until = 1'767'268'800,
        .quiet = false,
        .click_through = true,
        .monitors = {{"\\\\?\\DISPLAY#A \"x\"", false}, {"b", true}},
        .scripts_off = {"fountain.lua", "examples/j\xC3\xA4.lua"},
        .plugins = {{"catch", true}, {"weather", false}},
        .granted = {{"weather", {"pets.others", "wind"}}, {"none", {}}},
        .greeted = true,
    };
    for (const Remembered& one : {all, Remembered{}}) {
        const Result<Remembered> again = parse_remembered(text_of(one), "state.json");
        REQUIRE_MESSAGE(again, again.error().message);
        CHECK(*again == one);
    }
}

TEST_CASE("remembered: a missing file is an empty memory, a broken one says what is broken") {
    const TemporaryFolder folder;
    const auto file = folder.path() / "new" / "folder" / "state.json";
    REQUIRE(load_remembered(file));
    CHECK(*load_remembered(file) == Remembered{});
    REQUIRE(save_remembered(file, {.hidden = true}));
    REQUIRE(load_remembered(file));
    CHECK(load_remembered(file)->hidden);
    CHECK_FALSE(std::filesystem::exists(folder.path() / "new" / "folder" / "state.json.new"));

    for (const char* text :
         {"",
          "[",
          "{\"hidden\": 1}",
          "[]",
          "{\"scripts_off\": [\"../x\"]}",
          "{\"plugins\": {\"a\": 1}}",
          "{\"granted\": {\"a\": true}}",
          "{\"granted\": {\"a\": [1]}}",
          "{\"monitors\": 5}",
          "{\"monitors\": {\"a\": 1}}",
          "{\"click_through\": 1}",
          "{\"hidden_until\": -1}",
          "{\"hidden_until\": 1e300}"}) {
        CAPTURE(text);
        const Result<Remembered> broken = parse_remembered(text, "state.json");
        REQUIRE_FALSE(broken);
        CHECK(broken.error().message.starts_with("state.json:"));
    }
    // What a later program adds is no reason to forget everything.
    REQUIRE(parse_remembered("{\"quiet\": true, \"later\": {}}", "state.json"));
}

TEST_CASE("wall time: tomorrow begins at six, at least an hour from now") {
    const auto at = [](int hour, int minute) { return WallTime{hour * 3600 + minute * 60, 0}; };
    CHECK(seconds_until_tomorrow(at(23, 50)) == 6 * 3600 + 600);
    CHECK(seconds_until_tomorrow(at(1, 0)) == 5 * 3600);
    CHECK(seconds_until_tomorrow(at(5, 30)) == 24 * 3600 + 1800);
    CHECK(seconds_until_tomorrow(at(6, 0)) == 24 * 3600);
    CHECK(seconds_until_tomorrow({-3600, 0}) == 7 * 3600);
    // At noon UTC it is one in the morning, 13 hours east of Greenwich.
    CHECK(seconds_until_tomorrow({12 * 3600, 13 * 3600}) == 5 * 3600);
}

TEST_CASE("wall time: hours and minutes of the place") {
    CHECK(clock_text({0, 3600}, 1'767'268'800) == "13:00");
    CHECK(clock_text({0, -1800}, 1'767'268'800 + 61) == "11:31");
    CHECK(clock_text({0, -3600}, 60) == "23:01");
}
