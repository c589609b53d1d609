// SPDX-License-Identifier: MIT
#include "tests/core/engine_seen.h"

#include <cmath>
#include <limits>

using namespace hyrax;

namespace {

const EngineSettings document_law{.integrator = Integrator::semi_implicit_euler};

}  // namespace

TEST_CASE("a pet's first frame shows it where it was put, the second moves it by one step") {
    World world(document_law);
    const PetId id = world.spawn({100.0, 0.0}, {600.0, 0.0});
    world.engine.advance(0);
    CHECK(world.pet(id).position() == Vec2{100.0, 0.0});
    world.engine.advance(frame);

    physics expected(100.0, 0.0, 600.0, 0.0);
    expected.update(to_seconds(frame), 1920, 1080, box.width, box.height);
    CHECK(world.pet(id).position() == Vec2{expected.x(), expected.y()});
    CHECK(world.pet(id).velocity() == Vec2{expected.vx(), expected.vy()});
}

TEST_CASE("a pet follows the document's law frame by frame, to the bit") {
    World world(document_law);
    const PetId id = world.spawn({100.0, 0.0}, {600.0, -200.0});
    physics expected(100.0, 0.0, 600.0, -200.0);
    world.engine.advance(0);
    for (int i = 1; i < 120; ++i) {
        world.engine.advance(i * frame);
        expected.update(to_seconds(frame), 1920, 1080, box.width, box.height);
        REQUIRE(world.pet(id).position() == Vec2{expected.x(), expected.y()});
    }
}

TEST_CASE("a dropped pet comes to rest on the floor and then costs nothing") {
    World world;
    const PetId id = world.spawn({300.0, 0.0}, {250.0, 0.0});
    CHECK(world.engine.moving());
    world.run(8.0);
    CHECK_FALSE(world.engine.moving());
    CHECK(world.pet(id).motion == Motion::settled);
    CHECK(world.pet(id).velocity() == Vec2{});
    CHECK(world.pet(id).position().y == 1080.0 - box.height);

    const Pet before = world.pet(id);
    world.run(60.0);
    CHECK(same(world.pet(id), before));
}

TEST_CASE("pets come to rest at every frame rate, whatever moves them") {
    for (const Integrator integrator : integrators) {
        for (const double fps : {24.0, 30.0, 60.0, 75.0, 120.0, 144.0, 240.0}) {
            CAPTURE(integrator);
            CAPTURE(fps);
            World world({.integrator = integrator});
            const PetId id = world.spawn({300.0, 0.0}, {250.0, 0.0});
            Ticks now = 0;
            while (world.engine.moving() && now < 20 * ticks_per_second) {
                world.engine.advance(now);
                now += from_seconds(1.0 / fps);
            }
            CHECK_FALSE(world.engine.moving());
            CHECK(now > ticks_per_second);
            CHECK(world.pet(id).position().y == 1080.0 - box.height);
            CHECK(world.pet(id).motion == Motion::settled);
        }
    }
}

TEST_CASE("all integrators but the document's agree about where a pet comes to rest") {
    std::vector<double> places;
    for (const Integrator integrator : integrators) {
        World world({.integrator = integrator});
        const PetId id = world.spawn({300.0, 500.0}, {400.0, 0.0});
        world.run(10.0);
        places.push_back(world.pet(id).position().x);
    }
    CHECK(places[2] == doctest::Approx(places[0]).epsilon(0.02));  // First order.
    CHECK(std::fabs(places[3] - places[0]) < 1e-8);
    CHECK(std::fabs(places[4] - places[0]) < 0.1);
    CHECK(std::fabs(places[5] - places[0]) < 1e-2);
    CHECK(std::fabs(places[1] - places[0]) > 1.0);
}

TEST_CASE("a force that has no closed form makes rk45 the integrator, and is felt") {
    EngineSettings settings{.physics = {.air_drag = 1.0}};
    CHECK(World(settings).engine.integrator() == Integrator::event_driven);
    settings.forces.quadratic_drag = 0.001;
    World world(settings);
    CHECK(world.engine.integrator() == Integrator::rk45);
    world.engine.set_arena(Arena({monitor({0, 0, 1920, 30000})}, FloorEdge::screen));
    const PetId id = world.spawn({300.0, 0.0});
    world.run(8.0);
    // sqrt(gravity / quadratic_drag)
    CHECK(world.pet(id).velocity().y == doctest::Approx(1095.445).epsilon(1e-4));
}

TEST_CASE("by default a frame rate changes nothing") {
    const auto place_at = [](double fps) {
        World world;
        const PetId id = world.spawn({300.0, 0.0}, {250.0, 0.0});
        for (int i = 0; i <= static_cast<int>(2.0 * fps); ++i) {
            world.engine.advance(from_seconds(i / fps));
        }
        return world.pet(id).position();
    };
    const Vec2 at_60 = place_at(60.0);
    for (const double fps : {1.0, 24.0, 144.0, 1000.0}) {
        CHECK(place_at(fps) == at_60);
    }
}

TEST_CASE("a bounce is not mistaken for rest") {
    for (const Integrator integrator : integrators) {
        CAPTURE(integrator);
        World world(
            {.physics = {.restitution = 1.0, .air_drag = 1.0, .ground_friction = 1.0},
             .integrator = integrator}
        );
        world.spawn({300.0, 500.0});
        world.run(20.0);
        CHECK(world.engine.moving());
    }
}

TEST_CASE("without gravity a pet floats, and slow ones stop where they are") {
    World world({.physics = {.gravity = 0.0}});
    const PetId id = world.spawn({300.0, 500.0}, {10.0, 0.0});
    world.run(15.0);
    CHECK_FALSE(world.engine.moving());
    CHECK(world.pet(id).position().y == 500.0);

    CHECK(world.engine.configure({}));
    CHECK(world.engine.moving());
    world.run(5.0);
    CHECK(world.pet(id).position().y == 1080.0 - box.height);
}

TEST_CASE("fling sets the velocity, push adds to it, stop ends it") {
    World world;
    const PetId id = world.spawn({300.0, 500.0}, {7.0, 9.0});
    CHECK(world.engine.fling(id, {100.0, -300.0}));
    CHECK(world.pet(id).velocity() == Vec2{100.0, -300.0});
    CHECK(world.engine.push(id, {-50.0, 10.0}));
    CHECK(world.pet(id).velocity() == Vec2{50.0, -290.0});
    CHECK(world.engine.stop(id));
    CHECK(world.pet(id).velocity() == Vec2{});
    CHECK(world.pet(id).position() == Vec2{300.0, 500.0});
}

TEST_CASE("fling wakes a pet that rests") {
    World world;
    const PetId id = world.spawn({300.0, 1000.0});
    world.run(5.0);
    REQUIRE_FALSE(world.engine.moving());
    CHECK(world.engine.fling(id, {0.0, -500.0}));
    CHECK(world.engine.moving());
    world.run(0.2);
    CHECK(world.pet(id).motion == Motion::airborne);
    CHECK(world.pet(id).position().y < 1000.0);
}

TEST_CASE("a long sleep is not caught up") {
    for (const Integrator integrator : integrators) {
        CAPTURE(integrator);
        World world({.integrator = integrator});
        const PetId id = world.spawn({300.0, 1000.0});
        world.run(5.0);
        REQUIRE_FALSE(world.engine.moving());
        CHECK(world.engine.fling(id, {0.0, -100.0}));
        world.engine.advance(3600 * ticks_per_second);
        CHECK(world.pet(id).velocity() == Vec2{0.0, -100.0});
        // A hitch in flight ends in rest, or, by the document's law, after a tenth of a second.
        const double before = world.pet(id).position().y;
        world.engine.advance(7200 * ticks_per_second);
        CHECK(std::fabs(world.pet(id).position().y - before) < 0.1 * 1200.0);
    }
}

TEST_CASE("reset puts a pet back where it was spawned, at rest") {
    World world;
    const PetId id = world.spawn({300.0, 200.0}, {400.0, 0.0});
    world.run(1.0);
    CHECK(world.engine.reset(id));
    CHECK(world.pet(id).position() == Vec2{300.0, 200.0});
    CHECK(world.pet(id).velocity() == Vec2{});

    const PetId second = world.spawn({700.0, 100.0});
    world.run(1.0);
    world.engine.reset_all();
    CHECK(world.pet(id).position() == Vec2{300.0, 200.0});
    CHECK(world.pet(second).position() == Vec2{700.0, 100.0});
}

TEST_CASE("new pets are rationed once as many have come as there may be") {
    World world({.max_pets = 3, .max_spawn_rate = 2.0});
    const auto come_and_go = [&world] {
        const Result<PetId> id = world.engine.spawn({});
        if (id) {
            REQUIRE(world.engine.remove(*id));
        }
        return id.has_value();
    };
    world.engine.advance(ticks_per_second);
    for (int i = 0; i < 3 + 2; ++i) {
        CHECK(come_and_go());
    }
    CHECK_FALSE(come_and_go());
    CHECK(world.engine.spawn({}).error().message.contains("limit of 2 new pets a second"));
    world.engine.advance(2 * ticks_per_second);
    CHECK(come_and_go());
    CHECK(come_and_go());
    CHECK_FALSE(come_and_go());
}

TEST_CASE("the population is capped") {
    World world({.physics = {}, .max_pets = 3});
    for (int i = 0; i < 3; ++i) {
        CHECK(world.engine.spawn({}));
    }
    const Result<PetId> refused = world.engine.spawn({});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.contains("limit of 3 pets"));
    CHECK(world.engine.size() == 3);
    world.engine.clear();
    CHECK(world.engine.size() == 0);
    CHECK(world.engine.spawn({}));
}

TEST_CASE("a stale id is an ordinary error, also when the slot has a new owner") {
    World world;
    const PetId old = world.spawn({300.0, 200.0});
    CHECK(world.engine.remove(old));
    const PetId fresh = world.spawn({300.0, 200.0});
    CHECK(fresh.index == old.index);
    const Pet before = world.pet(fresh);

    CHECK_FALSE(world.engine.remove(old));
    CHECK_FALSE(world.engine.fling(old, {1.0, 1.0}));
    CHECK_FALSE(world.engine.push(old, {1.0, 1.0}));
    CHECK_FALSE(world.engine.stop(old));
    CHECK_FALSE(world.engine.reset(old));
    CHECK_FALSE(world.engine.move_to(old, {1.0, 1.0}));
    CHECK_FALSE(world.engine.grab(old, 0));
    CHECK_FALSE(world.engine.carry(old, {1.0, 1.0}, 0));
    CHECK_FALSE(world.engine.let_go(old, 0, 1.0));
    CHECK_FALSE(world.engine.set_tag(old, "x"));
    CHECK(world.engine.find(PetId{}) == nullptr);
    CHECK(same(world.pet(fresh), before));
}

TEST_CASE("numbers that are not finite are refused and change nothing") {
    World world;
    const PetId id = world.spawn({300.0, 200.0}, {10.0, 20.0});
    world.run(0.1);
    const Pet before = world.pet(id);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(),
          std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
        CAPTURE(bad);
        for (const Vec2 numbers : {Vec2{bad, 0.0}, Vec2{0.0, bad}}) {
            CHECK_FALSE(world.engine.fling(id, numbers));
            CHECK_FALSE(world.engine.push(id, numbers));
            CHECK_FALSE(world.engine.move_to(id, numbers));
            CHECK_FALSE(world.engine.carry(id, numbers, 0));
            CHECK_FALSE(world.engine.spawn({.at = numbers}));
            CHECK_FALSE(world.engine.spawn({.at = {}, .velocity = numbers}));
        }
    }
    CHECK(same(world.pet(id), before));
    CHECK(world.engine.size() == 1);
    const Result<void> refused = world.engine.fling(id, {std::nan(""), 1.0});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message == "fling: expected finite numbers, got (nan, 1)");
}

TEST_CASE("huge numbers are shortened, and the pet stays in the arena") {
    World world;
    const double huge = std::numeric_limits<double>::max();
    const PetId id = world.spawn({huge, -huge}, {huge, huge});
    CHECK(
        std::hypot(world.pet(id).velocity().x, world.pet(id).velocity().y) <= 20'000.0 * (1 + 1e-12)
    );
    CHECK(world.pet(id).position() == Vec2{1920.0 - box.width, 0.0});
    CHECK(world.engine.push(id, {huge, huge}));
    CHECK(world.engine.push(id, {huge, huge}));
    world.run(3.0);
    CHECK(std::isfinite(world.pet(id).position().x));
}

TEST_CASE("an unknown kind is refused by name") {
    World world;
    const Result<PetId> refused = world.engine.spawn({.kind = "unicorn"});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message == "spawn: there is no kind of pet named \"unicorn\"");
}

TEST_CASE("without a monitor nothing can be spawned, and nothing breaks") {
    Engine engine({{"hyrax", box}}, {}, 1);
    CHECK_FALSE(engine.spawn({}));
    engine.advance(0);
    engine.reset_all();
    engine.fling_all();
    engine.clear();
    CHECK_FALSE(engine.moving());
}

TEST_CASE("bounces and landings are told with side and speed") {
    World world({.physics = {.gravity = 0.0, .air_drag = 1.0}});
    world.spawn({1000.0, 500.0}, {-3000.0, 0.0});
    world.run(1.0);
    const std::vector<Event> events = world.engine.take_events();
    REQUIRE(events.size() >= 2);
    CHECK(events[0].kind == EventKind::spawn);
    CHECK(events[1].kind == EventKind::bounce);
    CHECK(events[1].side == Side::left);
    CHECK(events[1].speed == doctest::Approx(3000.0).epsilon(1e-12));

    World falling;
    falling.spawn({300.0, 0.0});
    falling.run(10.0);
    int floors = 0;
    int landings = 0;
    double first_speed = 0.0;
    for (const Event& event : falling.engine.take_events()) {
        floors += event.kind == EventKind::bounce && event.side == Side::bottom ? 1 : 0;
        if (event.kind == EventKind::land) {
            ++landings;
            first_speed = event.speed;
        }
    }
    CHECK(landings == 1);
    CHECK(floors >= 4);
    CHECK(floors <= 14);
    // sqrt(2 * 1200 * 1000), less a little drag.
    CHECK(first_speed == doctest::Approx(1549.0).epsilon(0.05));
}

TEST_CASE("events that nobody listens to are not built") {
    World world;
    world.engine.listen({});
    world.spawn({300.0, 0.0});
    world.run(5.0);
    CHECK_FALSE(world.engine.has_events());
}
