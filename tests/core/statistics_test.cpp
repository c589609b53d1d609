// SPDX-License-Identifier: MIT
#include "daemon/core/statistics.h"

#include "daemon/core/files.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

using namespace hyrax;

namespace {

Statistics some() {
    return {
        .now = 7 * ticks_per_second,
        .pets = 3,
        .moving = 2,
        .desktop =
            {
                .overlay =
                    {.frames = 11, .presents = 12, .bytes = 13, .resizes = 14, .failures = 15},
                .wakeups = 16,
                .timer_wakeups = 17,
                .first_frame = 2 * ticks_per_second,
            },
        .process =
            {
                .gdi_objects = 18,
                .user_objects = 19,
                .handles = 20,
                .private_bytes = 5'000'000'000,
                .resident_bytes = 22,
            },
    };
}

}  // namespace

TEST_CASE("statistics are one line of JSON with every figure") {
    const std::string line = json_line(some(), 1000.5);
    CHECK(line.find('\n') == line.size() - 1);
    const nlohmann::json expected{
        {"time", 1000.5},
        {"first_frame", 995.5},
        {"pets", 3},
        {"moving", 2},
        {"frames", 11},
        {"presents", 12},
        {"presented_bytes", 13},
        {"resizes", 14},
        {"failures", 15},
        {"wakeups", 16},
        {"timer_wakeups", 17},
        {"gdi_objects", 18},
        {"user_objects", 19},
        {"handles", 20},
        {"private_bytes", 5'000'000'000},
        {"resident_bytes", 22},
    };
    CHECK(nlohmann::json::parse(line) == expected);
}

TEST_CASE("before the first frame there is no time of it") {
    Statistics none = some();
    none.desktop.first_frame = never;
    CHECK(nlohmann::json::parse(json_line(none, 1000.5)).at("first_frame").is_null());
}

TEST_CASE("statistics are added to what the file holds") {
    const TemporaryFolder folder;
    const auto file = folder.path() / "statistics.jsonl";
    REQUIRE(append_statistics(file, some()));
    REQUIRE(append_statistics(file, some()));
    const std::string text = folder.read("statistics.jsonl");
    CHECK(std::ranges::count(text, '\n') == 2);
    // 2020 to 2100: the lines tell the time of day.
    const double time = nlohmann::json::parse(text.substr(0, text.find('\n'))).at("time");
    CHECK(time > 1.5e9);
    CHECK(time < 4.1e9);
    const Result<void> nowhere = append_statistics(folder.path() / "no" / "file", some());
    REQUIRE_FALSE(nowhere);
    CHECK(nowhere.error().message.contains("cannot be written"));
}
