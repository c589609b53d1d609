// SPDX-License-Identifier: MIT
#include "tests/bench/bench_scene_cost.h"

#include "physics/body.h"
#include "physics/spring.h"
#include "tests/support/batch_identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

namespace hyrax::bench {
namespace {

constexpr std::size_t pets = 1000;
constexpr int rate = 60;
constexpr int frames = 120;
constexpr Size screen{1792, 952};
constexpr double far = 1e9;
constexpr double quick = 1e5;  // [px/s]: 56 walls a second.
constexpr Vec2 middle{0.5 * screen.width, 0.5 * screen.height};

Ticks frame_time(int frame) {
    return frame * ticks_per_second / rate;
}

struct Launch {
    Vec2 position;
    Vec2 velocity;
};

struct Case {
    PhysicsConstants constants;
    FreeSpace space;
    std::vector<Launch> launches;
    WallEvents walls = WallEvents::wanted;
};

FreeSpace walls_near() {
    return FreeSpace::box(0.0, 0.0, screen.width, screen.height);
}

FreeSpace walls_far() {
    return FreeSpace::box(-far, -far, far, far);
}

FreeSpace long_floor() {
    return FreeSpace::box(-far, -far, far, screen.height);
}

// Different for each pet, so that branches cost what they do on a desktop.
std::vector<Launch> flings(double fastest) {
    RandomBits random(1);
    std::vector<Launch> launches;
    for (std::size_t i = 0; i < pets; ++i) {
        const Vec2 position{random.between(0.0, screen.width), random.between(0.0, screen.height)};
        launches.push_back(
            {position, {random.between(-fastest, fastest), random.between(-fastest, fastest)}}
        );
    }
    return launches;
}

std::vector<Launch> same_for_all(Vec2 position, Vec2 velocity) {
    return {pets, Launch{position, velocity}};
}

std::vector<Trajectory> launched(const Case& scene, const Law& law) {
    std::vector<Trajectory> made(pets);
    for (std::size_t i = 0; i < pets; ++i) {
        const auto& [position, velocity] = scene.launches[i];
        made[i].launch(0, position, velocity, law, scene.space, scene.walls);
    }
    return made;
}

class SceneCost {
public:
    SceneCost(std::ostream& table, std::ostream& csv, Meter& meter)
        : table_(table), csv_(csv), meter_(meter), progress_("scene-cost", 24) {
        csv_ << "group,case,ns,instructions,events_per_frame\n";
    }

    void title(const std::string& group, const std::string& what) {
        group_ = group;
        table_ << fmt::format("\n{:<58}{:>10}{:>14}{:>12}\n", what, "ns", "instructions", "events");
    }

    void line(const std::string& name, Cost cost, double events = 0.0) {
        table_ << fmt::format("{:<58}", name) << short_number(cost.nanoseconds) << "    "
               << short_number(cost.instructions) << fmt::format("{:>12.4f}\n", events)
               << std::flush;
        csv_ << fmt::format(
            "{},\"{}\",{:.4g},{:.5g},{:.4g}\n",
            group_,
            name,
            cost.nanoseconds,
            cost.instructions,
            events
        );
        progress_.step();
    }

    // Two seconds of frames, each of which reads every pet.
    void frames_of(const std::string& name, const Case& scene) {
        const Law law = law_from(scene.constants);
        const std::vector<Trajectory> start = launched(scene, law);
        long events = 0;
        const auto work = [&] {
            std::vector<Trajectory> bodies = start;
            events = 0;
            double sum = 0.0;
            for (int frame = 1; frame <= frames; ++frame) {
                const Ticks now = frame_time(frame);
                for (Trajectory& body : bodies) {
                    body.advance(now, law, scene.space, [&](const TrajectoryEvent&) { ++events; });
                    const Vec2 place = body.position(now, law, scene.space);
                    sum += place.x + place.y;
                }
            }
            keep(sum);
        };
        constexpr double units = static_cast<double>(pets) * frames;
        const Cost cost = meter_.measure(work).per(units);
        line(name, cost, static_cast<double>(events) / units);
    }

    // Until all rest, without reading: the cost of an event alone.
    void events_of(const std::string& name, const Case& scene, Ticks until) {
        const Law law = law_from(scene.constants);
        const std::vector<Trajectory> start = launched(scene, law);
        long events = 0;
        const auto work = [&] {
            std::vector<Trajectory> bodies = start;
            events = 0;
            for (Trajectory& body : bodies) {
                body.advance(until, law, scene.space, [&](const TrajectoryEvent&) { ++events; });
            }
        };
        const Cost cost = meter_.measure(work);
        line(name, cost.per(static_cast<double>(std::max(events, 1L))));
    }

    void launch_of(const std::string& name, const Case& scene) {
        const Law law = law_from(scene.constants);
        std::vector<Trajectory> bodies(pets);
        const auto work = [&] {
            for (std::size_t i = 0; i < pets; ++i) {
                const auto& [position, velocity] = scene.launches[i];
                bodies[i].launch(0, position, velocity, law, scene.space, scene.walls);
            }
        };
        line(name, meter_.measure(work).per(pets));
    }

    void bodies_of(const std::string& name, const Case& scene, Integrator integrator);
    void held();
    void asleep();

private:
    std::ostream& table_;
    std::ostream& csv_;
    Meter& meter_;
    Progress progress_;
    std::string group_;
};

// Through the class that the engine has for any integrator.
void SceneCost::bodies_of(const std::string& name, const Case& scene, Integrator integrator) {
    const MotionRules rules{
        .integrator = integrator, .constants = scene.constants, .law = law_from(scene.constants)
    };
    const Surroundings around{scene.space, {0, 0, screen.width, screen.height}, {0, 0}};
    std::vector<Body> start(pets);
    for (std::size_t i = 0; i < pets; ++i) {
        const auto& [position, velocity] = scene.launches[i];
        start[i].launch(position, velocity, rules, around, scene.walls);
        start[i].start(0);
    }
    long events = 0;
    const auto work = [&] {
        std::vector<Body> bodies = start;
        events = 0;
        double sum = 0.0;
        for (int frame = 1; frame <= frames; ++frame) {
            const Ticks now = frame_time(frame);
            for (Body& body : bodies) {
                body.advance(now, rules, around, [&](const TrajectoryEvent&) { ++events; });
                const Vec2 place = body.at(now, rules, around).position;
                sum += place.x + place.y;
            }
        }
        keep(sum);
    };
    constexpr double units = static_cast<double>(pets) * frames;
    const Cost cost = meter_.measure(work).per(units);
    line(name, cost, static_cast<double>(events) / units);
}

// A cursor sample and a read in each frame.
void SceneCost::held() {
    std::vector<Spring> springs(pets, Spring({.frequency = 40.0, .damping_ratio = 0.7}));
    int frame = 0;
    const auto work = [&] {
        double sum = 0.0;
        for (const int end = frame + frames; frame < end; ++frame) {
            const Ticks now = frame_time(frame);
            const Vec2 cursor{middle.x + frame % 7, middle.y - frame % 5};
            for (Spring& spring : springs) {
                spring.follow(cursor, now);
                sum += spring.at(now).position.x;
            }
        }
        keep(sum);
    };
    line("held by a spring", meter_.measure(work).per(static_cast<double>(pets) * frames));
}

// As the engine has it: who sleeps is on no list, and the frame ends before it begins.
void SceneCost::asleep() {
    std::vector<Trajectory> all(pets);
    std::vector<std::size_t> awake;
    const Law law = law_from({});
    const FreeSpace space = walls_near();
    const auto work = [&] {
        double sum = 0.0;
        for (int frame = 1; frame <= frames; ++frame) {
            const Ticks now = frame_time(frame);
            for (const std::size_t index : awake) {
                all[index].advance(now, law, space, [](const TrajectoryEvent&) {});
                sum += all[index].position(now, law, space).x;
            }
            keep(sum);
        }
    };
    line("asleep, on no list", meter_.measure(work).per(static_cast<double>(pets) * frames));
}

}  // namespace

void scene_cost(std::ostream& table, std::ostream& csv, Meter& meter) {
    const PhysicsConstants full{};
    const PhysicsConstants no_drag{.air_drag = 1.0};
    const PhysicsConstants no_gravity{.gravity = 0.0};
    const PhysicsConstants neither{.gravity = 0.0, .air_drag = 1.0};
    PhysicsConstants lasting = neither;  // Bounces for ever between the walls.
    lasting.restitution = 1.0;
    const std::vector<Launch> usual = flings(1000.0);
    const std::vector<Launch> fast = same_for_all(middle, {quick, 0.0});
    const std::vector<Launch> sliding = same_for_all({0.0, screen.height}, {1e4, 0.0});
    const std::vector<Launch> resting = same_for_all({middle.x, screen.height}, {});
    // Friction so weak that the slide lasts longer than what is measured.
    const PhysicsConstants slippery{.ground_friction = 0.999};

    SceneCost cost(table, csv, meter);
    cost.title("frame", "a pet and frame at 60 Hz, 1000 pets, every one read");
    cost.asleep();
    cost.frames_of("at rest, read all the same", {full, walls_near(), resting});
    cost.frames_of("no gravity, no drag, walls far", {neither, walls_far(), usual});
    cost.frames_of("drag", {no_gravity, walls_far(), usual});
    cost.frames_of("gravity", {no_drag, walls_far(), usual});
    cost.frames_of("gravity, drag", {full, walls_far(), usual});
    cost.frames_of("no gravity, no drag, walls near", {lasting, walls_near(), usual});
    cost.frames_of("gravity, walls and floor near", {no_drag, walls_near(), usual});
    cost.frames_of("gravity, drag, walls and floor near: all", {full, walls_near(), usual});
    cost.frames_of("sliding", {slippery, long_floor(), sliding});
    cost.held();
    cost.frames_of("56 walls a second, each told", {lasting, walls_near(), fast});

    const FreeSpace narrow = FreeSpace::box(0.0, 0.0, 500.0, screen.height);
    const std::vector<Launch> in_narrow = same_for_all({250.0, middle.y}, {quick, 0.0});
    cost.frames_of("200 walls a second, each told", {lasting, narrow, in_narrow});
    cost.frames_of(
        "200 walls a second, folded: nobody listens",
        {lasting, narrow, in_narrow, WallEvents::not_wanted}
    );

    cost.title("body", "the same through class Body, as the engine calls it");
    const Case all{full, walls_near(), usual};
    cost.bodies_of("event_driven", all, Integrator::event_driven);
    cost.bodies_of("semi_implicit_euler (the document)", all, Integrator::semi_implicit_euler);
    cost.bodies_of("semi_implicit_euler_fixed", all, Integrator::semi_implicit_euler_fixed);
    cost.bodies_of("exponential_swept", all, Integrator::exponential_swept);
    cost.bodies_of("stormer_verlet", all, Integrator::stormer_verlet);
    cost.bodies_of("rk45", all, Integrator::rk45);

    cost.title("event", "one event with the schedule of the next, without reading");
    const Ticks until = 20 * ticks_per_second;
    const std::vector<Launch> drops = same_for_all({middle.x, 0.0}, {1.0, 0.0});
    cost.events_of("a bounce on the floor, no drag", {no_drag, walls_near(), drops}, until);
    cost.events_of("a bounce on the floor, drag", {full, walls_near(), drops}, until);
    cost.events_of("a wall, no gravity, no drag", {lasting, walls_near(), usual}, until);
    cost.events_of("a fling until rest, no drag", {no_drag, walls_near(), usual}, until);
    cost.events_of("a fling until rest, drag", {full, walls_near(), usual}, until);
    cost.launch_of("a launch, drag", {full, walls_near(), usual});
}

}  // namespace hyrax::bench
