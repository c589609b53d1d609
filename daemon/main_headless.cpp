// SPDX-License-Identifier: MIT
// hyrax-headless: the whole daemon without windows, on a virtual clock or the real one.
#include "daemon/control/command_line.h"
#include "daemon/control/controller.h"
#include "daemon/core/daemon.h"
#include "daemon/core/files.h"
#include "daemon/core/log_failure.h"
#include "daemon/core/remote_script_host.h"
#include "daemon/core/statistics.h"
#include "daemon/headless/child_process.h"
#include "daemon/headless/control_path.h"
#include "daemon/headless/durable_file.h"
#include "daemon/headless/headless_desktop.h"
#include "daemon/headless/host_process.h"
#include "daemon/headless/monitor_list.h"
#include "daemon/headless/png_file.h"
#include "daemon/headless/process_use.h"
#include "daemon/headless/real_time_desktop.h"
#include "daemon/headless/testing_host.h"
#include "daemon/headless/text_painter.h"
#include "daemon/headless/window_list.h"
#include "daemon/script/host_main.h"
#include "daemon/script/script_host.h"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

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
        .more_scripts = line.test ? std::vector{*line.test} : line.scripts,
        .state = line.state ? *line.state / "state.json" : fs::path(),
    };
}

// `busy`: processor time that the whole run took [ns].
void report(
    const hyrax::Daemon& daemon, const hyrax::DesktopCounters& counters, double seconds, double busy
) {
    const hyrax::EngineReport engine = daemon.engine().report();
    const std::uint64_t frames = counters.overlay.frames;
    fmt::print(
        "{} pets ({} moving, {} asleep) after {} s: {} frames shown, {} timer wake-ups\n",
        daemon.engine().size(),
        engine.awake,
        engine.asleep,
        seconds,
        frames,
        counters.timer_wakeups
    );
    fmt::print(
        "{}: {:.1f} contacts a second, energy {:.4g} px^2/s^2, {:.0f} ns for each frame\n",
        hyrax::name_of(daemon.engine().integrator()),
        seconds > 0.0 ? static_cast<double>(engine.contacts) / seconds : 0.0,
        engine.energy,
        busy / static_cast<double>(std::max<std::uint64_t>(1, frames))
    );
}

/// Runs the cases of this script alone; the run ends when the last of them has ended.
std::unique_ptr<hyrax::ScriptHost> testing_host(
    std::unique_ptr<hyrax::ScriptHost> host,
    const fs::path& script,
    hyrax::HeadlessDesktop& desktop,
    hyrax::TestReport& tests
) {
    return std::make_unique<hyrax::TestingHost>(
        std::move(host),
        hyrax::utf8_from_path(
            fs::is_directory(script) ? fs::canonical(script).filename() : script.filename()
        ),
        tests,
        [&desktop] { desktop.add({desktop.now(), hyrax::Request{hyrax::request::Quit{}}}); }
    );
}

template <typename AnyDesktop>
hyrax::Statistics statistics_of(const hyrax::Daemon& daemon, AnyDesktop& desktop) {
    return {
        .now = desktop.now(),
        .pets = daemon.engine().size(),
        .moving = daemon.engine().report().awake,
        .desktop = desktop.counters(),
        .process = hyrax::process_use(),
    };
}

/// Either desktop, until its time is over.
template <typename AnyDesktop>
int run_on(
    AnyDesktop& desktop,
    const std::vector<hyrax::Monitor>& monitors,
    hyrax::DaemonOptions options,
    const hyrax::HeadlessCommandLine& line
) {
    const hyrax::Ticks start = desktop.now();
    hyrax::TestReport tests;
    if constexpr (std::is_same_v<AnyDesktop, hyrax::HeadlessDesktop>) {
        if (line.test) {
            options.scripts = testing_host(std::move(options.scripts), *line.test, desktop, tests);
        }
    }
    hyrax::Daemon daemon(desktop, std::move(options));
    const auto tell_statistics = [&] {
        if (line.common.statistics) {
            hyrax::log_failure(
                hyrax::append_statistics(*line.common.statistics, statistics_of(daemon, desktop))
            );
        }
    };
    if constexpr (requires { desktop.on_statistics_request(tell_statistics); }) {
        desktop.on_statistics_request(tell_statistics);
    }
    const std::clock_t begin = std::clock();
    daemon.run();
    const double busy = static_cast<double>(std::clock() - begin) * 1e9 / CLOCKS_PER_SEC;
    tell_statistics();

    if (line.snapshot) {
        const auto image = hyrax::picture(daemon.frame(), monitors);
        if (const auto written = hyrax::write_png(*line.snapshot, image); !written) {
            return failed(written.error());
        }
    }
    if (line.test) {
        fmt::print("{}", hyrax::tap(tests));
        return tests.passed() ? exit_ok : exit_failed;
    }
    report(daemon, desktop.counters(), hyrax::to_seconds(desktop.now() - start), busy);
    return exit_ok;
}

std::unique_ptr<hyrax::ScriptHost> remote_scripts(hyrax::RealTimeDesktop& desktop) {
    auto channel = std::make_unique<hyrax::ChildProcess>();
    desktop.listen_to_scripts([&process = *channel] { return process.wire(); });
    return std::make_unique<hyrax::RemoteScriptHost>(std::move(channel));
}

int serve(
    const std::vector<hyrax::Monitor>& monitors,
    hyrax::DaemonOptions options,
    hyrax::Ticks span,
    const hyrax::HeadlessCommandLine& line
) {
    auto control = hyrax::ControlSocket::open(options.profile.user);
    if (!control) {
        return failed(control.error());
    }
    hyrax::RealTimeDesktop desktop(monitors, span, *std::move(control));
    options.control = hyrax::make_controller(hyrax::save_file);
    if (line.script_process) {
        options.scripts = remote_scripts(desktop);
    }
    return run_on(desktop, monitors, std::move(options), line);
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
        process.wait(std::chrono::milliseconds(20));
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
    std::optional<hyrax::FreetypePainter> painter;  // Made when the first pet speaks.
    hyrax::DaemonOptions options{
        .profile = profile_for(line),
        .decode = hyrax::decode_png,
        .scripts = hyrax::make_script_host({}),
        .trace = {},
        .requests = line.common.requests,
        .fps = line.fps,
        .paint_text =
            [&painter](std::string_view text) {
                if (!painter) {
                    painter.emplace();
                }
                return painter->draw(text);
            },
        .welcome = !line.test,
    };
    if (line.common.trace) {
        auto trace = hyrax::Trace::open(*line.common.trace);
        if (!trace) {
            return failed(trace.error());
        }
        options.trace = *std::move(trace);
    }

    const hyrax::Ticks span =
        std::isinf(line.duration()) ? hyrax::never : hyrax::from_seconds(line.duration());
    if (line.serve) {
        return serve(*monitors, std::move(options), span, line);
    }
    if (line.real_time) {
        hyrax::RealTimeDesktop desktop(*monitors, span);
        return run_on(desktop, *monitors, std::move(options), line);
    }
    hyrax::HeadlessDesktop desktop(*monitors, span);
    if (line.windows) {
        auto windows = hyrax::load_windows(*line.windows);
        if (!windows) {
            return failed(windows.error());
        }
        desktop.set_windows(*std::move(windows));
    }
    if (line.script_process) {
        options.scripts = remote_scripts(desktop);
    }
    return run_on(desktop, *monitors, std::move(options), line);
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
