// SPDX-License-Identifier: MIT
// Animations that were asked for, and what the stage makes of them.
#include "daemon/core/playing.h"

#include "daemon/core/stage.h"
#include "tests/core/engine_world.h"

using namespace hyrax;

namespace {

Animation animation(bool loop) {
    return {.frames = {{1, 100}, {2, 200}, {3, 100}}, .loop = loop};
}

std::optional<int> cell(const Playing& playing, bool loop, Ticks elapsed) {
    const auto shown = shown_of(playing, animation(loop), elapsed);
    return shown ? std::optional(shown->cell) : std::nullopt;
}

}  // namespace

TEST_CASE("an animation is played as it is made, or as asked for") {
    const Playing plain{.animation = "x"};
    CHECK(cell(plain, false, 0) == 1);
    CHECK(cell(plain, false, 299) == 2);
    CHECK(cell(plain, false, 399) == 3);
    CHECK(cell(plain, false, 400) == std::nullopt);
    CHECK(cell(plain, true, 400) == 1);
    CHECK(cell({.animation = "x", .loop = true}, false, 500) == 2);
    CHECK(cell({.animation = "x", .loop = false}, true, 400) == std::nullopt);
    const Playing slow{.animation = "x", .fps = 0.5};
    CHECK(cell(slow, false, 2 * ticks_per_second - 1) == 1);
    CHECK(cell(slow, false, 2 * ticks_per_second) == 2);
    CHECK(cell(slow, false, 6 * ticks_per_second) == std::nullopt);
}

TEST_CASE("a frame is due at each change, and none where nothing changes") {
    const Playing plain{.animation = "x"};
    CHECK(shown_of(plain, animation(false), 0)->until == 100);
    CHECK(shown_of(plain, animation(false), 350)->until == 400);
    CHECK(shown_of(plain, animation(true), 750)->until == 800);
    CHECK(shown_of({.animation = "x", .loop = true}, animation(false), 350)->until == 400);
    const Animation still{.frames = {{1, 100}}, .loop = true};
    CHECK(shown_of(plain, still, 250)->until == never);
    CHECK(shown_of({.animation = "x", .loop = false}, still, 50)->until == 100);
}

TEST_CASE("the stage shows what is played, then what the motion shows") {
    std::vector<SpriteSet> sets{placeholder_sprite_set("hyrax")};
    sets[0].animations["cheer"] = {
        .frames = {{0, ticks_per_second / 4}, {0, ticks_per_second / 4}}, .loop = false
    };
    Engine engine(kinds_of(sets), {}, 1);
    engine.set_arena(Arena({monitor({0, 0, 800, 600})}, FloorEdge::work_area));
    const auto id = engine.spawn({.at = Vec2{100, 600}});
    REQUIRE(id);
    engine.advance(0);
    engine.advance(ticks_per_second);
    CHECK_FALSE(engine.play(*id, {.animation = "cheat"}));
    REQUIRE(engine.play(*id, {.animation = "cheer"}));
    Atlas atlas;
    const auto due = [&](Ticks now, bool calm = false) {
        const Scene scene{.now = now, .drowsy_after = never / 4, .calm = calm};
        return staged(engine, sets, atlas, scene).next_change;
    };
    CHECK(due(ticks_per_second) == ticks_per_second * 3 / 2);
    CHECK(due(ticks_per_second * 3 / 2) > ticks_per_second * 3 / 2);
    REQUIRE(engine.play(*id, {.animation = "cheer", .loop = true}));
    CHECK(due(ticks_per_second * 20) == ticks_per_second * 41 / 2);
    CHECK(due(ticks_per_second * 20, true) > ticks_per_second * 21);
    engine.freeze({{0, 0, 800, 600}}, ticks_per_second);
    CHECK(due(ticks_per_second * 20) == never);
    engine.freeze({}, ticks_per_second);
    REQUIRE(engine.fling(*id, {0, -100}));
    CHECK_FALSE(engine.find(*id)->playing.has_value());
}
