// SPDX-License-Identifier: MIT
#include "tests/bench/bench_attacks.h"

#include "daemon/core/remote_script_host.h"
#include "daemon/core/script_bridge.h"
#include "daemon/headless/child_process.h"
#include "tests/support/attack_corpus.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace hyrax {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t pets = 50;
constexpr std::chrono::nanoseconds frame_time{ticks_per_second / 60};
constexpr std::size_t most_growth = std::size_t{4} << 20U;  // [bytes]

struct Lateness {
    int frames = 0;
    int late = 0;                        ///< Not ready when the next one was due.
    std::chrono::nanoseconds longest{};  ///< The daemon's work on one frame.
    std::size_t growth = 0;  ///< Resident memory at the end beyond that after a quarter [bytes].
};

std::size_t resident() {
    std::size_t all = 0;
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> all >> pages;
    return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

Lateness play(
    const std::filesystem::path& program, std::vector<ScriptSource> sources, double seconds
) {
    ScriptBridge bridge(std::make_unique<RemoteScriptHost>(std::make_unique<ChildProcess>(program))
    );
    Engine engine({{"hyrax", {100, 80}}}, {.max_pets = 200}, 1);
    engine.set_arena(Arena({{{0, 0, 1920, 1080}, {0, 0, 1920, 1080}, true, {}}}, FloorEdge::screen)
    );
    for (std::size_t i = 0; i < pets; ++i) {
        static_cast<void>(engine.spawn({.velocity = {100.0, -300.0}}));
    }
    bridge.load(std::move(sources));
    Lateness result;
    std::size_t before = 0;
    const auto begin = Clock::now();
    const auto count = static_cast<int>(seconds * 60.0);
    for (; result.frames < count; ++result.frames) {
        const auto due = begin + result.frames * frame_time;
        std::this_thread::sleep_until(due);
        const auto start = Clock::now();
        bridge.watch(start.time_since_epoch().count());
        const Ticks world = result.frames * frame_time.count();
        engine.advance(world);
        bridge.run(engine, {}, world);
        const auto end = Clock::now();
        result.longest = std::max<std::chrono::nanoseconds>(result.longest, end - start);
        result.late += end > due + frame_time ? 1 : 0;
        if (result.frames == count / 4) {
            before = resident();
        }
    }
    const std::size_t after = resident();
    result.growth = after > before ? after - before : 0;
    return result;
}

std::vector<ScriptSource> hundred() {
    std::vector<ScriptSource> sources;
    for (int i = 0; i < 100; ++i) {
        const char* const text =
            i % 10 == 3 ? "local s = ('a'):rep(3000) s:find(('.-'):rep(10) .. 'b')"
                        : "hyrax.every(0.05, function() for _, p in ipairs(hyrax.pets()) do "
                          "p:push(1, 0) end end)";
        sources.push_back({"s" + std::to_string(i) + ".lua", text});
    }
    return sources;
}

}  // namespace

bool measure_attacks(const std::filesystem::path& program, double seconds) {
    bool good = true;
    const auto measure = [&](const std::string& name, std::vector<ScriptSource> sources) {
        const Lateness found = play(program, std::move(sources), seconds);
        fmt::print(
            "{:<34} {:5} frames {:3} late, longest {:8.2f} ms, memory +{} KiB\n",
            name,
            found.frames,
            found.late,
            std::chrono::duration<double, std::milli>(found.longest).count(),
            found.growth / 1024
        );
        std::fflush(stdout);
        return found;
    };
    int usual = measure("no script", {}).late;
    usual = std::max(usual, measure("no script, once more", {}).late);
    const auto judge = [&](const Lateness& found) {
        good = good && found.late <= usual && found.growth <= most_growth;
    };
    for (const Attack& attack : attacks()) {
        judge(measure(attack.name, {{attack.name, attack.text}}));
    }
    judge(measure("100 scripts, 10 of them hostile", hundred()));
    return good;
}

}  // namespace hyrax
