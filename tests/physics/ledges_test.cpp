// SPDX-License-Identifier: MIT
// Ledges: floors that are open from below.
#include "physics/body.h"
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

using namespace hyrax;
using namespace hyrax::test;

namespace {

constexpr Size pet{100, 100};
const Rect screen{0, 0, 1600, 1000};

FreeSpace screen_with(std::vector<Ledge> ledges) {
    return FreeSpace::among({screen}, pet).with_ledges(ledges, pet);
}

Scene scene_on(std::vector<Ledge> ledges, Vec2 position, Vec2 velocity) {
    return {law_from({}), screen_with(std::move(ledges)), position, velocity};
}

// Some of them through walls, through each other, at the floor's own height, or out of reach.
std::vector<Ledge> random_ledges(Random& random, const FreeSpace& space) {
    std::vector<Ledge> ledges;
    const int count = random.whole(1, 12);
    for (int i = 0; i < count; ++i) {
        const Vec2 at = random_place(random, space);
        const int left = static_cast<int>(at.x) - random.whole(0, 300);
        ledges.push_back({left, left + random.whole(1, 900), static_cast<int>(at.y)});
        if (random.one_in(6) && !space.floors().empty()) {
            ledges.back().y = static_cast<int>(space.floors().front().at);
        }
    }
    return ledges;
}

Scene random_ledge_scene(Random& random) {
    Scene scene = random_scene(random);
    scene.space = scene.space.with_ledges(random_ledges(random, scene.space), {});
    const std::span<const Barrier> ledges = scene.space.ledges();
    if (random.one_in(4)) {
        const Barrier& ledge = ledges[random.below(ledges.size())];
        scene.position = {random.between(ledge.low - 5.0, ledge.high + 5.0), ledge.at};
        scene.position = scene.space.nearest(scene.position);
    }
    return scene;
}

// The greatest speed that a body of this scene can have [px/s].
double speed_limit(const Scene& scene, double seconds) {
    return std::hypot(scene.velocity.x, scene.velocity.y) + scene.law.gravity * seconds;
}

// True if a body that went the short way from `a` to `b` fell through the ledge.
bool fell_through(const Barrier& ledge, Vec2 a, Vec2 b, double margin) {
    const auto over = [&](Vec2 p) { return p.x > ledge.low + margin && p.x < ledge.high - margin; };
    return a.y <= ledge.at && b.y > ledge.at && over(a) && over(b);
}

// Steps that are so small that nothing needs to be located.
class TinySteps {
public:
    explicit TinySteps(const Scene& scene)
        : scene_(scene), state_(let_go(scene.position, scene.velocity, scene.law, scene.space)) {}

    void step(double dt) {
        const Law& law = scene_.law;
        const bool grounded = state_.mode != Mode::air;
        const double drag = grounded ? law.ground_drag : law.drag;
        state_.velocity.y += grounded ? 0.0 : law.gravity * dt;
        state_.velocity = state_.velocity * (1.0 - drag * dt);
        Vec2 to = state_.position + state_.velocity * dt;
        if (!scene_.space.contains({to.x, state_.position.y})) {
            state_.velocity.x *= -law.restitution;
            to.x = state_.position.x;
        }
        if (grounded) {
            const bool held = carries({to.x, state_.position.y + 1e-6}, state_.position.y);
            state_.mode = held ? Mode::ground : Mode::air;
            state_.velocity.x *= held && std::fabs(state_.velocity.x) <= law.stop_speed ? 0.0 : 1.0;
        } else if (carries(to, state_.position.y)) {
            land();
            to.y = state_.position.y;
        }
        state_.position = to;
    }
    Vec2 position() const { return state_.position; }

private:
    bool carries(Vec2 to, double from_y) const {
        return !scene_.space.contains(to) ||
               std::ranges::any_of(scene_.space.ledges(), [&](const Barrier& ledge) {
                   return from_y <= ledge.at && to.y > ledge.at && to.x > ledge.low &&
                          to.x < ledge.high;
               });
    }

    void land() {
        const bool falls = state_.velocity.y > 0.0;
        state_.velocity.y *= -scene_.law.restitution;
        state_.velocity.x *= falls ? scene_.law.impact_friction : 1.0;
        if (falls && -state_.velocity.y < scene_.law.rest_speed) {
            state_.velocity.y = 0.0;
            state_.mode = Mode::ground;
        }
    }

    const Scene& scene_;
    BodyState state_;
};

constexpr std::array locating{
    Integrator::event_driven,
    Integrator::exponential_swept,
    Integrator::stormer_verlet,
    Integrator::rk45,
};

// A body of any integrator, at 240 frames a second.
class Moving {
public:
    Moving(Scene scene, Integrator integrator) : scene_(std::move(scene)) {
        rules_.integrator = integrator;
        rules_.law = scene_.law;
        body_.launch(scene_.position, scene_.velocity, rules_, around(), WallEvents::wanted);
        body_.start(0);
    }
    BodyState at(Ticks end) {
        while (now_ < end) {
            now_ = std::min(end, now_ + ticks_per_second / 240);
            body_.advance(now_, rules_, around(), [](const TrajectoryEvent&) {});
        }
        return body_.at(now_, rules_, around());
    }

private:
    Surroundings around() const { return {scene_.space, screen, pet}; }

    Scene scene_;
    MotionRules rules_;
    Body body_;
    Ticks now_ = 0;
};

}  // namespace

TEST_CASE("a body falls onto a ledge, rests on it, and rises through it") {
    for (const Integrator integrator : locating) {
        CAPTURE(static_cast<int>(integrator));
        const std::vector<Ledge> ledges{{400, 900, 600}};
        Moving from_above(scene_on(ledges, {600.0, 0.0}, {0.0, 0.0}), integrator);
        CHECK(from_above.at(20 * ticks_per_second) == BodyState{{600.0, 500.0}, {}, Mode::rest});
        Moving from_below(scene_on(ledges, {600.0, 700.0}, {0.0, -1200.0}), integrator);
        CHECK(from_below.at(ticks_per_second / 4).position.y < 500.0);
        CHECK(from_below.at(20 * ticks_per_second) == BodyState{{600.0, 500.0}, {}, Mode::rest});
        Moving beneath(scene_on(ledges, {600.0, 700.0}, {0.0, -300.0}), integrator);
        CHECK(beneath.at(20 * ticks_per_second) == BodyState{{600.0, 900.0}, {}, Mode::rest});
    }
}

TEST_CASE("a body stands on a ledge with any part of its lower side, and beside it with none") {
    const auto rest_of = [](double x) {
        Run run(scene_on({{400, 900, 600}}, {x, 0.0}, {}));
        return run.at(60 * ticks_per_second).position.y;
    };
    CHECK(rest_of(300.5) == 500.0);
    CHECK(rest_of(899.5) == 500.0);
    CHECK(rest_of(300.0) == 900.0);
    CHECK(rest_of(900.0) == 900.0);
}

TEST_CASE("a body that is put exactly on a ledge stays there, one below it falls") {
    Run on(scene_on({{400, 900, 600}}, {600.0, 500.0}, {}));
    CHECK(on.body().mode() == Mode::rest);
    CHECK(on.body().next_event() == never);
    Run hopping(scene_on({{400, 900, 600}}, {600.0, 500.0}, {0.0, 400.0}));
    CHECK(hopping.at(ticks_per_second / 100).position.y < 500.0);
    Run below(scene_on({{400, 900, 600}}, {600.0, std::nextafter(500.0, 501.0)}, {}));
    CHECK(below.at(60 * ticks_per_second).position.y == 900.0);
}

TEST_CASE("a body slides off the end of a ledge and falls on what is below") {
    for (const Integrator integrator : locating) {
        CAPTURE(static_cast<int>(integrator));
        Scene scene = scene_on({{400, 900, 600}, {700, 1300, 990}}, {850.0, 500.0}, {300.0, 0.0});
        scene.law.ground_drag = 0.0;
        Moving body(scene, integrator);
        CHECK(body.at(ticks_per_second / 10).mode == Mode::ground);
        CHECK(body.at(ticks_per_second / 4).mode == Mode::air);
        // The lower one lies above the floor by less than the body is high.
        CHECK(body.at(2 * ticks_per_second).position.y <= 890.0);
        scene.law.ground_drag = 20.0;
        scene.velocity.x = 2000.0;
        CHECK(Moving(scene, integrator).at(60 * ticks_per_second).position.y == 890.0);
    }
}

TEST_CASE("ledges that touch are one floor, and a wall stands in a ledge that goes on behind it") {
    Scene scene = scene_on({{400, 900, 600}, {900, 1200, 600}}, {700.0, 500.0}, {400.0, 0.0});
    scene.law.ground_drag = 0.0;
    Run across(scene);
    CHECK(across.at(ticks_per_second).position == Vec2{1100.0, 500.0});
    CHECK(across.events.empty());
    scene.space = screen_with({{400, 5000, 600}});
    Run bounced(scene);
    CHECK(bounced.at(3 * ticks_per_second).velocity.x == -240.0);
    REQUIRE(bounced.events.size() == 1);
    CHECK(bounced.events.front().kind == ContactKind::right_wall);
    CHECK(bounced.body().mode() == Mode::ground);
}

TEST_CASE("a pinned body stands on ledges with the part of it that is seen") {
    const Size wide{2000, 100};
    const FreeSpace space =
        FreeSpace::among({screen}, wide).with_ledges(std::vector<Ledge>{{400, 900, 600}}, wide);
    REQUIRE(space.overhang().x == 200.0);
    Run run({law_from({}), space, {0.0, 0.0}, {}});
    CHECK(run.at(60 * ticks_per_second).position == Vec2{0.0, 500.0});
}

TEST_CASE("roundings alone carry nobody through a ledge") {
    const FreeSpace space = screen_with({{400, 900, 600}});
    const double past = std::nextafter(500.0, 501.0);
    CHECK(space.above_ledges(400.0, {600.0, past}) == Vec2{600.0, 500.0});
    CHECK(space.above_ledges(500.0, {600.0, past}) == Vec2{600.0, 500.0});
    // Who comes from below, or from beside it, is let through.
    CHECK(space.above_ledges(past, {600.0, past}) == Vec2{600.0, past});
    CHECK(space.above_ledges(400.0, {950.0, past}) == Vec2{950.0, past});
    CHECK(space.above_ledges(400.0, {600.0, 500.1}) == Vec2{600.0, 500.1});
}

TEST_CASE("no ledges leave the space as it was") {
    const FreeSpace plain = FreeSpace::among({screen}, pet);
    CHECK(plain.with_ledges({}, pet) == plain);
    CHECK(screen_with({{1, 2, 3}}).with_ledges({}, pet) == plain);
    CHECK_FALSE(screen_with({{1, 2, 3}}).is_box());
}

TEST_CASE("nobody ever falls through a ledge, with any integrator that locates impacts") {
    constexpr double dt = 1.0 / 500;
    std::array<int, locating.size()> landings{};
    for (std::uint64_t seed = 1; seed <= 600; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene = random_ledge_scene(random);
        // What an explicit method cannot follow has tests of its own.
        scene.law.drag = std::min(scene.law.drag, 1.0);
        for (std::size_t i = 0; i < (seed % 8 == 0 ? locating.size() : 1); ++i) {
            CAPTURE(i);
            Moving body(scene, locating.at(i));
            Vec2 before = scene.space.nearest(scene.position);
            int through = 0;
            for (int frame = 1; frame <= 1000; ++frame) {
                const Vec2 here = body.at(from_seconds(frame * dt)).position;
                const double margin = speed_limit(scene, frame * dt) * dt;
                for (const Barrier& ledge : scene.space.ledges()) {
                    through += fell_through(ledge, before, here, margin) ? 1 : 0;
                    landings.at(i) += here.y == ledge.at ? 1 : 0;
                }
                before = here;
            }
            CHECK(through == 0);
        }
    }
    for (const int count : landings) {
        CHECK(count > 1000);
    }
}

TEST_CASE("rising through ledges costs nothing: the bits are those without them") {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene with = random_ledge_scene(random);
        with.velocity.y = -std::fabs(with.velocity.y) - 100.0;
        Scene without = with;
        without.space = with.space.with_ledges({}, {});
        Run through(with);
        Run free(without);
        for (int read = 0; read < 50; ++read) {
            const BodyState expected = free.at(read * 20'000'000LL);
            if (expected.velocity.y >= 0.0 || expected.mode != Mode::air) {
                break;
            }
            CHECK(same_bits(through.at(read * 20'000'000LL), expected));
            ++compared;
        }
    }
    MESSAGE(compared, " places");
    CHECK(compared > 5000);
}

TEST_CASE("how often a body among ledges is read changes no bit") {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_ledge_scene(random);
        Run often(scene);
        Run once(scene);
        const Ticks end = 2 * ticks_per_second;
        const BodyState expected = once.at(end);
        // Who has given up has done so at a moment of reading.
        if (once.events.size() >= Trajectory::most_events) {
            continue;
        }
        for (Ticks now = 0; now < end; now += random.ticks(ticks_per_second / 20)) {
            often.at(now);
        }
        CHECK(same_bits(often.at(end), expected));
        CHECK(often.events.size() == once.events.size());
        ++compared;
    }
    CHECK(compared > 280);
}

TEST_CASE("tiny steps among ledges lead to the same places") {
    constexpr int steps_per_second = 40'000;
    double worst = 0.0;
    int compared = 0;
    int landings = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene{law_from({}), FreeSpace::among({screen}, pet), {}, {}};
        scene.position = random_place(random, scene.space);
        scene.velocity = random_velocity(random, 100.0, 1200.0);
        scene.space = scene.space.with_ledges(random_ledges(random, scene.space), {});
        Run exact(scene);
        // Where a pixel more or less at the start decides what is met, tiny steps prove nothing.
        Scene shifted = scene;
        shifted.position = scene.space.nearest(scene.position + Vec2{1.0, 0.5});
        Run other(shifted);
        TinySteps tiny(scene);
        for (int step = 1; step <= 2 * steps_per_second; ++step) {
            tiny.step(1.0 / steps_per_second);
            if (step % (steps_per_second / 4) == 0) {
                const Ticks now = ticks_per_second / steps_per_second * step;
                const Vec2 here = exact.at(now).position;
                other.at(now);
                if (exact.events.size() != other.events.size() ||
                    distance(here, other.at(now).position) > 3.0) {
                    break;
                }
                const double miss = distance(here, tiny.position());
                worst = std::max(worst, miss);
                ++compared;
                landings += std::ranges::any_of(scene.space.ledges(), [&](const Barrier& ledge) {
                    return std::fabs(ledge.at - here.y) < 1.0;
                });
                CHECK(miss <= 3.0);
            }
        }
    }
    MESSAGE(compared, " places, ", landings, " of them on a ledge, worst ", worst, " px");
    CHECK(compared > 150);
    CHECK(landings > 20);
}
