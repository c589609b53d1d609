// SPDX-License-Identifier: MIT
#include "tests/bench/bench_trajectory.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace hyrax::bench {
namespace {

constexpr std::array<std::pair<const char*, Integrator>, 6> integrators{{
    {"event_driven", Integrator::event_driven},
    {"semi_implicit_euler", Integrator::semi_implicit_euler},
    {"semi_implicit_euler_fixed", Integrator::semi_implicit_euler_fixed},
    {"exponential_swept", Integrator::exponential_swept},
    {"stormer_verlet", Integrator::stormer_verlet},
    {"rk45", Integrator::rk45},
}};

constexpr const char* mode_names[] = {"air", "ground", "rest"};

// Longer spans do not fit into ticks.
constexpr double latest = 1e9;
constexpr double most_samples = 1e7;

Integrator integrator_named(const std::string& name) {
    for (const auto& [known, integrator] : integrators) {
        if (name == known) {
            return integrator;
        }
    }
    throw std::runtime_error(fmt::format("there is no integrator \"{}\"", name));
}

std::vector<Rect> monitors_of(const std::string& text) {
    std::vector<Rect> monitors;
    const char* rest = text.c_str();
    while (*rest != '\0') {
        Rect m;
        int length = 0;
        const int found =
            std::sscanf(rest, "%dx%d%d%d%n", &m.width, &m.height, &m.x, &m.y, &length);
        if (found != 4 || m.empty() || (rest[length] != ',' && rest[length] != '\0')) {
            throw std::runtime_error(
                fmt::format("expected WIDTHxHEIGHT+X+Y (such as 1920x1080+0+0), got \"{}\"", rest)
            );
        }
        monitors.push_back(m);
        rest += length + (rest[length] == ',' ? 1 : 0);
    }
    return monitors;
}

void check(bool holds, const char* what) {
    if (!holds) {
        throw std::runtime_error(what);
    }
}

bool is_share(double number) {
    return number >= 0.0 && number <= 1.0;
}

void check_numbers(const TrajectoryOptions& o) {
    const auto finite = [](double number) { return std::isfinite(number); };
    check(o.at.size() == 2 && std::ranges::all_of(o.at, finite), "at: wants x,y");
    check(
        o.velocity.size() == 2 && std::ranges::all_of(o.velocity, finite), "velocity: wants vx,vy"
    );
    check(
        o.box.empty() || (o.box.size() == 4 && std::ranges::all_of(o.box, finite)),
        "box: wants left,top,right,bottom"
    );
    check(
        o.box.empty() || (o.box[0] <= o.box[2] && o.box[1] <= o.box[3]),
        "box: wants left <= right and top <= bottom"
    );
    check(o.box.empty() || o.monitors.empty(), "give a box or monitors, not both");
    check(o.size.size() == 2 && o.size[0] >= 0 && o.size[1] >= 0, "size: wants width,height");
    const PhysicsConstants& c = o.constants;
    check(std::isfinite(c.gravity) && c.gravity >= 0.0, "gravity: wants a number >= 0");
    check(is_share(c.restitution), "restitution: wants a number from 0 to 1");
    check(is_share(c.air_drag), "air_drag: wants a number from 0 to 1");
    check(is_share(c.ground_friction), "ground_friction: wants a number from 0 to 1");
    check(
        std::isfinite(c.rest_threshold) && c.rest_threshold >= 0.0,
        "rest_threshold: wants a number >= 0"
    );
    check(
        std::isfinite(o.reference_rate) && o.reference_rate > 0.0,
        "reference_rate: wants a number > 0"
    );
    check(o.frame >= 1e-9 && o.frame <= latest, "frame: wants a number of seconds");
    check(o.every >= 1e-9 && o.every <= latest, "every: wants a number of seconds");
    check(o.until >= 0.0 && o.until <= latest, "until: wants a number of seconds");
    check(o.until / o.every <= most_samples, "every: too small for this many seconds");
}

std::vector<Ticks> times_of(const TrajectoryOptions& options) {
    std::vector<Ticks> times;
    if (options.times.empty()) {
        for (long i = 0; static_cast<double>(i) * options.every <= options.until * (1.0 + 1e-12);
             ++i) {
            times.push_back(from_seconds(static_cast<double>(i) * options.every));
        }
    }
    for (const double time : options.times) {
        check(time >= 0.0 && time <= latest, "times: wants numbers of seconds");
        times.push_back(from_seconds(time));
        check(
            times.size() < 2 || times[times.size() - 2] <= times.back(), "times: wants them sorted"
        );
    }
    return times;
}

struct Place {
    FreeSpace space;
    Rect home;
    Size size;
};

// The document's law knows one box of whole pixels: the first monitor.
Place place_of(const TrajectoryOptions& o) {
    const Size size{o.size[0], o.size[1]};
    if (!o.monitors.empty()) {
        const std::vector<Rect> monitors = monitors_of(o.monitors);
        return {FreeSpace::among(monitors, size), monitors.front(), size};
    }
    if (o.box.empty()) {
        check(o.integrator != "semi_implicit_euler", "the document's law wants a box");
        return {};
    }
    for (const double side : o.box) {
        check(
            o.integrator != "semi_implicit_euler" ||
                (side == std::floor(side) && std::fabs(side) < 1e9),
            "the document's law wants a box of whole numbers"
        );
    }
    const auto whole = [&](std::size_t i) {
        return static_cast<int>(std::clamp(o.box[i], -1e9, 1e9));
    };
    return {
        FreeSpace::box(o.box[0], o.box[1], o.box[2], o.box[3]),
        {whole(0), whole(1), whole(2) - whole(0), whole(3) - whole(1)},
        {}
    };
}

template <typename Value>
void take(nlohmann::json& json, const char* name, Value& value) {
    if (json.contains(name)) {
        json.at(name).get_to(value);
        json.erase(name);
    }
}

}  // namespace

void read_scene(const std::filesystem::path& file, TrajectoryOptions& o) {
    std::ifstream stream(file);
    check(stream.good(), "the scene's file cannot be read");
    try {
        nlohmann::json json = nlohmann::json::parse(stream, nullptr, true, true);
        take(json, "at", o.at);
        take(json, "velocity", o.velocity);
        take(json, "box", o.box);
        take(json, "monitors", o.monitors);
        take(json, "size", o.size);
        take(json, "gravity", o.constants.gravity);
        take(json, "restitution", o.constants.restitution);
        take(json, "air_drag", o.constants.air_drag);
        take(json, "ground_friction", o.constants.ground_friction);
        take(json, "rest_threshold", o.constants.rest_threshold);
        take(json, "reference_rate", o.reference_rate);
        take(json, "integrator", o.integrator);
        take(json, "frame", o.frame);
        take(json, "times", o.times);
        take(json, "every", o.every);
        take(json, "until", o.until);
        if (!json.empty()) {
            throw std::runtime_error(
                fmt::format("{}: there is no \"{}\"", file.string(), json.begin().key())
            );
        }
    } catch (const nlohmann::json::exception& error) {
        throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
    }
}

void trajectory(std::ostream& csv, const TrajectoryOptions& options) {
    check_numbers(options);
    const std::vector<Ticks> times = times_of(options);
    const MotionRules rules{
        .integrator = integrator_named(options.integrator),
        .constants = options.constants,
        .law = law_from(options.constants, options.reference_rate),
    };
    const Place place = place_of(options);
    const Surroundings around{place.space, place.home, place.size};
    Body body;
    body.launch(
        {options.at[0], options.at[1]},
        {options.velocity[0], options.velocity[1]},
        rules,
        around,
        WallEvents::wanted
    );
    body.start(0);

    csv << "t,x,y,vx,vy,mode,contacts\n";
    long contacts = 0;
    const auto count = [&](const TrajectoryEvent&) { ++contacts; };
    long frame = 1;
    Ticks now = 0;
    for (const Ticks time : times) {
        for (Ticks next = 0; rules.integrator != Integrator::event_driven; ++frame) {
            next = from_seconds(static_cast<double>(frame) * options.frame);
            if (next >= time) {
                break;
            }
            if (next >
                now) {  // A frame without time is no frame: the document's law would damp it.
                body.advance(next, rules, around, count);
            }
        }
        if (time > now) {
            body.advance(time, rules, around, count);
            now = time;
        }
        const BodyState s = body.at(time, rules, around);
        csv << fmt::format(
            "{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{},{}\n",
            to_seconds(time),
            s.position.x,
            s.position.y,
            s.velocity.x,
            s.velocity.y,
            mode_names[static_cast<int>(body.mode())],
            contacts
        );
    }
}

}  // namespace hyrax::bench
