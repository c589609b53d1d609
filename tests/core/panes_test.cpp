// SPDX-License-Identifier: MIT
#include "daemon/core/panes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace hyrax;

namespace {

constexpr Rect left_screen{-1600, -200, 1600, 900};
constexpr Rect main_screen{0, 0, 1920, 1080};

std::vector<Monitor> two_screens() {
    return {
        {.bounds = main_screen, .work = main_screen, .primary = true, .name = "main"},
        {.bounds = left_screen, .work = left_screen, .name = "left"}
    };
}

Rect pet_at_place(int x, int y) {
    return {x, y, 96, 96};
}

Sprite sprite(std::uint32_t index, int x, int y) {
    static const Image image(Size{96, 96});
    return {image, {x, y}, {index, 1}};
}

bool covered(const std::vector<Rect>& clusters, const Rect& place) {
    for (int y = place.y; y < place.bottom(); y += 8) {
        for (int x = place.x; x < place.right(); x += 8) {
            const auto holds = [&](const Rect& cluster) { return cluster.contains(Point{x, y}); };
            if (std::ranges::none_of(clusters, holds)) {
                return false;
            }
        }
    }
    return true;
}

long long area_of(const std::vector<Rect>& rects) {
    long long sum = 0;
    for (const Rect& rect : rects) {
        sum += rect.area();
    }
    return sum;
}

}  // namespace

TEST_CASE("a monitor without sprites has no pane") {
    CHECK(plan_panes(two_screens(), {}, {}, 0).empty());
    const std::vector<Rect> between{pet_at_place(-300, 2000)};
    CHECK(plan_panes(two_screens(), between, {}, 0).empty());
    CHECK(plan_panes({}, std::vector{pet_at_place(0, 0)}, {}, 0).empty());
}

TEST_CASE("a pane holds its sprites in the middle, with room to move, within the monitor") {
    const std::vector<Rect> sprites{pet_at_place(300, 400)};
    const std::vector<Pane> panes = plan_panes(two_screens(), sprites, {}, 0);
    REQUIRE(panes.size() == 1);
    CHECK(panes[0].monitor == main_screen);
    CHECK(panes[0].area == Rect{300 - 48, 400 - 48, 192, 192});

    const std::vector<Rect> at_corner{pet_at_place(1824, 984)};
    const Rect area = plan_panes(two_screens(), at_corner, {}, 0).at(0).area;
    CHECK(area == Rect{1920 - 192, 1080 - 192, 192, 192});
}

TEST_CASE("negative coordinates are like others") {
    const std::vector<Rect> sprites{pet_at_place(-1500, -150)};
    const std::vector<Pane> panes = plan_panes(two_screens(), sprites, {}, 0);
    REQUIRE(panes.size() == 1);
    CHECK(panes[0].monitor == left_screen);
    CHECK(panes[0].area == Rect{-1500 - 48, -198, 192, 192});
    CHECK(panes[0].area.contains(sprites[0]));
}

TEST_CASE("a sprite across a seam is shown by both panes, clipped") {
    const std::vector<Rect> sprites{pet_at_place(-40, 100)};
    const std::vector<Pane> panes = plan_panes(two_screens(), sprites, {}, 0);
    REQUIRE(panes.size() == 2);
    CHECK(panes[0].shows == Rect{0, 100, 56, 96});
    CHECK(panes[1].shows == Rect{-40, 100, 40, 96});
}

TEST_CASE("mirrored monitors share one pane") {
    std::vector<Monitor> mirrored = two_screens();
    mirrored[1].bounds = main_screen;
    CHECK(plan_panes(mirrored, std::vector{pet_at_place(10, 10)}, {}, 0).size() == 1);
}

TEST_CASE("a pane grows at once and shrinks after a second") {
    const std::vector<Monitor> monitors = two_screens();
    const std::vector<Rect> near{pet_at_place(300, 400)};
    const std::vector<Rect> far{pet_at_place(300, 400), pet_at_place(1500, 400)};
    std::vector<Pane> panes = plan_panes(monitors, near, {}, 0);
    const Rect small = panes[0].area;
    CHECK(next_plan(panes) == never);

    panes = plan_panes(monitors, far, panes, 10 * ticks_per_ms);
    CHECK(panes.at(0).area.contains(far[1]));
    panes = plan_panes(monitors, near, panes, 20 * ticks_per_ms);
    CHECK(panes.at(0).area.contains(far[1]));

    // Nothing moves any more; the two plans it asks for bring it back.
    const Rect large = panes.at(0).area;
    for (int plans = 0; next_plan(panes) != never; ++plans) {
        REQUIRE(plans < 2);
        panes = plan_panes(monitors, near, panes, next_plan(panes));
    }
    CHECK(panes.at(0).area.width == small.width);
    CHECK(panes.at(0).area.height == small.height);
    CHECK(panes.at(0).area.contains(near[0]));
    CHECK(large.contains(panes.at(0).area));  // What is there already can be shown again.
}

TEST_CASE("the pane of a pet that runs across the screen stays small and keeps its size") {
    const std::vector<Monitor> monitors = two_screens();
    for (const int speed : {30, 120, 400, 1000, 3000}) {
        CAPTURE(speed);
        const int frames = 60 * 1700 / speed;
        // There and back.
        std::vector<Pane> panes;
        int slides = 0;
        for (int frame = 0; frame < 2 * frames; ++frame) {
            const int way = std::min(frame, 2 * frames - frame) * speed / 60;
            const std::vector<Rect> sprites{pet_at_place(20 + way, 900 - way / 2)};
            std::vector<Pane> next =
                plan_panes(monitors, sprites, panes, frame * ticks_per_second / 60);
            REQUIRE(next.size() == 1);
            CHECK(next[0].area.contains(sprites[0]));
            CHECK(main_screen.contains(next[0].area));
            CHECK(next[0].area.width == 192);
            CHECK(next[0].area.height == 192);
            slides += !panes.empty() && next[0].area != panes[0].area ? 1 : 0;
            panes = std::move(next);
        }
        // 64 px lie ahead after a slide, in each direction.
        CHECK(slides <= 2 * (1700 / 64 + 850 / 64 + 2));
    }
}

TEST_CASE("pets that run side by side share a pane that slides; one that stays behind makes it grow"
) {
    const std::vector<Monitor> monitors = two_screens();
    std::vector<Pane> panes;
    for (int i = 0; i < 100; ++i) {
        const std::vector<Rect> herd{pet_at_place(5 * i, 500), pet_at_place(5 * i + 300, 520)};
        panes = plan_panes(monitors, herd, panes, i * ticks_per_second / 60);
        CHECK(panes.at(0).area.width == 512);
        CHECK(panes.at(0).area.height == 192);
        CHECK(panes.at(0).area.contains(united(herd[0], herd[1])));
    }
    int resizes = 0;
    for (int i = 100; i < 300; ++i) {
        const std::vector<Rect> apart{pet_at_place(500, 500), pet_at_place(5 * i + 300, 520)};
        std::vector<Pane> next = plan_panes(monitors, apart, panes, i * ticks_per_second / 60);
        CHECK(next.at(0).area.contains(united(apart[0], apart[1])));
        resizes += next.at(0).area.width != panes.at(0).area.width ? 1 : 0;
        panes = std::move(next);
    }
    CHECK(resizes * 60 <= 2 * 200);
    CHECK(resizes > 0);
}

TEST_CASE("a pane does not shrink for what it will soon have to grow for again") {
    const std::vector<Monitor> monitors = two_screens();
    const auto sizes = [&](int seconds, auto way) {
        std::vector<Pane> panes;
        std::vector<int> widths;
        for (int i = 0; i < 60 * seconds; ++i) {
            const std::vector<Rect> pair{pet_at_place(100, 500), pet_at_place(220 + way(i), 500)};
            panes = plan_panes(monitors, pair, panes, i * ticks_per_second / 60);
            widths.push_back(panes.at(0).area.width);
        }
        return widths;
    };
    // Ever farther apart.
    for (const int speed : {2, 3, 5}) {
        CAPTURE(speed);
        CHECK(std::ranges::is_sorted(sizes(5, [=](int i) { return i * speed; })));
    }
    // To and fro, twice in three seconds.
    const std::vector<int> widths = sizes(20, [](int i) { return std::abs(i % 90 - 45) * 20; });
    CHECK(std::ranges::count(widths, widths.back()) > 19 * 60);
}

TEST_CASE("at rest a pane ends at most a third larger than its sprites need") {
    const std::vector<Monitor> monitors = two_screens();
    std::mt19937 random(3);
    std::uniform_int_distribution<int> start(0, 900);
    std::uniform_int_distribution<int> speed(-20, 20);
    int grown = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<Rect> sprites{pet_at_place(start(random), 500), pet_at_place(900, 500)};
        const Point step{speed(random), speed(random)};
        std::vector<Pane> panes;
        Ticks now = 0;
        for (int frame = 0; frame < 100; ++frame, now += ticks_per_second / 60) {
            sprites[1].x = std::clamp(sprites[1].x + step.x, 0, 1824);
            sprites[1].y = std::clamp(sprites[1].y + step.y, 0, 984);
            panes = plan_panes(monitors, sprites, panes, now);
        }
        grown += next_plan(panes) != never ? 1 : 0;
        while (next_plan(panes) != never) {
            REQUIRE(next_plan(panes) > now);
            now = next_plan(panes);
            panes = plan_panes(monitors, sprites, panes, now);
        }
        const long long needed = plan_panes(monitors, sprites, {}, 0).at(0).area.area();
        CHECK(panes.at(0).area.area() * 3 < needed * 4);
    }
    CHECK(grown > 50);
}

TEST_CASE("panes hold every visible pixel on random walks") {
    const std::vector<Monitor> monitors = two_screens();
    std::mt19937 random(7);
    std::uniform_int_distribution<int> step(-200, 200);
    std::vector<Rect> sprites(5, pet_at_place(100, 100));
    std::vector<Pane> panes;
    for (Ticks now = 0; now < 20 * ticks_per_second; now += 16 * ticks_per_ms) {
        for (Rect& rect : sprites) {
            rect.x = std::clamp(rect.x + step(random), -1700, 1950);
            rect.y = std::clamp(rect.y + step(random), -300, 1100);
        }
        panes = plan_panes(monitors, sprites, panes, now);
        for (const Monitor& monitor : monitors) {
            for (const Rect& rect : sprites) {
                const Rect seen = intersection(rect, monitor.bounds);
                const auto pane = std::ranges::find(panes, monitor.bounds, &Pane::monitor);
                CHECK((seen.empty() || (pane != panes.end() && pane->area.contains(seen))));
            }
        }
        for (const Pane& pane : panes) {
            CHECK(pane.monitor.contains(pane.area));
        }
    }
}

TEST_CASE("equal frames have no changed places") {
    const Frame frame{{sprite(1, 10, 10), sprite(2, 500, 10)}};
    CHECK(changed_places(frame, frame).empty());
}

TEST_CASE("a moved sprite changes its old and its new place") {
    const Frame before{{sprite(1, 10, 10), sprite(2, 500, 10)}};
    const Frame after{{sprite(1, 10, 10), sprite(2, 520, 10)}};
    CHECK(changed_places(before, after) == std::vector<Rect>{{500, 10, 96, 96}, {520, 10, 96, 96}});
}

TEST_CASE("sprites that come, go or change their order are changed places") {
    const Frame one{{sprite(1, 10, 10)}};
    const Frame two{{sprite(2, 500, 10), sprite(1, 10, 10)}};
    CHECK(changed_places(one, two) == std::vector<Rect>{{500, 10, 96, 96}});
    CHECK(changed_places(two, one) == std::vector<Rect>{{500, 10, 96, 96}});
    CHECK(changed_places({}, one) == std::vector<Rect>{{10, 10, 96, 96}});

    const Frame swapped{{sprite(1, 10, 10), sprite(2, 500, 10)}};
    const std::vector<Rect> places = changed_places(two, swapped);
    CHECK(std::ranges::find(places, Rect{500, 10, 96, 96}) != places.end());
}

TEST_CASE("near places become one cluster, distant ones stay apart") {
    const std::vector<Rect> near{{500, 10, 96, 96}, {512, 10, 96, 96}};
    CHECK(dirty_clusters(near, main_screen, {}) == std::vector<Rect>{{500, 10, 108, 96}});

    const Rect wide{-5000, 0, 12000, 1080};
    const std::vector<Rect> distant{pet_at_place(-5000, 0), pet_at_place(5000, 0)};
    const std::vector<Rect> clusters = dirty_clusters(distant, wide, {});
    CHECK(clusters.size() == 2);
    CHECK(area_of(clusters) == area_of(distant));
    // Where a call costs as much as copying the whole window, there is one.
    CHECK(dirty_clusters(distant, wide, {.call_px = wide.area()}).size() == 1);
}

TEST_CASE("clusters are clipped to the pane, and there are few of them") {
    CHECK(
        dirty_clusters(std::vector{pet_at_place(-40, 0)}, main_screen, {}) ==
        std::vector<Rect>{{0, 0, 56, 96}}
    );
    CHECK(dirty_clusters(std::vector{pet_at_place(-400, 0)}, main_screen, {}).empty());

    std::mt19937 random(11);
    std::uniform_int_distribution<int> x(-50, 1900);
    std::uniform_int_distribution<int> y(-50, 1060);
    std::vector<Rect> places;
    for (int i = 0; i < 60; ++i) {
        places.push_back(pet_at_place(x(random), y(random)));
        for (const std::size_t most : {std::size_t{1}, std::size_t{4}, std::size_t{8}}) {
            const std::vector<Rect> clusters =
                dirty_clusters(places, main_screen, {.most_calls = most});
            CHECK(clusters.size() <= most);
            for (const Rect& place : places) {
                CHECK(covered(clusters, intersection(place, main_screen)));
            }
        }
    }
}

TEST_CASE("no pane lies on a monitor that is kept free, whatever is there") {
    std::minstd_rand random(7);
    const std::vector<Monitor> screens = two_screens();
    std::vector<Pane> panes;
    for (int i = 0; i < 2000; ++i) {
        std::vector<Rect> sprites;
        for (auto n = random() % 6; n > 0; --n) {
            const int x = static_cast<int>(random() % 3700) - 1700;
            const int y = static_cast<int>(random() % 1400) - 300;
            sprites.push_back(pet_at_place(x, y));
        }
        std::vector<Rect> kept_free;
        for (const Monitor& monitor : screens) {
            if (random() % 2 == 0) {
                kept_free.push_back(monitor.bounds);
            }
        }
        panes = plan_panes(screens, sprites, panes, i * ticks_per_second / 10, kept_free);
        const std::vector<Pane> all = plan_panes(screens, sprites, {}, 0);
        std::size_t expected = 0;
        for (const Pane& pane : all) {
            expected += std::ranges::count(kept_free, pane.monitor) == 0 ? 1U : 0U;
        }
        REQUIRE(panes.size() == expected);
        for (const Pane& pane : panes) {
            for (const Rect& area : kept_free) {
                REQUIRE(intersection(pane.area, area).empty());
            }
        }
    }
}
