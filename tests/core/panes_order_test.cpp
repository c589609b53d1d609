// SPDX-License-Identifier: MIT
// Windows that show their panes one after the other, and go on where screens change: what is seen
// meanwhile.
#include "daemon/core/panes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

using namespace hyrax;

namespace {

constexpr Rect screen{0, 0, 1920, 1080};
constexpr int side = 96;
constexpr Ticks frame_time = ticks_per_second / 60;

/// What a window shows: the sprites, as they stood then, within its area.
struct Shown {
    Rect area;
    std::vector<Rect> sprites;
};

/// All windows, by slot.
using Windows = std::map<std::size_t, Shown>;

bool sees(const Windows& windows, std::size_t sprite) {
    return std::ranges::any_of(windows, [sprite](const auto& window) {
        const Shown& shown = window.second;
        return shown.sprites.size() > sprite && shown.area.contains(shown.sprites[sprite]);
    });
}

/// Shows the panes in their order. False if a sprite is nowhere whole in between.
bool show(Windows& windows, const std::vector<Pane>& panes, const std::vector<Rect>& sprites) {
    bool all = true;
    for (const Pane& pane : panes) {
        windows[pane.slot] = {pane.area, sprites};
        for (std::size_t i = 0; i < sprites.size(); ++i) {
            all = all && sees(windows, i);
        }
    }
    std::erase_if(windows, [&](const auto& window) {
        return std::ranges::find(panes, window.first, &Pane::slot) == panes.end();
    });
    return all;
}

struct Runner {
    double x;
    double y;
    double vx;
    double vy;

    void step() {
        x += vx;
        y += vy;
        vx = x < 0 || x > screen.width - side ? -vx : vx;
        vy = y < 0 || y > screen.height - side ? -vy : vy;
        x = std::clamp(x, 0.0, double{screen.width - side});
        y = std::clamp(y, 0.0, double{screen.height - side});
    }
    Rect box() const { return {int(std::lround(x)), int(std::lround(y)), side, side}; }
};

}  // namespace

TEST_CASE("no pet is nowhere while panes part, meet and slide") {
    std::mt19937 random(7);
    const auto below = [&random](double most) {
        return std::uniform_real_distribution<double>(0.0, most)(random);
    };
    const std::vector<Monitor> monitors{{.bounds = screen, .work = screen, .name = "main"}};
    int divided = 0;
    int joined = 0;
    for (int scene = 0; scene < 60; ++scene) {
        CAPTURE(scene);
        std::vector<Runner> runners;
        for (int i = 0; i < 2 + scene % 7; ++i) {
            runners.push_back({below(1800), below(900), below(50) - 25, below(50) - 25});
        }
        std::vector<Pane> panes;
        Windows windows;
        for (int frame = 0; frame < 1200; ++frame) {
            std::vector<Rect> sprites;
            for (Runner& runner : runners) {
                runner.step();
                sprites.push_back(runner.box());
            }
            std::vector<Pane> next = plan_panes({monitors, sprites}, panes, frame * frame_time);
            sort_for_showing(next, panes);
            divided += next.size() > panes.size() ? 1 : 0;
            joined += next.size() < panes.size() ? 1 : 0;
            panes = std::move(next);
            const bool seen = show(windows, panes, sprites);
            CAPTURE(frame);
            REQUIRE((seen || frame == 0));
        }
    }
    CHECK(divided > 200);
    CHECK(joined > 200);
}

TEST_CASE("a window stays where it is when its screen changes around it") {
    const std::vector<Rect> sprites{{500, 600, side, side}, {1700, 600, side, side}};
    const Rect narrow{0, 0, 1280, 900};
    const std::vector<Monitor> before{
        {.bounds = screen, .work = screen, .primary = true, .name = "one"}
    };
    const std::vector<Monitor> after{
        {.bounds = narrow, .work = narrow, .primary = true, .name = "one"}
    };

    const std::vector<Pane> both = plan_panes({before, sprites}, {}, 0);
    REQUIRE(both.size() == 2);
    const std::vector<Pane> one = plan_panes({after, sprites}, both, frame_time);
    REQUIRE(one.size() == 1);
    CHECK(one[0].slot == both[0].slot);
    CHECK(one[0].area == both[0].area);
    CHECK(one[0].monitor == narrow);
    const std::vector<Pane> again = plan_panes({before, sprites}, one, 2 * frame_time);
    REQUIRE(again.size() == 2);
    CHECK(again[0].slot == both[0].slot);
    CHECK(again[0].area == both[0].area);
}
