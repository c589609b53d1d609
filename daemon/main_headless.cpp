// SPDX-License-Identifier: MIT
// hyrax-headless: the whole daemon on a desktop made of lists.
#include "daemon/control/command_line.h"
#include "daemon/core/daemon.h"
#include "daemon/core/remote_script_host.h"
#include "daemon/headless/child_process.h"
#include "daemon/headless/headless_desktop.h"
#include "daemon/headless/host_process.h"
#include "daemon/headless/monitor_list.h"
#include "daemon/headless/png_file.h"
#include "daemon/script/host_main.h"
#include "daemon/script/script_host.h"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace {

namespace fs = std::filesystem;

constexpr int exit_ok = 0;
constexpr int exit_failed = 1;

int failed(const hyrax::Error& error) {
    fmt::print(stderr, "hyrax-headless: {}\n", error.message);
    return exit_failed;
}

fs::path folder_of_this_program() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

hyrax::Profile profile_for(const hyrax::HeadlessCommandLine& line) {
    const fs::path shipped = folder_of_this_program();
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

// Scripts in a process of their own. Virtual time stands still while they work: the same input
// gives the same trace, however long they take.
std::unique_ptr<hyrax::ScriptHost> remote_scripts(hyrax::HeadlessDesktop& desktop) {
    auto channel = std::make_unique<hyrax::ChildProcess>();
    hyrax::ChildProcess& process = *channel;
    auto host = std::make_unique<hyrax::RemoteScriptHost>(std::move(channel));
    desktop.before_time_moves([&process, &remote = *host] {
        if (!remote.running() || !remote.busy()) {
            return false;
        }
        constexpr int milliseconds = 20;
        process.wait(milliseconds);
        return true;
    });
    return host;
}

// The life of this program when the daemon has started it to hold scripts. Ends without destructors
// and exit handlers: in its cage they could not do what they want.
[[noreturn]] void be_script_host(const std::string& parent) {
    const auto process = hyrax::HostProcess::settle_in(parent);
    if (!process) {
        ::_exit(failed(process.error()));
    }
    ::_exit(hyrax::serve_scripts(**process, {.pulse = &(*process)->pulse()}));
}

int run(const hyrax::HeadlessCommandLine& line) {
    const auto monitors = hyrax::parse_monitors(line.monitors);
    if (!monitors) {
        return failed(monitors.error());
    }
    hyrax::HeadlessDesktop desktop(*monitors, hyrax::from_seconds(line.seconds));
    hyrax::DaemonOptions options{
        .profile = profile_for(line),
        .decode = hyrax::decode_png,
        .scripts = line.script_process ? remote_scripts(desktop) : hyrax::make_script_host({}),
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

    hyrax::Daemon daemon(desktop, std::move(options));
    const auto begin = std::chrono::steady_clock::now();
    daemon.run();
    const std::chrono::duration<double, std::nano> busy = std::chrono::steady_clock::now() - begin;

    if (line.snapshot) {
        const auto image = hyrax::picture(desktop.last_frame(), *monitors);
        if (const auto written = hyrax::write_png(*line.snapshot, image); !written) {
            return failed(written.error());
        }
    }
    report(daemon, desktop, busy.count());
    return exit_ok;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 3 && argv[1] == hyrax::script_host_switch) {
        be_script_host(argv[2]);
    }
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
