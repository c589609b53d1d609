// SPDX-License-Identifier: MIT
#include "daemon/core/allowed.h"

#include "daemon/core/config.h"

#include <doctest/doctest.h>

using namespace hyrax;

namespace {

Monitor monitor(Rect bounds, const char* name, const char* id, bool primary = false) {
    Rect work = bounds;
    work.height -= 40;
    return {.bounds = bounds, .work = work, .primary = primary, .name = name, .id = id};
}

const std::vector<Monitor> three{
    monitor({0, 0, 1920, 1080}, "\\\\.\\DISPLAY1", "\\\\?\\DISPLAY#A", true),
    monitor({-1280, 0, 1280, 1024}, "\\\\.\\DISPLAY2", "\\\\?\\DISPLAY#B"),
    monitor({1920, 0, 800, 600}, "\\\\.\\DISPLAY3", ""),
};

std::vector<std::string> names(const AllowedPlaces& places) {
    std::vector<std::string> result;
    for (const Monitor& each : places.monitors) {
        result.push_back(each.name.substr(each.name.size() - 1));
    }
    return result;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("allowed: everything without settings") {
    const AllowedPlaces places = allowed_places(three, {}, {});
    CHECK(places.monitors == three);
    CHECK(places.warning.empty());
    CHECK(allowed_places({}, {}, {}).monitors.empty());
    CHECK(allowed_places({}, {.monitors = {{"1"}}, .area = Rect{0, 0, 5, 5}}, {}).warning.empty());
}

TEST_CASE("allowed: monitors by number, name, identity and as the primary one") {
    CHECK(names(allowed_places(three, {.monitors = {{"2"}}}, {})) == Names{"2"});
    CHECK(names(allowed_places(three, {.monitors = {{"3"}, {"primary"}}}, {})) == Names{"1", "3"});
    CHECK(names(allowed_places(three, {.monitors = {{"\\\\.\\DISPLAY2"}}}, {})) == Names{"2"});
    CHECK(names(allowed_places(three, {.monitors = {{"\\\\?\\DISPLAY#B"}}}, {})) == Names{"2"});
}

TEST_CASE("allowed: the user's choice comes before the settings") {
    const AllowedSettings second{.monitors = {{"2"}}};
    CHECK(names(allowed_places(three, second, {{"\\\\?\\DISPLAY#A", true}})) == Names{"1", "2"});
    CHECK(names(allowed_places(three, {}, {{"\\\\.\\DISPLAY3", false}})) == Names{"1", "2"});
    // A choice for a monitor that is away waits for it.
    CHECK(names(allowed_places(three, second, {{"elsewhere", false}})) == Names{"2"});
}

TEST_CASE("allowed: an area cuts monitors and their floors") {
    const AllowedPlaces places = allowed_places(three, {.area = Rect{-100, 500, 600, 2000}}, {});
    REQUIRE(names(places) == Names{"1", "2"});
    CHECK(places.monitors[0].bounds == Rect{0, 500, 500, 580});
    CHECK(places.monitors[0].work == Rect{0, 500, 500, 540});
    CHECK(places.monitors[1].bounds == Rect{-100, 500, 100, 524});
    const Arena arena(places.monitors, FloorEdge::work_area);
    CHECK(arena.boxes().front() == Rect{0, 500, 500, 540});
}

TEST_CASE("allowed: where nothing is left, everything is allowed and the warning says why") {
    const AllowedPlaces nobody = allowed_places(three, {.monitors = {{"9"}}}, {});
    CHECK(nobody.monitors == three);
    CHECK(nobody.warning.contains("/overlay/allowed_monitors"));
    const AllowedPlaces nowhere =
        allowed_places(three, {.monitors = {{"2"}}, .area = Rect{5000, 0, 10, 10}}, {});
    CHECK(names(nowhere) == Names{"2"});
    CHECK(nowhere.warning.contains("/overlay/allowed_area"));
}

TEST_CASE("allowed: what config.json may say, and what it is told otherwise") {
    const auto told = [](const std::string& overlay) {
        const auto loaded = parse_config("{\"overlay\": {" + overlay + "}}", "config.json");
        return loaded ? "nothing" : loaded.error().message;
    };
    CHECK(told("\"allowed_monitors\": [1, \"primary\"], \"allowed_area\": []") == "nothing");
    CHECK(told("\"allowed_area\": [-5, 5, 1, 1]") == "nothing");
    CHECK(
        told("\"allowed_monitors\": [0]") ==
        "config.json:1:35: /overlay/allowed_monitors/0: must be a whole number from 1 to 100, got 0"
    );
    CHECK(
        told("\"allowed_monitors\": [true]") ==
        "config.json:1:35: /overlay/allowed_monitors/0: must be the number or the name of a "
        "monitor, got true"
    );
    CHECK(told("\"allowed_monitors\": [\"\"]").contains("/overlay/allowed_monitors/0: must"));
    CHECK(told("\"allowed_area\": [1, 2]").contains("must be [x, y, width, height] or [], got"));
    CHECK(told("\"allowed_area\": [0, 0, 0, 5]").contains("/overlay/allowed_area/2: must"));
    CHECK(told("\"allowed_area\": [0, 0, 5, \"5\"]").contains("/overlay/allowed_area/3: must"));
}
