// SPDX-License-Identifier: MIT
// Speech bubbles: wrapping, place, and when they are drawn.
#include "daemon/core/speech.h"

#include "daemon/core/stage.h"
#include "tests/core/engine_world.h"

#include <string>

using namespace hyrax;

namespace {

// Ten pixels for each byte.
int width(std::string_view line) {
    return static_cast<int>(line.size()) * 10;
}

std::vector<std::string> lines(std::string_view text) {
    return wrapped(text, width, 100, 3);
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("texts are wrapped at blanks, long words within, and cut after the last line") {
    CHECK(lines("") == Lines{});
    CHECK(lines("   ") == Lines{});
    CHECK(lines("short") == Lines{"short"});
    CHECK(lines("ten bytes!") == Lines{"ten bytes!"});
    CHECK(lines("more than ten bytes") == Lines{"more than", "ten bytes"});
    CHECK(lines("incomprehensibility") == Lines{"incomprehe", "nsibility"});
    CHECK(
        lines("a b c d e f g h i j k l m n o p q") == Lines{"a b c d e", "f g h i j", "k l m n..."}
    );
    CHECK(wrapped("\u00e4\u00e4\u00e4", width, 30, 3) == Lines{"\u00e4", "\u00e4", "\u00e4"});
    CHECK(wrapped("\u00e4\u00e4", width, 5, 3) == Lines{"\u00e4", "\u00e4"});
    CHECK(wrapped("\u00e4\u00e4\u00e4\u00e4", width, 20, 2) == Lines{"\u00e4", "..."});
}

TEST_CASE("a bubble stands above its pet, within the screen, and below where there is no room") {
    const Rect screen{0, 0, 1000, 800};
    const Size bubble{200, 50};
    const Size tail{16, 10};
    const BubblePlace above = place_bubble({400, 400, 100, 80}, bubble, tail, screen);
    CHECK_FALSE(above.below);
    CHECK(above.body == Point{350, 340});
    CHECK(above.tail == Point{442, 388});
    CHECK(place_bubble({0, 400, 100, 80}, bubble, tail, screen).body.x == 0);
    CHECK(place_bubble({0, 400, 100, 80}, bubble, tail, screen).tail.x == 42);
    CHECK(place_bubble({980, 400, 20, 80}, bubble, tail, screen).body.x == 800);
    CHECK(place_bubble({980, 400, 20, 80}, bubble, tail, screen).tail.x == 975);
    const BubblePlace below = place_bubble({400, 30, 100, 80}, bubble, tail, screen);
    CHECK(below.below);
    CHECK(below.tail == Point{442, 112});
    CHECK(below.body.y == 120);
}

TEST_CASE("a bubble is premultiplied paper around its lines") {
    Image line(Size{40, 12});
    line.at(3, 3) = 0xFF000000;
    const std::vector<Image> all{line, line};
    const Image bubble = bubble_image(all);
    CHECK(bubble.size.width == 60);
    CHECK(bubble.size.height == 36);
    CHECK(alpha_of(bubble.at(0, 0)) == 0);
    CHECK(bubble.at(30, 18) == 0xFFFFFFFF);
    CHECK(bubble.at(13, 9) == 0xFF000000);
    for (const Pixel pixel : bubble.pixels) {
        CHECK((pixel & 0xFFU) <= alpha_of(pixel));
    }
}

TEST_CASE("bubbles are painted once, follow, never catch clicks, and go in time") {
    int painted = 0;
    Speeches speeches([&painted](std::string_view line) -> Result<Image> {
        ++painted;
        return Image(Size{static_cast<int>(line.size()) * 6, 12});
    });
    std::vector<SpriteSet> sets{placeholder_sprite_set("hyrax")};
    Engine engine(kinds_of(sets), {}, 1);
    engine.set_arena(Arena({monitor({0, 0, 800, 600})}, FloorEdge::work_area));
    const auto id = engine.spawn({.at = Vec2{100, 300}});
    REQUIRE(id);
    engine.advance(0);
    Atlas atlas;
    CHECK(staged(engine, sets, atlas, {}).speakers.empty());
    REQUIRE(engine.say(*id, "hello there", 2.0));

    const auto show = [&](Ticks now) {
        engine.advance(now);
        Staged next = staged(engine, sets, atlas, {.now = now});
        if (speeches.concern(next.speakers)) {
            speeches.show(next.frame, engine, next.speakers);
        }
        return next;
    };
    const Staged first = show(ticks_per_second / 10);
    const int once = painted;
    CHECK(once > 0);
    CHECK(first.next_change <= 2 * ticks_per_second);
    REQUIRE(first.frame.bubbles.size() == 2);
    const Rect bubble = first.frame.bubbles[0].bounds();
    CHECK(pet_at(first.frame, {bubble.x + bubble.width / 2, bubble.y + 5}) == std::nullopt);

    const Staged second = show(ticks_per_second / 5);
    CHECK(painted == once);
    CHECK(second.frame.bubbles[0].at.y > first.frame.bubbles[0].at.y);
    REQUIRE(engine.say(*id, "other", 2.0));
    CHECK(show(ticks_per_second / 4).frame.bubbles[0].image != first.frame.bubbles[0].image);
    CHECK(painted > once);

    CHECK(show(3 * ticks_per_second).frame.bubbles.empty());
    CHECK(speeches.concern({}));
    show(4 * ticks_per_second);
    CHECK_FALSE(speeches.concern({}));
}

TEST_CASE("without a painter, or with one that fails, nobody speaks and nothing breaks") {
    for (const bool fails : {false, true}) {
        Speeches speeches(
            fails
                ? TextPainter([](std::string_view) -> Result<Image> { return failure("no font"); })
                : TextPainter()
        );
        World world;
        const PetId id = world.spawn({100, 100});
        REQUIRE(world.engine.say(id, "x", 1.0));
        Frame frame;
        const std::vector<PetId> speakers{id};
        speeches.show(frame, world.engine, speakers);
        CHECK(frame.bubbles.empty());
    }
}
