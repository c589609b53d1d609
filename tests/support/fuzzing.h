// SPDX-License-Identifier: MIT
// Random input for as long as somebody asks.
#pragma once

#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace hyrax {

/// Says on abort() which seed is played: doctest tells what was captured of failed checks only.
class SeedOnAbort {
public:
    SeedOnAbort() : before_(std::signal(SIGABRT, tell)) {}
    SeedOnAbort(const SeedOnAbort&) = delete;
    SeedOnAbort& operator=(const SeedOnAbort&) = delete;
    ~SeedOnAbort() { std::signal(SIGABRT, before_); }

    static void set(std::uint64_t seed) { seed_ = seed; }

private:
    static void tell(int /*signal*/) { std::fprintf(stderr, "aborted with seed %llu\n", seed_); }

    static inline unsigned long long seed_ = 0;
    void (*before_)(int);
};

/// Calls `play(seed)` with `few` seeds from 1 on. HYRAX_FUZZ_SECONDS in the environment makes it
/// go on for so long, and HYRAX_FUZZ_SEED begin elsewhere. Returns how many seeds were played.
template <typename Play>
std::uint64_t fuzz(std::uint64_t few, Play play) {
    using Clock = std::chrono::steady_clock;
    const char* const seconds = std::getenv("HYRAX_FUZZ_SECONDS");
    const char* const asked = std::getenv("HYRAX_FUZZ_SEED");
    const std::uint64_t first = asked == nullptr ? 1 : std::strtoull(asked, nullptr, 10);
    const auto end =
        Clock::now() +
        std::chrono::duration<double>(seconds == nullptr ? 0.0 : std::strtod(seconds, nullptr));
    const SeedOnAbort witness;
    std::uint64_t seed = first;
    while (seconds == nullptr ? seed - first < few : Clock::now() < end) {
        CAPTURE(seed);
        SeedOnAbort::set(seed);
        play(seed);
        ++seed;
    }
    if (seconds != nullptr) {
        MESSAGE("seeds ", first, " to ", seed - 1);
    }
    return seed - first;
}

}  // namespace hyrax
