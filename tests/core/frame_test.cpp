// SPDX-License-Identifier: MIT
// From motion to pixels: poses, stages, frames, the blitter.
#include "daemon/core/blit.h"
#include "daemon/core/dirty.h"
#include "daemon/core/pacer.h"
#include "daemon/core/stage.h"
#include "daemon/core/world_clock.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <random>

using namespace hyrax;

namespace {

constexpr Ticks ms = ticks_per_ms;

constexpr Pixel ink = 0xFF203040U;

// Each cell is full but for the pixel at its top right.
SpriteSet small_set() {
    SpriteSet set;
    set.name = "hyrax";
    set.cell = {8, 8};
    set.sheet = Image(Size{64, 8});
    std::ranges::fill(set.sheet.pixels, ink);
    for (int x = 7; x < 64; x += 8) {
        set.sheet.at(x, 0) = 0;
    }
    set.box = {1, 3, 5, 4};
    set.animations["idle"] = {{{0, 1000 * ms}, {1, 100 * ms}}, true};
    set.animations["fall"] = {{{2, 100 * ms}, {3, 100 * ms}}, true};
    set.animations["held"] = {{{4, 100 * ms}}, true};
    set.animations["land"] = {{{5, 80 * ms}, {6, 120 * ms}}, false};
    set.animations["rest"] = {{{7, 500 * ms}, {3, 500 * ms}}, true};
    return set;
}

Image filled(Size size, Pixel pixel) {
    Image image(size);
    std::ranges::fill(image.pixels, pixel);
    return image;
}

}  // namespace

TEST_CASE("a settled pet lands, sits, and lies down for good") {
    const SpriteSet set = small_set();
    const Ticks drowsy = 3000 * ms;
    const auto at = [&](Ticks elapsed) { return pose(set, Motion::settled, elapsed, drowsy); };
    CHECK(at(0).cell == 5);
    CHECK(at(0).until == 80 * ms);
    CHECK(at(80 * ms).cell == 6);
    CHECK(at(80 * ms).until == 200 * ms);
    CHECK(at(200 * ms).cell == 0);
    CHECK(at(200 * ms).until == 1200 * ms);
    CHECK(at(1250 * ms).cell == 1);
    CHECK(at(3150 * ms).until == 3200 * ms);
    CHECK(at(3200 * ms).cell == 7);
    CHECK(at(3200 * ms).until == 3700 * ms);
    CHECK(at(9100 * ms).cell == 3);
    CHECK(at(9200 * ms).cell == 3);
    CHECK(at(9200 * ms).until == never);
    CHECK(at(1'000'000 * ms).cell == 3);
}

TEST_CASE("a set without land and rest goes on sitting") {
    SpriteSet set = small_set();
    set.animations.erase("land");
    set.animations.erase("rest");
    CHECK(pose(set, Motion::settled, 0, 0).cell == 0);
    CHECK(pose(set, Motion::settled, 100 * 1100 * ms + 1050 * ms, 0).cell == 1);
}

TEST_CASE("flight and hand have animations of their own") {
    const SpriteSet set = small_set();
    CHECK(pose(set, Motion::airborne, 150 * ms, 0).cell == 3);
    CHECK(pose(set, Motion::airborne, 250 * ms, 0).until == 300 * ms);
    CHECK(pose(set, Motion::held, 12'345 * ms, 0).cell == 4);
}

TEST_CASE("the box stands where physics says, mirrored or not") {
    const std::vector<SpriteSet> sets{small_set()};
    Engine engine({{"hyrax", {5, 4}}}, {.physics = {.gravity = 0.0, .air_drag = 1.0}}, 1);
    engine.set_arena(Arena({{{0, 0, 200, 100}, {0, 0, 200, 100}, true, {}}}, FloorEdge::screen));
    const auto id = engine.spawn({.at = Vec2{20.4, 30.6}, .velocity = {60.0, 0.0}});
    REQUIRE(id);
    engine.advance(0);
    Atlas atlas;
    Staged right = staged(engine, sets, atlas, {});
    REQUIRE(right.frame.sprites.size() == 1);
    CHECK(right.frame.sprites[0].at == Point{20 - 1, 31 - 3});
    CHECK(right.frame.sprites[0].image->size == Size{8, 8});
    CHECK(right.frame.sprites[0].image->pixels.front() == ink);
    CHECK(right.next_change == 100 * ms);

    REQUIRE(engine.fling(*id, {-60.0, 0.0}));
    engine.advance(1);
    const Staged left = staged(engine, sets, atlas, {.now = 1});
    CHECK(left.frame.sprites[0].image->pixels.front() == 0);
    CHECK(left.frame.sprites[0].at == Point{20 - 2, 31 - 3});
}

TEST_CASE("a press finds the topmost pet with a visible pixel") {
    Image image(Size{4, 4});
    image.at(1, 1) = 0xff102030U;
    const Sprite below{image, {-10, -20}, {1, 1}};
    const Sprite above{image, {-9, -20}, {2, 1}};
    const Frame frame{{below, above}};
    CHECK(pet_at(frame, {-9, -19}) == PetId{1, 1});
    CHECK(pet_at(frame, {-8, -19}) == PetId{2, 1});
    CHECK_FALSE(pet_at(frame, {-7, -19}));
    CHECK_FALSE(pet_at(Frame{}, {0, 0}));
}

TEST_CASE("source-over rounds each channel to the nearest value") {
    std::mt19937 random(7);
    for (int i = 0; i < 200'000; ++i) {
        const auto up_to = [&random](Pixel limit) {
            const std::uint64_t number = random();
            return static_cast<Pixel>(number % (limit + 1U));
        };
        const auto premultiplied = [&up_to] {
            const Pixel a = up_to(255);
            return (a << 24U) | (up_to(a) << 16U) | (up_to(a) << 8U) | up_to(a);
        };
        const Pixel source = premultiplied();
        const Pixel target = premultiplied();
        Image canvas = filled({1, 1}, target);
        const Image ink = filled({1, 1}, source);
        blit(PixelView(canvas), {0, 0, 1, 1}, {ink, {0, 0}});
        for (const unsigned shift : {0U, 8U, 16U, 24U}) {
            const unsigned s = (source >> shift) & 0xffU;
            const unsigned t = (target >> shift) & 0xffU;
            const unsigned expected = s + (t * (255U - alpha_of(source)) * 2U + 255U) / 510U;
            REQUIRE(((canvas.pixels[0] >> shift) & 0xffU) == expected);
        }
    }
}

TEST_CASE("drawing is clipped at every edge of the target") {
    const Image ink = filled({4, 4}, 0xffffffffU);
    for (int x = -5; x <= 9; ++x) {
        for (int y = -5; y <= 9; ++y) {
            // A guarded canvas: the target is the middle of a larger picture.
            Image canvas(Size{24, 24});
            const PixelView middle(&canvas.at(8, 8), 24, {8, 8});
            blit(middle, {0, 0, 8, 8}, {ink, {x, y}});
            for (int v = 0; v < 24; ++v) {
                for (int u = 0; u < 24; ++u) {
                    const Point local{u - 8, v - 8};
                    const bool inside =
                        Rect{0, 0, 8, 8}.contains(local) && Rect{x, y, 4, 4}.contains(local);
                    REQUIRE(canvas.at(u, v) == (inside ? 0xffffffffU : 0U));
                }
            }
        }
    }
}

TEST_CASE("composing a dirty rectangle leaves the rest alone and equals a full redraw") {
    const Image ink = filled({6, 6}, 0x80402010U);
    const Frame before{{{ink, {-30, 4}, {1, 1}}, {ink, {-12, 4}, {2, 1}}}};
    Frame after = before;
    after.sprites[0].at = {-28, 5};
    const Point origin{-40, -10};
    const Rect whole{-40, -10, 60, 40};

    Image partly(Size{60, 40});
    compose(PixelView(partly), origin, whole, before);
    compose(
        PixelView(partly),
        origin,
        united(before.sprites[0].bounds(), after.sprites[0].bounds()),
        after
    );
    Image fully(Size{60, 40});
    compose(PixelView(fully), origin, whole, after);
    CHECK(partly.pixels == fully.pixels);
}

TEST_CASE("redrawing what was drawn equals a full redraw, whoever moves, comes and goes") {
    std::minstd_rand random(5);
    const auto below = [&random](int limit) {
        return static_cast<int>(std::uint64_t{random()} % static_cast<std::uint64_t>(limit));
    };
    const Image ink = filled({9, 7}, 0x80402010U);
    const Rect whole{-40, -10, 80, 60};
    const Point origin{-40, -10};
    Image partly(Size{80, 60});
    Frame before;
    for (int round = 0; round < 500; ++round) {
        Frame after = before;
        for (Sprite& sprite : after.sprites) {
            if (below(2) == 0) {
                sprite.at = {sprite.at.x + below(9) - 4, sprite.at.y + below(9) - 4};
            }
        }
        if (below(4) == 0 && !after.sprites.empty()) {
            after.sprites.erase(
                after.sprites.begin() + below(static_cast<int>(after.sprites.size()))
            );
        }
        if (below(3) == 0 && after.sprites.size() < 12) {
            const auto number = static_cast<std::uint32_t>(round + 1);
            after.sprites.push_back({ink, {below(90) - 45, below(70) - 15}, {number, 1}});
        }
        const PresentCost cost{.most_calls = static_cast<std::size_t>(1 + below(8))};
        const auto parts = dirty_clusters(changed_places(before, after), whole, cost);
        recompose(PixelView(partly), origin, parts, places_of(before), after);
        Image fully(Size{80, 60});
        compose(PixelView(fully), origin, whole, after);
        REQUIRE(partly.pixels == fully.pixels);
        before = after;
    }
}

TEST_CASE("a part of many rows is drawn without a seam") {
    const Image ink = filled({50, 70}, 0x80402010U);
    const Size size{2'000, 1'500};
    const Rect whole{0, 0, size.width, size.height};
    Frame before;
    Frame after;
    for (int i = 0; i < 60; ++i) {
        const Point at{i * 33 - 20, i * 26 - 40};
        before.sprites.push_back({ink, at, {}});
        after.sprites.push_back({ink, {at.x + 11, at.y - 5}, {}});
    }
    Image drawn(size);
    compose(PixelView(drawn), {}, whole, before);
    recompose(PixelView(drawn), {}, std::span(&whole, 1), places_of(before), after);

    Image expected(size);
    for (const Sprite& sprite : after.sprites) {
        blit(PixelView(expected), whole, {*sprite.image, sprite.at});
    }
    CHECK(drawn.pixels == expected.pixels);
}

TEST_CASE("late frames keep the grid, a hitch starts a new one") {
    Pacer pacer;
    pacer.set_rate(100.0);
    pacer.drawn(0);
    CHECK(pacer.next() == 10 * ms);
    pacer.drawn(12 * ms);
    CHECK(pacer.next() == 20 * ms);
    pacer.drawn(20 * ms);
    CHECK(pacer.next() == 30 * ms);
    pacer.drawn(95 * ms);
    CHECK(pacer.next() == 105 * ms);
}

TEST_CASE("the world's time stands still in a pause") {
    WorldClock clock;
    CHECK(clock.at(100) == 100);
    clock.set_paused(true, 100);
    clock.set_paused(true, 150);
    CHECK(clock.at(500) == 100);
    CHECK(clock.machine_time(200) == never);
    clock.set_paused(false, 600);
    CHECK(clock.at(600) == 100);
    CHECK(clock.at(700) == 200);
    CHECK(clock.machine_time(200) == 700);
    CHECK(clock.machine_time(never) == never);
}
