// SPDX-License-Identifier: MIT
// What the overlay costs at any size of desktop: areas, bytes and resizes on recorded paths.
#include "daemon/core/dirty.h"
#include "daemon/core/panes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace hyrax;

namespace {

constexpr int cell = 128;
constexpr int fps = 60;

/// Three of one size in a row, the second one primary at 0, 0.
std::vector<Monitor> three_in_a_row(int width, int height) {
    std::vector<Monitor> monitors;
    for (int i = -1; i <= 1; ++i) {
        const Rect bounds{i * width, 0, width, height};
        monitors.push_back({.bounds = bounds, .work = bounds, .primary = i == 0, .name = {}});
    }
    return monitors;
}

Sprite sprite(std::uint32_t index, Point at) {
    static const Image image(Size{cell, cell});
    return {image, at, {index, 1}};
}

long long area_of(std::span<const Rect> rects) {
    long long sum = 0;
    for (const Rect& rect : rects) {
        sum += rect.area();
    }
    return sum;
}

/// Pets that fly in straight lines and are reflected at the edges of the desktop.
class Flock {
public:
    Flock(std::size_t count, Rect desktop, double speed) : desktop_(desktop), random_(5) {
        std::uniform_real_distribution<double> part(0.0, 1.0);
        for (std::size_t i = 0; i < count; ++i) {
            const double angle = 6.283 * part(random_);
            flyers_.push_back({
                .x = desktop.x + part(random_) * (desktop.width - cell),
                .y = desktop.y + part(random_) * (desktop.height - cell),
                .vx = speed * std::cos(angle) / fps,
                .vy = speed * std::sin(angle) / fps,
            });
        }
    }

    Frame next() {
        Frame frame;
        for (std::size_t i = 0; i < flyers_.size(); ++i) {
            Flyer& flyer = flyers_[i];
            move(flyer.x, flyer.vx, desktop_.x, desktop_.right() - cell);
            move(flyer.y, flyer.vy, desktop_.y, desktop_.bottom() - cell);
            frame.sprites.push_back(sprite(
                static_cast<std::uint32_t>(i),
                {static_cast<int>(std::lround(flyer.x)), static_cast<int>(std::lround(flyer.y))}
            ));
        }
        return frame;
    }

private:
    struct Flyer {
        double x, y, vx, vy;
    };

    static void move(double& at, double& v, double low, double high) {
        at += v;
        if (at < low || at > high) {
            v = -v;
            at = std::clamp(at, low, high);
        }
    }

    Rect desktop_;
    std::mt19937 random_;
    std::vector<Flyer> flyers_;
};

/// The whole overlay on paper: what it presents in a frame.
struct Paper {
    std::vector<Pane> panes;
    Frame shown;
    int anew = 0;     ///< Panes that were drawn as a whole because their area changed,
    int resizes = 0;  ///< and those of them that changed their size.

    /// [px]
    long long present(const Frame& frame, std::span<const Monitor> monitors, Ticks now) {
        std::vector<Pane> next = plan_panes({monitors, places_of(frame)}, panes, now);
        const std::vector<Rect> changed = changed_places(shown, frame);
        long long presented = 0;
        for (const Pane& pane : next) {
            const auto before = std::ranges::find(panes, pane.slot, &Pane::slot);
            if (before == panes.end() || before->area != pane.area) {
                const bool known = before != panes.end();
                anew += known ? 1 : 0;
                resizes += known && (before->area.width != pane.area.width ||
                                     before->area.height != pane.area.height)
                               ? 1
                               : 0;
                presented += pane.area.area();
            } else {
                const PresentCost cost{.most_calls = calls_for_each_of(next.size())};
                presented += area_of(dirty_clusters(changed, pane.area, cost));
            }
        }
        panes = std::move(next);
        shown = frame;
        return presented;
    }
};

}  // namespace

TEST_CASE("two pets ten thousand pixels apart present their own pixels, not what lies between") {
    const std::vector<Monitor> monitors = three_in_a_row(3840, 2160);
    Paper paper;
    std::vector<long long> presented;
    for (int i = 0; i < 10 * fps; ++i) {
        const int step = (i * 11) % 300;
        const Frame frame{{sprite(1, {-3800 + step, 900}), sprite(2, {6300 + step, 900})}};
        presented.push_back(paper.present(frame, monitors, i * ticks_per_second / fps));
    }
    // Frames that resize present a pane; there are few of them, and all others stay at the pets.
    const auto small =
        std::ranges::count_if(presented, [](long long px) { return px <= 4LL * 2 * cell * cell; });
    CHECK(small >= 10 * fps - 1 - paper.anew);
    CHECK(*std::ranges::max_element(presented) < 4'000'000);
}

TEST_CASE("what is covered and presented grows with the pets, not with the desktop") {
    for (const auto& [width, height] : {std::pair{1920, 1080}, {3840, 2160}, {7680, 4320}}) {
        CAPTURE(width);
        const std::vector<Monitor> monitors = three_in_a_row(width, height);
        // Six pets are never more clusters than there are calls.
        Flock flock(6, {-width, 0, 3 * width, height}, 300.0);
        Paper paper;
        long long in_dirty_frames = 0;
        int dirty_frames = 0;
        long long covered = 0;
        for (int i = 0; i < 20 * fps; ++i) {
            const int anew = paper.anew;
            const std::size_t panes = paper.panes.size();
            const long long px = paper.present(flock.next(), monitors, i * ticks_per_second / fps);
            for (const Pane& pane : paper.panes) {
                covered += pane.area.area();
            }
            if (paper.anew == anew && paper.panes.size() == panes) {
                in_dirty_frames += px;
                ++dirty_frames;
            }
        }
        // A moving pet changes its old and its new place, which overlap.
        CHECK(in_dirty_frames <= 2LL * 6 * cell * cell * dirty_frames);
        // A lone pet's pane has 256 x 256 pixels.
        CHECK(covered <= 2LL * 6 * 256 * 256 * 20 * fps);
    }
}

TEST_CASE("no pane leaves its monitor, on three monitors of 4K and of 8K") {
    for (const auto& [width, height] : {std::pair{3840, 2160}, {7680, 4320}}) {
        CAPTURE(width);
        const std::vector<Monitor> monitors = three_in_a_row(width, height);
        Flock flock(40, {-width, 0, 3 * width, height}, 900.0);
        Paper paper;
        for (int i = 0; i < 10 * fps; ++i) {
            const Frame frame = flock.next();
            paper.present(frame, monitors, i * ticks_per_second / fps);
            CHECK(paper.panes.size() <= 3 * most_panes);
            for (const Pane& pane : paper.panes) {
                // 16384 px is the most that Windows 10 shows; 8K in both directions is below it.
                CHECK(pane.monitor.contains(pane.area));
                CHECK(std::max(pane.area.width, pane.area.height) <= 8192);
                CHECK(pane.area.area() <= static_cast<long long>(width) * height);
                for (const Sprite& one : frame.sprites) {
                    const Rect seen = intersection(one.bounds(), pane.monitor);
                    const Rect part = intersection(seen, pane.area);
                    CHECK((part.empty() || part == seen));
                }
            }
        }
    }
}

TEST_CASE("panes seldom change their size on recorded paths") {
    // A run along the floor with jumps, as a pet that walks and hops does it; on 1080p, 4K and 8K.
    for (const int width : {1920, 3840, 7680}) {
        for (const int speed : {60, 250, 700, 1500}) {
            CAPTURE(width);
            CAPTURE(speed);
            const std::vector<Monitor> monitors = three_in_a_row(width, width * 9 / 16);
            const int floor = width * 9 / 16 - cell;
            Paper paper;
            const int frames = std::min(30 * fps, fps * (width - cell) / speed);
            long long presented = 0;
            for (int i = 0; i < frames; ++i) {
                const int hop = std::abs(std::abs(i % 60 - 30) - 30) * 4;
                const Frame frame{{sprite(1, {i * speed / fps, floor - hop})}};
                presented += paper.present(frame, monitors, i * ticks_per_second / fps);
            }
            // At the seam that it starts from, and once a hop that is higher than the pane.
            CHECK(paper.resizes <= 4);
            CHECK(presented <= 4LL * cell * cell * frames);
        }
    }
}

TEST_CASE("a frame like the one before presents nothing, for as long as it stays") {
    const std::vector<Monitor> monitors = three_in_a_row(1920, 1080);
    Flock flock(12, {-1920, 0, 3 * 1920, 1080}, 300.0);
    Paper paper;
    Ticks now = 0;
    for (int i = 0; i < 3 * fps; ++i) {
        now = i * ticks_per_second / fps;
        paper.present(flock.next(), monitors, now);
    }
    const Frame still = paper.shown;
    for (Ticks later = now; later < now + 10 * ticks_per_second; later += ticks_per_second / fps) {
        const int anew = paper.anew;
        const long long px = paper.present(still, monitors, later);
        CHECK((px == 0 || paper.anew > anew));
    }
    CHECK(next_plan(paper.panes) == never);
    CHECK(paper.present(still, monitors, now + 20 * ticks_per_second) == 0);
}
