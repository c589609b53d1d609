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

const std::vector<Monitor> screens = two_screens();
constexpr Ticks frame_time = ticks_per_second / 60;

Rect pet_at_place(int x, int y) {
    return {x, y, 96, 96};
}

std::vector<Pane> planned(
    const std::vector<Rect>& sprites, const std::vector<Pane>& before = {}, Ticks now = 0
) {
    return plan_panes({screens, sprites}, before, now);
}

long long area_of(const std::vector<Pane>& panes) {
    long long sum = 0;
    for (const Pane& pane : panes) {
        sum += pane.area.area();
    }
    return sum;
}

/// Whatever is seen of each sprite lies in one pane; panes do not overlap, and each has its slot.
void check_sound(const std::vector<Pane>& panes, const std::vector<Rect>& sprites) {
    for (const Monitor& monitor : screens) {
        for (const Rect& sprite : sprites) {
            const Rect seen = intersection(sprite, monitor.bounds);
            const auto holds = [&](const Pane& pane) { return pane.area.contains(seen); };
            CHECK((seen.empty() || std::ranges::count_if(panes, holds) == 1));
        }
        CHECK(std::ranges::count(panes, monitor.bounds, &Pane::monitor) <= int{most_panes});
    }
    for (std::size_t i = 0; i < panes.size(); ++i) {
        CHECK(panes[i].monitor.contains(panes[i].area));
        CHECK(panes[i].area.contains(panes[i].shows));
        for (std::size_t k = 0; k < i; ++k) {
            CHECK(intersection(panes[i].area, panes[k].area).empty());
            CHECK(panes[i].slot != panes[k].slot);
        }
    }
}

/// Plans again, without drawing, until nothing is due any more.
void rest(std::vector<Pane>& panes, const std::vector<Rect>& sprites, Ticks now) {
    for (int plans = 0; next_plan(panes) != never; ++plans) {
        REQUIRE(plans < 4);
        REQUIRE(next_plan(panes) > now);
        now = next_plan(panes);
        panes = plan_panes({screens, sprites, {}, false}, panes, now);
    }
}

}  // namespace

TEST_CASE("a monitor without sprites has no pane") {
    CHECK(planned({}).empty());
    CHECK(planned({pet_at_place(-300, 2000)}).empty());
    CHECK(plan_panes({{}, std::vector{pet_at_place(0, 0)}}, {}, 0).empty());
}

TEST_CASE("a pane holds its sprites in the middle, with room to move, within the monitor") {
    const std::vector<Pane> panes = planned({pet_at_place(300, 400)});
    REQUIRE(panes.size() == 1);
    CHECK(panes[0].monitor == main_screen);
    CHECK(panes[0].area == Rect{300 - 48, 400 - 48, 192, 192});
    const std::vector<Pane> at_corner = planned({pet_at_place(1824, 984)});
    CHECK(at_corner.at(0).area == Rect{1920 - 192, 1080 - 192, 192, 192});
}

TEST_CASE("negative coordinates are like others") {
    const std::vector<Pane> panes = planned({pet_at_place(-1500, -150)});
    REQUIRE(panes.size() == 1);
    CHECK(panes[0].monitor == left_screen);
    CHECK(panes[0].area == Rect{-1500 - 48, -198, 192, 192});
}

TEST_CASE("a sprite across a seam is shown by both panes, clipped") {
    const std::vector<Pane> panes = planned({pet_at_place(-40, 100)});
    REQUIRE(panes.size() == 2);
    CHECK(panes[0].shows == Rect{0, 100, 56, 96});
    CHECK(panes[1].shows == Rect{-40, 100, 40, 96});
}

TEST_CASE("mirrored monitors share their panes") {
    std::vector<Monitor> mirrored = two_screens();
    mirrored[1].bounds = main_screen;
    const std::vector<Rect> sprites{pet_at_place(10, 10)};
    CHECK(plan_panes({mirrored, sprites}, {}, 0).size() == 1);
}

TEST_CASE("neighbours share a pane, pets far apart have one each") {
    CHECK(planned({pet_at_place(300, 400), pet_at_place(500, 420)}).size() == 1);
    const std::vector<Rect> far{pet_at_place(300, 400), pet_at_place(1500, 420)};
    const std::vector<Pane> panes = planned(far);
    REQUIRE(panes.size() == 2);
    check_sound(panes, far);
    CHECK(area_of(panes) == 2 * 192 * 192);
}

TEST_CASE("there are at most as many panes as a monitor may have") {
    std::vector<Rect> sprites;
    for (int i = 0; i < 18; ++i) {
        sprites.push_back(pet_at_place(i % 6 * 300 + 50, i / 6 * 400 + 50));
    }
    const std::vector<Pane> panes = planned(sprites);
    check_sound(panes, sprites);
    // One that comes later finds room, too.
    sprites.push_back(pet_at_place(200, 250));
    check_sound(planned(sprites, panes, frame_time), sprites);
}

TEST_CASE("pets that part get a pane each, and share one when they meet again") {
    for (const int speed : {120, 400, 1500}) {
        CAPTURE(speed);
        std::vector<Pane> panes;
        int changes = 0;
        std::size_t most = 0;
        Ticks now = 0;
        for (int way = 0; way < 2 * 1400; way += speed / 60, now += frame_time) {
            const int apart = 100 + std::min(way, 2 * 1400 - way);
            const std::vector<Rect> pair{pet_at_place(200, 500), pet_at_place(200 + apart, 500)};
            std::vector<Pane> next = planned(pair, panes, now);
            check_sound(next, pair);
            changes += next.size() != panes.size() ? 1 : 0;
            most = std::max(most, next.size());
            // One window is always there.
            CHECK(std::ranges::count(next, std::size_t{0}, &Pane::slot) == 1);
            panes = std::move(next);
        }
        CHECK(most == 2);
        CHECK(panes.size() == 1);
        CHECK(changes == 3);  // It comes, it is divided, they are joined.
    }
}

TEST_CASE("pets that go to and fro do not make panes come and go") {
    for (const int near : {200, 300, 350, 450, 600}) {
        CAPTURE(near);
        std::vector<Pane> panes;
        int changes = 0;
        for (int i = 0; i < 60 * 20; ++i) {
            const int apart = near + std::abs(i % 60 - 30) * 3;
            const std::vector<Rect> pair{pet_at_place(200, 500), pet_at_place(200 + apart, 500)};
            std::vector<Pane> next = planned(pair, panes, i * frame_time);
            changes += next.size() != panes.size() ? 1 : 0;
            panes = std::move(next);
        }
        CHECK(changes <= 3);
    }
}

TEST_CASE("when panes become one, the window of the larger one stays") {
    std::vector<Rect> sprites{pet_at_place(1500, 500)};
    std::vector<Pane> panes = planned(sprites);
    for (int i = 0; i < 5; ++i) {
        sprites.push_back(pet_at_place(300 + 90 * i, 500));
    }
    panes = planned(sprites, panes, frame_time);
    REQUIRE(panes.size() == 2);
    for (Ticks now = 2 * frame_time; panes.size() == 2; now += frame_time) {
        sprites[0].x -= 20;
        panes = planned(sprites, panes, now);
    }
    CHECK(panes.at(0).slot == 1);
    check_sound(panes, sprites);
}

TEST_CASE("a crowd that runs apart ends in small panes") {
    std::vector<Rect> sprites;
    for (int i = 0; i < 6; ++i) {
        sprites.push_back(pet_at_place(800 + 20 * i, 500));
    }
    std::vector<Pane> panes = planned(sprites);
    CHECK(panes.size() == 1);
    Ticks now = 0;
    for (int frame = 0; frame < 200; ++frame, now += frame_time) {
        for (int i = 0; i < 6 && frame < 100; ++i) {
            sprites[static_cast<std::size_t>(i)].x += (i % 3 - 1) * 7;
            sprites[static_cast<std::size_t>(i)].y += i < 3 ? -4 : 4;
        }
        panes = planned(sprites, panes, now);
        check_sound(panes, sprites);
    }
    CHECK(panes.size() == 6);
    CHECK(area_of(panes) <= 6 * 192 * 192);
}

TEST_CASE("what cannot be drawn is not divided") {
    std::vector<Pane> panes;
    std::vector<Rect> pair{pet_at_place(300, 400), pet_at_place(500, 400)};
    Ticks now = 0;
    for (; now < 2 * ticks_per_second; now += frame_time) {
        pair[1].x = std::min(pair[1].x + 20, 1500);
        panes = plan_panes({screens, pair, {}, false}, panes, now);
        REQUIRE(panes.size() == 1);
        check_sound(panes, pair);
    }
    CHECK(planned(pair, panes, now + ticks_per_second).size() == 2);
}

TEST_CASE("a pane shrinks after its room was needed, within what it shows") {
    const std::vector<Rect> near{pet_at_place(300, 400)};
    const std::vector<Rect> row{pet_at_place(300, 400), pet_at_place(480, 400)};
    std::vector<Pane> panes = planned(near);
    const Rect small = panes[0].area;
    CHECK(next_plan(panes) == never);
    panes = planned(row, panes, 10 * ticks_per_ms);
    panes = planned(near, panes, 20 * ticks_per_ms);
    const Rect large = panes.at(0).area;
    CHECK(large.contains(row[1]));
    // Nothing moves any more; the plans it asks for bring it back.
    rest(panes, near, 20 * ticks_per_ms);
    CHECK(panes.at(0).area.width == small.width);
    CHECK(panes.at(0).area.height == small.height);
    CHECK(large.contains(panes.at(0).area));
    check_sound(panes, near);
}

TEST_CASE("a window that is no longer needed serves the next pane") {
    std::vector<Pane> panes = planned({pet_at_place(300, 400), pet_at_place(1500, 400)});
    REQUIRE(panes.size() == 2);
    const std::size_t left = panes[1].slot;
    panes = planned({pet_at_place(1500, 400)}, panes, frame_time);
    REQUIRE(panes.size() == 1);
    CHECK(panes[0].slot == left);
    panes = planned({pet_at_place(1500, 400), pet_at_place(-900, 100)}, panes, 2 * frame_time);
    REQUIRE(panes.size() == 2);
    CHECK(panes[0].slot == left);
    CHECK(panes[1].slot == 1 - left);
}

TEST_CASE("the pane of a pet that runs across the screen stays small and keeps its size") {
    for (const int speed : {30, 120, 400, 1000, 3000}) {
        CAPTURE(speed);
        const int frames = 60 * 1700 / speed;
        // There and back.
        std::vector<Pane> panes;
        int slides = 0;
        for (int frame = 0; frame < 2 * frames; ++frame) {
            const int way = std::min(frame, 2 * frames - frame) * speed / 60;
            const std::vector<Rect> sprites{pet_at_place(20 + way, 900 - way / 2)};
            std::vector<Pane> next = planned(sprites, panes, frame * frame_time);
            REQUIRE(next.size() == 1);
            check_sound(next, sprites);
            CHECK(next[0].area.width == 192);
            CHECK(next[0].area.height == 192);
            slides += !panes.empty() && next[0].area != panes[0].area ? 1 : 0;
            panes = std::move(next);
        }
        // 64 px lie ahead after a slide, in each direction.
        CHECK(slides <= 2 * (1700 / 64 + 850 / 64 + 2));
    }
}

TEST_CASE("pets that run side by side share a pane that slides") {
    std::vector<Pane> panes;
    for (int i = 0; i < 100; ++i) {
        const std::vector<Rect> herd{pet_at_place(5 * i, 500), pet_at_place(5 * i + 300, 520)};
        panes = planned(herd, panes, i * frame_time);
        REQUIRE(panes.size() == 1);
        CHECK(panes[0].area.width == 512);
        CHECK(panes[0].area.height == 192);
        check_sound(panes, herd);
    }
}

TEST_CASE("a pane does not shrink for what it will soon have to grow for again") {
    // Rows of five, near enough for one pane to be cheapest.
    const auto sizes = [](int seconds, auto gap) {
        std::vector<Pane> panes;
        std::vector<int> widths;
        for (int i = 0; i < 60 * seconds; ++i) {
            std::vector<Rect> row;
            for (int k = 0; k < 5; ++k) {
                row.push_back(pet_at_place(100 + k * gap(i), 500));
            }
            panes = planned(row, panes, i * frame_time);
            REQUIRE(panes.size() == 1);
            widths.push_back(panes[0].area.width);
        }
        return widths;
    };
    // Ever farther apart.
    for (const int slowness : {1, 2}) {
        CAPTURE(slowness);
        CHECK(std::ranges::is_sorted(sizes(3, [=](int i) { return 100 + i / slowness; })));
    }
    // To and fro, twice a second.
    const std::vector<int> widths =
        sizes(20, [](int i) { return 60 + std::abs(i % 30 - 15) * 12; });
    CHECK(std::ranges::count(widths, widths.back()) > 19 * 60);
}

// A quarter that shrinking must gain, and a quarter that dividing must: nothing changes for less.
TEST_CASE("at rest panes end less than twice as dear as a new plan") {
    const auto cost_of = [](const std::vector<Pane>& panes) {
        return area_of(panes) + window_price * static_cast<long long>(panes.size());
    };
    std::mt19937 random(3);
    std::uniform_int_distribution<int> start(0, 900);
    std::uniform_int_distribution<int> speed(-20, 20);
    for (int round = 0; round < 200; ++round) {
        std::vector<Rect> sprites{pet_at_place(start(random), 500), pet_at_place(900, 500)};
        const Point step{speed(random), speed(random)};
        std::vector<Pane> panes;
        Ticks now = 0;
        // They move for a while, and breathe for some seconds.
        for (int frame = 0; frame < 300; ++frame, now += frame_time) {
            if (frame < 100) {
                sprites[1].x = std::clamp(sprites[1].x + step.x, 0, 1824);
                sprites[1].y = std::clamp(sprites[1].y + step.y, 0, 984);
            }
            panes = planned(sprites, panes, now);
        }
        rest(panes, sprites, now);
        check_sound(panes, sprites);
        CHECK(cost_of(panes) * 9 <= cost_of(planned(sprites)) * 16);
    }
}

TEST_CASE("panes hold every visible pixel on random walks and jumps, for crowds of any size") {
    std::mt19937 random(7);
    for (const std::size_t pets : {1U, 2U, 5U, 20U, 80U}) {
        for (const int stride : {3, 40, 200}) {
            CAPTURE(pets);
            CAPTURE(stride);
            std::uniform_int_distribution<int> step(-stride, stride);
            std::vector<Rect> sprites(pets, pet_at_place(100, 100));
            std::vector<Pane> panes;
            for (Ticks now = 0; now < 10 * ticks_per_second; now += frame_time) {
                for (Rect& rect : sprites) {
                    rect.x = std::clamp(rect.x + step(random), -1700, 1950);
                    rect.y = std::clamp(rect.y + step(random), -300, 1100);
                }
                const bool drawable = random() % 4 != 0;
                panes = plan_panes({screens, sprites, {}, drawable}, panes, now);
                check_sound(panes, sprites);
            }
        }
    }
}

TEST_CASE("no pane lies on a monitor that is kept free, whatever is there") {
    std::minstd_rand random(7);
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
        panes = plan_panes({screens, sprites, kept_free}, panes, i * ticks_per_second / 10);
        for (const Monitor& monitor : screens) {
            const auto seen = [&](const Rect& sprite) {
                return !intersection(sprite, monitor.bounds).empty();
            };
            const bool expected = std::ranges::any_of(sprites, seen) &&
                                  std::ranges::count(kept_free, monitor.bounds) == 0;
            REQUIRE((std::ranges::count(panes, monitor.bounds, &Pane::monitor) > 0) == expected);
        }
        for (const Pane& pane : panes) {
            for (const Rect& area : kept_free) {
                REQUIRE(intersection(pane.area, area).empty());
            }
        }
    }
}
