// SPDX-License-Identifier: MIT
// script-bench: what scripts in a process of their own cost the daemon, how soon they answer, and
// what hostile ones do to its frames.
#include "daemon/core/remote_script_host.h"
#include "daemon/core/script_bridge.h"
#include "daemon/headless/child_process.h"
#include "daemon/script/script_host.h"
#include "tests/bench/bench_attacks.h"

#include <fmt/format.h>
#include <sched.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <vector>

using namespace hyrax;

namespace {

constexpr int frames = 1'200;
constexpr std::size_t pets = 100;
constexpr std::size_t clicks = 10;

double now_us() {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::micro>(time).count();
}

Ticks machine_now() {
    return static_cast<Ticks>(now_us() * 1e3);
}

void report(const char* what, std::vector<double> times) {
    std::ranges::sort(times);
    const auto at = [&times](double share) {
        return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
    };
    fmt::print(
        "{:<52} median {:8.2f}  99 % {:8.2f}  max {:8.2f} us\n", what, at(0.5), at(0.99), at(1.0)
    );
}

/// Keeps this process and its children on the first of its processors: elsewhere the figures go by
/// turns, as the system places the two.
class OneProcessor {
public:
    OneProcessor() {
        ::sched_getaffinity(0, sizeof before_, &before_);
        cpu_set_t one;
        CPU_ZERO(&one);
        int first = 0;
        while (first < CPU_SETSIZE - 1 && !CPU_ISSET(first, &before_)) {
            ++first;
        }
        CPU_SET(first, &one);
        ::sched_setaffinity(0, sizeof one, &one);
    }
    OneProcessor(const OneProcessor&) = delete;
    OneProcessor& operator=(const OneProcessor&) = delete;
    ~OneProcessor() { ::sched_setaffinity(0, sizeof before_, &before_); }

private:
    cpu_set_t before_{};
};

// 100 pets, 10 events and 100 commands a frame.
void measure_frames(const char* program) {
    auto channel = std::make_unique<ChildProcess>(program);
    ChildProcess& process = *channel;
    ScriptBridge bridge(std::make_unique<RemoteScriptHost>(std::move(channel)));
    Engine engine({{"hyrax", {100, 80}}}, {}, 1);
    engine.set_arena(Arena({{{0, 0, 1920, 1080}, {0, 0, 1920, 1080}, true, {}}}, FloorEdge::screen)
    );
    std::vector<PetId> ids;
    for (std::size_t i = 0; i < pets; ++i) {
        ids.push_back(engine.spawn({.tag = "bench"}).value());
    }
    bridge.load({{"bench.lua", R"(
        hyrax.on("click", function() end)
        hyrax.on("tick", function() for _, pet in ipairs(hyrax.pets()) do pet:push(1, 0) end end)
    )"}});
    std::vector<double> costs;
    std::vector<double> latencies;
    Ticks now = 0;
    for (int i = 0; i < frames; ++i) {
        now += ticks_per_second / 60;
        for (std::size_t c = 0; c < clicks; ++c) {
            engine.click(ids[c], Button::left);
        }
        const double begin = now_us();
        bridge.watch(machine_now());
        bridge.run(engine, {}, now);
        costs.push_back(now_us() - begin);
        const double sent = now_us();
        process.wait(std::chrono::milliseconds(100));
        latencies.push_back(now_us() - sent);
    }
    report("daemon: a frame, 100 pets, 10 events, 100 commands", std::move(costs));
    report("from a frame's events to its commands", std::move(latencies));
}

void measure_handlers() {
    const std::unique_ptr<ScriptHost> host = make_script_host();
    host->load({{"bench.lua", "hyrax.on('click', function(pet) end)"}});
    ScriptWorld world{.now = 0, .pets = {{.key = 1, .kind = "hyrax"}}, .monitors = {}};
    host->run(world, {});
    constexpr std::size_t calls = 1'000;
    const std::vector<ScriptEvent> events(calls, {{.kind = EventKind::click}, 1});
    std::vector<double> times;
    for (int i = 0; i < 200; ++i) {
        const double begin = now_us();
        host->run(world, events);
        times.push_back((now_us() - begin) / double{calls});
    }
    report("host: a call of a handler", std::move(times));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        fmt::print(
            stderr,
            "usage: script-bench HYRAX-HEADLESS [SECONDS]\nWith SECONDS, each hostile script runs "
            "for "
            "so long.\n"
        );
        return EXIT_FAILURE;
    }
    fmt::print("daemon and scripts on one processor:\n");
    {
        const OneProcessor here;
        measure_frames(argv[1]);
    }
    fmt::print("where the system puts them:\n");
    measure_frames(argv[1]);
    measure_handlers();
    if (argc < 3) {
        return EXIT_SUCCESS;
    }
    spdlog::set_level(spdlog::level::off);  // The scripts' own errors.
    return measure_attacks(argv[1], std::atof(argv[2])) ? EXIT_SUCCESS : EXIT_FAILURE;
}
