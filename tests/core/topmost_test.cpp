// SPDX-License-Identifier: MIT
#include "daemon/core/topmost.h"

#include <doctest/doctest.h>

#include <vector>

using namespace hyrax;

namespace {

constexpr Ticks ms = ticks_per_ms;
constexpr Ticks second = ticks_per_second;

/// How often panes are raised until `end` when each check sees this.
int raises_until(TopmostKeeper& keeper, TopmostKeeper::Sight sight, Ticks end) {
    int raises = 0;
    while (keeper.due() <= end) {
        raises += keeper.check(sight, keeper.due()) ? 1 : 0;
    }
    return raises;
}

Frame frame_with_pet(Point at) {
    static const Image image(Size{100, 100});
    return {.sprites = {{image, at, {}}}};
}

}  // namespace

TEST_CASE("taskbars are what a monitor has beyond its work area") {
    const std::vector<Monitor> monitors{
        {.bounds = {0, 0, 1920, 1080}, .work = {0, 0, 1920, 1040}, .primary = true, .name = "a"},
        {.bounds = {1920, 0, 800, 600}, .work = {1920, 0, 800, 600}, .name = "b"},
    };
    CHECK_FALSE(reaches_taskbars(frame_with_pet({100, 940}), monitors));
    CHECK(reaches_taskbars(frame_with_pet({100, 941}), monitors));
    CHECK_FALSE(reaches_taskbars(frame_with_pet({2000, 550}), monitors));
    CHECK_FALSE(reaches_taskbars(frame_with_pet({100, 2000}), monitors));
    CHECK_FALSE(reaches_taskbars({}, monitors));
}

TEST_CASE("nothing is checked without a reason") {
    TopmostKeeper keeper;
    CHECK(keeper.due() == never);
    keeper.set_exposed(false, 0);
    CHECK(keeper.due() == never);
}

TEST_CASE("a new front window: a check at once and one in 250 ms") {
    TopmostKeeper keeper;
    keeper.hint(1000 * ms);
    CHECK(keeper.due() == 1000 * ms);
    CHECK(keeper.check({.buried = true}, 1000 * ms));
    CHECK(keeper.due() == 1250 * ms);
    CHECK_FALSE(keeper.check({.buried = false}, 1250 * ms));
    CHECK(keeper.due() == never);
}

TEST_CASE("over a taskbar: a check each second, and none when that ends") {
    TopmostKeeper keeper;
    keeper.set_exposed(true, 0);
    CHECK_FALSE(keeper.check({}, 0));
    CHECK(keeper.due() == second);
    keeper.set_exposed(true, 500 * ms);
    CHECK(keeper.due() == second);
    CHECK(keeper.check({.buried = true}, second));
    keeper.set_exposed(false, second);
    CHECK(keeper.due() == never);
}

TEST_CASE("nothing goes above a menu or flyout") {
    TopmostKeeper keeper;
    keeper.hint(0);
    CHECK(raises_until(keeper, {.buried = true, .flyout_in_front = true}, second) == 0);
}

TEST_CASE("three lost fights in five seconds end the fight for a minute") {
    TopmostKeeper keeper;
    keeper.set_exposed(true, 0);
    CHECK(raises_until(keeper, {.buried = true}, 59 * second) == 3);
    CHECK(raises_until(keeper, {.buried = true}, 70 * second) == 3);
}

TEST_CASE("a taskbar that comes up now and then is no fight") {
    TopmostKeeper keeper;
    int raises = 0;
    for (int i = 0; i < 20; ++i) {
        const Ticks now = i * 6 * second;
        keeper.hint(now);
        raises += keeper.check({.buried = true}, now) ? 1 : 0;
        keeper.check({.buried = false}, now + 250 * ms);
    }
    CHECK(raises == 20);
}
