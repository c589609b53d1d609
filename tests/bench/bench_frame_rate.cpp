// SPDX-License-Identifier: MIT
#include "tests/bench/bench_frame_rate.h"

#include "tests/bench/meter.h"
#include "tests/bench/movers.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <ostream>
#include <random>

namespace hyrax::bench {
namespace {

constexpr Size room{1'000'000, 952};
constexpr Vec2 velocity{600.0, 0.0};
// Of the continuous model, from the 50-digit solver [px].
constexpr double exact_way = 1859.47409181105;
constexpr double seconds = 12.0;
constexpr double visible = 0.5;
constexpr double tolerance = 1e-9;
constexpr int jittered_runs = 200;

// The length of a frame [s].
struct Pace {
    std::string name;
    double frame = 0.0;
    double every_other = 0.0;  // 0: all the same.
    bool jittered = false;     // Evenly between the two.
};

const std::array<Pace, 10> paces{{
    {.name = "24 Hz", .frame = 1.0 / 24},
    {.name = "30 Hz", .frame = 1.0 / 30},
    {.name = "60 Hz", .frame = 1.0 / 60},
    {.name = "120 Hz", .frame = 1.0 / 120},
    {.name = "144 Hz", .frame = 1.0 / 144},
    {.name = "240 Hz", .frame = 1.0 / 240},
    {.name = "1000 Hz", .frame = 1.0 / 1000},
    {.name = "100 kHz", .frame = 1.0 / 100'000},
    {.name = "8.3 to 25 ms", .frame = 1.0 / 120, .every_other = 1.0 / 40, .jittered = true},
    {.name = "1/48 1/144 s", .frame = 1.0 / 48, .every_other = 1.0 / 144},
}};

struct Outcome {
    std::array<double, 3> peaks{};
    double last_motion = 0.0;
    double way = 0.0;
};

// Turning points of a sampled height.
class Peaks {
public:
    void add(double height) {
        const bool fell = height < last_;
        if (rising_ && fell && found_ < peaks_.size()) {
            peaks_[found_++] = last_;
        }
        rising_ = height > last_ || (rising_ && !fell);
        last_ = height;
    }
    const std::array<double, 3>& heights() const { return peaks_; }

private:
    std::array<double, 3> peaks_{};
    std::size_t found_ = 0;
    double last_ = room.height;
    bool rising_ = false;
};

class Frames {
public:
    Frames(const Pace& pace, unsigned seed) : pace_(&pace), bits_(seed) {}

    double next() {
        if (pace_->every_other == 0.0) {
            return pace_->frame;
        }
        if (pace_->jittered) {
            const double share = static_cast<double>(bits_() >> 11) * 0x1p-53;
            return pace_->frame + share * (pace_->every_other - pace_->frame);
        }
        odd_ = !odd_;
        return odd_ ? pace_->frame : pace_->every_other;
    }

private:
    const Pace* pace_;
    std::mt19937_64 bits_;
    bool odd_ = false;
};

Outcome run(Method method, const BodyScene& scene, const Pace& pace, unsigned seed) {
    return with_mover(method, scene, tolerance, [&](auto mover) {
        Frames frames(pace, seed);
        Peaks peaks;
        std::vector<Vec2> places;
        std::vector<double> times;
        double now = 0.0;
        while (now < seconds) {
            const double dt = frames.next();
            now += dt;
            places.push_back(mover.go_to(from_seconds(now), dt));
            times.push_back(now);
            peaks.add(room.height - places.back().y);
        }
        const Vec2 end = places.back();
        std::size_t last = places.size();
        while (last > 0 &&
               std::hypot(places[last - 1].x - end.x, places[last - 1].y - end.y) <= visible) {
            --last;
        }
        return Outcome{
            .peaks = peaks.heights(),
            .last_motion = last == places.size() ? now : times[last],
            .way = end.x,
        };
    });
}

Outcome mean(Method method, const BodyScene& scene, const Pace& pace) {
    const int runs = pace.jittered ? jittered_runs : 1;
    Outcome sum;
    for (int seed = 0; seed < runs; ++seed) {
        const Outcome one = run(method, scene, pace, static_cast<unsigned>(seed));
        for (std::size_t i = 0; i < sum.peaks.size(); ++i) {
            sum.peaks[i] += one.peaks[i] / runs;
        }
        sum.last_motion += one.last_motion / runs;
        sum.way += one.way / runs;
    }
    return sum;
}

}  // namespace

void frame_rate(std::ostream& table, std::ostream& csv) {
    const BodyScene scene = box_scene({}, room, {0.0, 0.0}, velocity);
    Progress progress("frame-rate", methods.size() * paces.size());
    csv << "method,pace,hz,peak_1,peak_2,peak_3,last_motion,way,error\n";
    for (const auto& [method, name] : methods) {
        table << fmt::format(
            "\n{}: exact are 316.470, 108.788, 38.115 px, rest at 4.96 s after {:.3f} px\n"
            "{:<14}{:>9}{:>9}{:>9}{:>14}{:>10}{:>11}\n",
            name,
            exact_way,
            "frames",
            "peak 1",
            "peak 2",
            "peak 3",
            "last motion s",
            "way px",
            "error px"
        );
        for (const Pace& pace : paces) {
            const Outcome o = mean(method, scene, pace);
            const double error = o.way - exact_way;
            table << fmt::format(
                "{:<14}{:>9.2f}{:>9.2f}{:>9.2f}{:>14.2f}{:>10.2f}{:>11.3f}\n",
                pace.name,
                o.peaks[0],
                o.peaks[1],
                o.peaks[2],
                o.last_motion,
                o.way,
                error
            );
            csv << fmt::format(
                "{},{},{:.6g},{:.3f},{:.3f},{:.3f},{:.3f},{:.6f},{:.4e}\n",
                name,
                pace.name,
                pace.every_other == 0.0 ? 1.0 / pace.frame : 0.0,
                o.peaks[0],
                o.peaks[1],
                o.peaks[2],
                o.last_motion,
                o.way,
                error
            );
            progress.step();
        }
    }
}

}  // namespace hyrax::bench
