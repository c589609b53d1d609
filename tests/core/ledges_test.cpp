// SPDX-License-Identifier: MIT
#include "daemon/core/ledges.h"

#include "tests/core/engine_world.h"
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace hyrax;

namespace {

const std::vector<Monitor> one_monitor{
    {.bounds = {0, 0, 1000, 800}, .work = {0, 0, 1000, 760}, .primary = true, .name = {}}
};

DesktopWindow window(std::uint64_t id, Rect bounds) {
    DesktopWindow made;
    made.id = id;
    made.bounds = bounds;
    return made;
}

std::vector<Ledge> tops(const std::vector<DesktopWindow>& windows, LedgeMode mode) {
    std::vector<Ledge> found;
    for (const LedgeSegment& segment : ledges_of(windows, one_monitor, mode)) {
        found.push_back(segment.ledge);
    }
    return found;
}

// Without any list of intervals: pixel by pixel.
bool is_ledge(
    const std::vector<DesktopWindow>& windows,
    const std::vector<Monitor>& monitors,
    std::size_t index,
    int x
) {
    const Point pixel{x, windows[index].bounds.y};
    for (std::size_t above = 0; above < index; ++above) {
        const DesktopWindow& cover = windows[above];
        if (cover.visible && cover.solid && cover.bounds.contains(pixel)) {
            return false;
        }
    }
    return windows[index].bounds.contains(pixel) &&
           std::ranges::any_of(monitors, [pixel](const Monitor& monitor) {
               return monitor.work.contains(pixel);
           });
}

}  // namespace

TEST_CASE("ledges: none when off, the foreground window's alone when active") {
    std::vector<DesktopWindow> windows{
        window(1, {0, 500, 100, 100}), window(2, {200, 300, 400, 200})
    };
    windows[1].active = true;
    CHECK(tops(windows, LedgeMode::off).empty());
    CHECK(tops(windows, LedgeMode::active) == std::vector<Ledge>{{200, 600, 300}});
    CHECK(tops(windows, LedgeMode::all) == std::vector<Ledge>{{0, 100, 500}, {200, 600, 300}});
}

TEST_CASE("ledges: a window above covers, one below does not") {
    const DesktopWindow wide = window(1, {100, 400, 600, 200});
    const DesktopWindow high = window(2, {300, 200, 100, 500});
    CHECK(
        tops({high, wide}, LedgeMode::all) ==
        std::vector<Ledge>{{300, 400, 200}, {100, 300, 400}, {400, 700, 400}}
    );
    CHECK(
        tops({wide, high}, LedgeMode::all) == std::vector<Ledge>{{100, 700, 400}, {300, 400, 200}}
    );
}

TEST_CASE("ledges: who is not seen covers nothing and carries nobody") {
    const DesktopWindow below = window(1, {100, 400, 600, 200});
    DesktopWindow above = window(2, {0, 100, 1000, 500});
    above.visible = false;
    CHECK(tops({above, below}, LedgeMode::all) == std::vector<Ledge>{{100, 700, 400}});
    above.visible = true;
    above.solid = false;
    CHECK(tops({above, below}, LedgeMode::all) == std::vector<Ledge>{{100, 700, 400}});
}

TEST_CASE("ledges: bars, maximised and full-screen windows cover and carry nobody") {
    const DesktopWindow below = window(1, {100, 400, 600, 200});
    DesktopWindow bar = window(2, {200, 380, 100, 40});
    bar.has_caption = false;
    CHECK(
        tops({bar, below}, LedgeMode::all) == std::vector<Ledge>{{100, 200, 400}, {300, 700, 400}}
    );
    DesktopWindow maximised = window(3, {0, 0, 1000, 760});
    maximised.maximised = true;
    CHECK(tops({maximised, below}, LedgeMode::all).empty());
    CHECK(tops({window(4, {-10, -10, 1020, 820}), below}, LedgeMode::all).empty());
}

TEST_CASE("ledges: small windows carry nobody") {
    CHECK(tops({window(1, {100, 400, 63, 200})}, LedgeMode::all).empty());
    CHECK(tops({window(1, {100, 400, 64, 31})}, LedgeMode::all).empty());
    CHECK(tops({window(1, {100, 400, 64, 32})}, LedgeMode::all).size() == 1);
}

TEST_CASE("ledges: the work area bounds them, and a seam of monitors does not") {
    CHECK(
        tops({window(1, {-50, 400, 2000, 100})}, LedgeMode::all) ==
        std::vector<Ledge>{{0, 1000, 400}}
    );
    CHECK(tops({window(1, {100, 760, 200, 100})}, LedgeMode::all).empty());
    const std::vector<DesktopWindow> across{window(1, {900, 400, 200, 100})};
    const std::vector<Monitor> two{monitor({0, 0, 1000, 800}), monitor({1000, 0, 1000, 800})};
    const std::vector<LedgeSegment> found = ledges_of(across, two, LedgeMode::all);
    REQUIRE(found.size() == 1);
    CHECK(found[0] == LedgeSegment{{900, 1100, 400}, 1, {900, 400, 200, 100}});
}

TEST_CASE("ledges: the topmost 64 windows count") {
    std::vector<DesktopWindow> windows;
    for (int i = 0; i < 100; ++i) {
        windows.push_back(window(static_cast<std::uint64_t>(i), {100 + i, 700 - i, 100, 50}));
    }
    const std::vector<LedgeSegment> found = ledges_of(windows, one_monitor, LedgeMode::all);
    CHECK(found.size() <= 64U * 2U);
    CHECK(std::ranges::all_of(found, [](const LedgeSegment& one) { return one.window < 64; }));
    CHECK(found.back().window == 63);
}

TEST_CASE("ledges: any windows, pixel by pixel") {
    int pixels = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        std::vector<Monitor> monitors{monitor({0, 0, 400, 300}), monitor({400, 50, 300, 300})};
        monitors[0].work.height -= 20;
        std::vector<DesktopWindow> windows;
        const int count = random.whole(0, 12);
        for (int i = 0; i < count; ++i) {
            windows.push_back(window(
                static_cast<std::uint64_t>(i),
                {random.whole(-100, 650),
                 random.whole(-50, 330),
                 random.whole(64, 300),
                 random.whole(32, 200)}
            ));
            windows.back().visible = !random.one_in(6);
            windows.back().solid = !random.one_in(8);
        }
        const std::vector<LedgeSegment> found = ledges_of(windows, monitors, LedgeMode::all);
        int wrong = 0;
        for (std::size_t i = 0; i < windows.size(); ++i) {
            for (int x = -100; x < 1000; ++x) {
                const bool expected =
                    windows[i].visible && windows[i].solid && is_ledge(windows, monitors, i, x);
                const auto times = std::ranges::count_if(found, [&](const LedgeSegment& one) {
                    return one.window == i && x >= one.ledge.left && x < one.ledge.right;
                });
                wrong += times == (expected ? 1 : 0) ? 0 : 1;
                pixels += expected ? 1 : 0;
            }
        }
        CHECK(wrong == 0);
    }
    CHECK(pixels > 10'000);
}
