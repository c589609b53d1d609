// SPDX-License-Identifier: MIT
// hyrax-headless: the whole daemon on a desktop made of lists.
#include "daemon/control/command_line.h"
#include "daemon/control/controller.h"
#include "daemon/core/daemon.h"
#include "daemon/headless/control_path.h"
#include "daemon/headless/durable_file.h"
#include "daemon/headless/headless_desktop.h"
#include "daemon/headless/monitor_list.h"
#include "daemon/headless/png_file.h"
#include "daemon/headless/real_time_desktop.h"
#include "daemon/script/script_host.h"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace {

namespace fs = std::filesystem;

constexpr int exit_ok = 0;
constexpr int exit_failed = 1;

int failed(const hyrax::Error& error) {
    fmt::print(stderr, "hyrax-headless: {}\n", error.message);
    return exit_failed;
}

hyrax::Profile profile_for(const hyrax::HeadlessCommandLine& line) {
    const fs::path shipped = hyrax::program_folder();
    const fs::path config = line.config.value_or(shipped / "config" / "config.json");
    return {
        .config = config,
        .user = fs::absolute(config).parent_path(),
        .shipped = shipped,
        .more_scripts = line.scripts,
    };
}

// `busy`: real time that the whole run took [ns].
void report(const hyrax::Daemon& daemon, hyrax::HeadlessDesktop& desktop, double busy) {
    const hyrax::EngineReport engine = daemon.engine().report();
    const double seconds = hyrax::to_seconds(desktop.now());
    fmt::print(
        "{} pets ({} moving, {} asleep) after {} s: {} frames shown, {} timer wake-ups\n",
        daemon.engine().size(),
        engine.awake,
        engine.asleep,
        seconds,
        desktop.presents(),
        desktop.timer_wakeups()
    );
    fmt::print(
        "{}: {:.1f} contacts a second, energy {:.4g} px^2/s^2, {:.0f} ns for each frame\n",
        hyrax::name_of(daemon.engine().integrator()),
        seconds > 0.0 ? static_cast<double>(engine.contacts) / seconds : 0.0,
        engine.energy,
        busy / static_cast<double>(std::max<std::size_t>(1, desktop.presents()))
    );
}

int save_snapshot(
    const hyrax::HeadlessCommandLine& line,
    const std::vector<hyrax::Monitor>& monitors,
    const hyrax::Frame& frame
) {
    if (!line.snapshot) {
        return exit_ok;
    }
    const auto written = hyrax::write_png(*line.snapshot, hyrax::picture(frame, monitors));
    return written ? exit_ok : failed(written.error());
}

int serve(
    const hyrax::HeadlessCommandLine& line,
    const std::vector<hyrax::Monitor>& monitors,
    hyrax::DaemonOptions options
) {
    auto control = hyrax::ControlSocket::open(options.profile.user);
    if (!control) {
        return failed(control.error());
    }
    const hyrax::Ticks span =
        std::isinf(line.seconds) ? hyrax::never : hyrax::from_seconds(line.seconds);
    auto desktop = hyrax::RealTimeDesktop::create(monitors, span, *std::move(control));
    if (!desktop) {
        return failed(desktop.error());
    }
    options.control = hyrax::make_controller(hyrax::save_file);
    hyrax::Daemon daemon(**desktop, std::move(options));
    daemon.run();
    return save_snapshot(line, monitors, (*desktop)->last_frame());
}

int run(const hyrax::HeadlessCommandLine& line) {
    const auto monitors = hyrax::parse_monitors(line.monitors);
    if (!monitors) {
        return failed(monitors.error());
    }
    hyrax::DaemonOptions options{
        .profile = profile_for(line),
        .decode = hyrax::decode_png,
        .scripts = hyrax::make_script_host({}),
        .trace = {},
        .requests = line.common.requests,
        .fps = line.fps,
    };
    if (line.common.trace) {
        auto trace = hyrax::Trace::open(*line.common.trace);
        if (!trace) {
            return failed(trace.error());
        }
        options.trace = *std::move(trace);
    }

    if (line.serve) {
        return serve(line, *monitors, std::move(options));
    }
    hyrax::HeadlessDesktop desktop(*monitors, hyrax::from_seconds(line.seconds));
    hyrax::Daemon daemon(desktop, std::move(options));
    const auto begin = std::chrono::steady_clock::now();
    daemon.run();
    const std::chrono::duration<double, std::nano> busy = std::chrono::steady_clock::now() - begin;

    if (const int code = save_snapshot(line, *monitors, desktop.last_frame()); code != exit_ok) {
        return code;
    }
    report(daemon, desktop, busy.count());
    return exit_ok;
}

}  // namespace

int main(int argc, char** argv) {
    spdlog::set_default_logger(spdlog::stderr_logger_st("hyrax"));
    spdlog::set_pattern("%l: %v");
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto parsed = hyrax::parse_headless_arguments(arguments);
    if (const auto* farewell = std::get_if<hyrax::Farewell>(&parsed)) {
        fmt::print(farewell->exit_code == 0 ? stdout : stderr, "{}", farewell->text);
        return farewell->exit_code;
    }
    return run(std::get<hyrax::HeadlessCommandLine>(parsed));
}
