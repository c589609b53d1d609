// SPDX-License-Identifier: MIT
#include "daemon/check/check_run.h"

#include "daemon/core/script_bridge.h"
#include "daemon/script/script_host.h"

#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <utility>

namespace hyrax {
namespace {

constexpr double frames_per_second = 60.0;

/// Keeps what scripts say.
class HeardHost final : public ScriptHost {
public:
    HeardHost(std::unique_ptr<ScriptHost> host, CheckRun& heard)
        : host_(std::move(host)), heard_(heard) {}

    void load(std::vector<ScriptSource> sources) override { host_->load(std::move(sources)); }
    ScriptOutput run(const ScriptWorld& world, std::span<const ScriptEvent> events) override {
        ScriptOutput output = host_->run(world, events);
        std::ranges::move(output.log, std::back_inserter(heard_.log));
        std::ranges::move(output.tests, std::back_inserter(heard_.tests));
        output.log.clear();
        heard_.open_tests = output.open_tests;
        return output;
    }

private:
    std::unique_ptr<ScriptHost> host_;
    CheckRun& heard_;
};

/// What the engine would not do is told to the program's log: it is kept like the rest.
class HeardLog final : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
public:
    HeardLog(std::string script, CheckRun& heard) : script_(std::move(script)), heard_(heard) {}

private:
    void sink_it_(const spdlog::details::log_msg& line) override {
        if (line.level >= spdlog::level::warn) {
            heard_.log.push_back(
                {LogLevel::warning, script_, std::string(line.payload.data(), line.payload.size())}
            );
        }
    }
    void flush_() override {}

    std::string script_;
    CheckRun& heard_;
};

/// Until it goes, the program's log is another one.
class LogInstead {
public:
    explicit LogInstead(spdlog::sink_ptr sink) : before_(spdlog::default_logger()) {
        spdlog::set_default_logger(std::make_shared<spdlog::logger>("check", std::move(sink)));
    }
    LogInstead(const LogInstead&) = delete;
    LogInstead& operator=(const LogInstead&) = delete;
    ~LogInstead() { spdlog::set_default_logger(before_); }

private:
    std::shared_ptr<spdlog::logger> before_;
};

/// What the user does meanwhile, by the number of the frame.
void play(Engine& engine, PetId pet, int frame) {
    constexpr int period = 600;
    if (engine.find(pet) == nullptr) {
        return;
    }
    if (frame % period == 240) {
        engine.click(pet, Button::left);
    } else if (frame % period == 480) {
        static_cast<void>(engine.fling(pet, {600.0, -900.0}));
    }
}

}  // namespace

CheckRun run_script(ScriptSource source, std::vector<Kind> kinds, double seconds) {
    CheckRun heard;
    const LogInstead log(std::make_shared<HeardLog>(source.name, heard));
    const std::vector<Monitor> monitors{
        {.bounds = {0, 0, 1920, 1080}, .work = {0, 0, 1920, 1040}, .primary = true, .name = "screen"
        }
    };
    Engine engine(std::move(kinds), {}, 1);
    engine.set_arena(Arena(monitors, FloorEdge::work_area));
    ScriptBridge scripts(std::make_unique<HeardHost>(make_script_host({}), heard));
    const bool testing = source.testing;
    scripts.load({std::move(source)});
    const PetId pet = engine.spawn({.at = Vec2{900.0, 200.0}}).value_or(PetId{});
    const int frames = static_cast<int>(seconds * frames_per_second);
    Ticks now = 0;
    for (int frame = 0; frame < frames; ++frame) {
        now = from_seconds(frame / frames_per_second);
        play(engine, pet, frame);
        engine.advance(now);
        scripts.run(engine, monitors, now);
        if (testing && heard.open_tests == 0) {
            break;
        }
    }
    scripts.end(engine, monitors, {.world = now, .machine = now}, std::chrono::milliseconds(0));
    return heard;
}

}  // namespace hyrax
