// SPDX-License-Identifier: MIT
#include "tests/bench/meter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace hyrax::bench {
namespace {

using Clock = std::chrono::steady_clock;

// Long beside the clock's resolution, short beside a time slice of the system.
constexpr double seconds_per_sample = 2e-4;
constexpr int fewest_samples = 5;

double seconds_of(const Work& work, int runs) {
    const auto begin = Clock::now();
    for (int run = 0; run < runs; ++run) {
        work();
    }
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

Cost Meter::measure(const Work& work) {
    Cost cost;
    if (counter_) {
        cost.instructions = counter_(work);
    }
    if (!timed_) {
        return cost;
    }
    int runs = 1;
    while (seconds_of(work, runs) < seconds_per_sample) {
        runs *= 2;
    }
    double fastest = std::numeric_limits<double>::infinity();
    double spent = 0.0;
    for (int sample = 0; sample < fewest_samples || spent < seconds_per_cell_; ++sample) {
        const double seconds = seconds_of(work, runs);
        fastest = std::min(fastest, seconds / runs);
        spent += seconds;
    }
    cost.nanoseconds = fastest * 1e9;
    return cost;
}

double cold_nanoseconds(const Work& work) {
    constexpr std::size_t more_than_caches = std::size_t{96} << 20U;
    constexpr std::size_t line = 64;
    constexpr std::size_t samples = 41;
    std::vector<unsigned char> other(more_than_caches);
    std::vector<double> seconds;
    for (std::size_t sample = 0; sample < samples; ++sample) {
        for (std::size_t at = 0; at < other.size(); at += line) {
            ++other[at];
        }
        seconds.push_back(seconds_of(work, 1));
    }
    std::ranges::nth_element(seconds, seconds.begin() + samples / 2);
    keep(other[seconds.size()]);
    return seconds[samples / 2] * 1e9;
}

void Progress::step() {
    ++done_;
    const auto now = Clock::now();
    if (now - said_ > std::chrono::seconds(2)) {
        said_ = now;
        fmt::print(stderr, "{}: {} of {}\n", what_, done_, total_);
    }
}

void keep(double number) {
    static volatile double kept = 0.0;
    kept = kept + number;
}

std::string short_number(double number) {
    return std::isnan(number) ? fmt::format("{:>10}", "-") : fmt::format("{:>10.3g}", number);
}

}  // namespace hyrax::bench
