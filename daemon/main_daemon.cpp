// SPDX-License-Identifier: MIT
// hyrax.exe: the tray-resident daemon.
#include "daemon/control/command_line.h"
#include "daemon/control/controller.h"
#include "daemon/core/check.h"
#include "daemon/core/daemon.h"
#include "daemon/core/log_failure.h"
#include "daemon/core/remote_script_host.h"
#include "daemon/core/statistics.h"
#include "daemon/script/host_main.h"
#include "daemon/win32/child_process.h"
#include "daemon/win32/clock.h"
#include "daemon/win32/console.h"
#include "daemon/win32/durable_file.h"
#include "daemon/win32/host_process.h"
#include "daemon/win32/image_decoder.h"
#include "daemon/win32/pipe_name.h"
#include "daemon/win32/pipe_server.h"
#include "daemon/win32/process.h"
#include "daemon/win32/process_use.h"
#include "daemon/win32/single_instance.h"
#include "daemon/win32/text.h"
#include "daemon/win32/text_painter.h"
#include "daemon/win32/win32_desktop.h"

#include <fmt/format.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <source_location>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace hyrax;

constexpr int exit_ok = 0;
constexpr int exit_failed = 1;
constexpr std::size_t log_bytes = std::size_t{1} << 20U;
constexpr std::size_t old_logs = 2;

struct Places {
    Profile profile;
    fs::path log;
    fs::path program;
};

Places places_for(const win32::Folders& folders, const DaemonCommandLine& line) {
    const fs::path user = line.profile ? fs::absolute(*line.profile) : folders.profile;
    return {
        .profile =
            {
                .config = user / "config.json",
                .user = user,
                .shipped = folders.program,
                .more_scripts = {},
                .state = (line.profile ? user : folders.state) / "state.json",
            },
        .log = (line.profile ? user : folders.state) / "hyrax.log",
        .program = folders.executable,
    };
}

int fail(const Error& error) {
    spdlog::critical("{}", error.message);
    win32::say(fmt::format("hyrax: {}\n", error.message));
    return exit_failed;
}

// A shipped daemon goes on after a broken check: losing a pet is better than losing all.
void log_broken_check(const char* condition, const std::source_location& where) {
    spdlog::critical("{}:{}: broken check: {}", where.file_name(), where.line(), condition);
}

void open_log(const fs::path& file) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    try {
        // For several threads: what the shell is asked for is told by one that waited for it.
        spdlog::set_default_logger(
            spdlog::rotating_logger_mt("hyrax", file.native(), log_bytes, old_logs)
        );
    } catch (const spdlog::spdlog_ex& problem) {
        // Without a log the daemon still runs.
        win32::say(fmt::format("hyrax: no log: {}\n", problem.what()));
    }
    spdlog::set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");
    spdlog::flush_on(spdlog::level::info);
}

// What a second start asks for; without an option it asks for a hyrax.
std::vector<Request> requests_of(const std::vector<std::string>& arguments) {
    auto parsed = parse_daemon_arguments(arguments);
    if (const auto* farewell = std::get_if<Farewell>(&parsed)) {
        spdlog::warn("a second start was not understood: {}", farewell->text);
        return {};
    }
    auto& line = std::get<DaemonCommandLine>(parsed);
    if (line.common.requests.empty() && !line.autostart) {
        return {request::Show{}, request::Spawn{}};
    }
    return std::move(line.common.requests);
}

bool asks_to_quit(const std::vector<Request>& requests) {
    return std::ranges::any_of(requests, [](const Request& asked) {
        return std::holds_alternative<request::Quit>(asked);
    });
}

// From 1 to 2^31 - 2, as minstd_rand wants it.
std::uint32_t seed_of_the_day() {
    const auto count = std::chrono::system_clock::now().time_since_epoch().count();
    return static_cast<std::uint32_t>(count % 2'147'483'646 + 1);
}

// Without it the daemon still runs: pets matter more than commands.
std::unique_ptr<win32::PipeServer> control_pipe(const std::wstring& instance) {
    const auto name = win32::pipe_name(instance);
    auto server = name ? win32::PipeServer::open(*name) : std::unexpected(name.error());
    if (!server) {
        spdlog::error("hyraxctl cannot speak to this hyrax: {}", server.error().message);
        return nullptr;
    }
    return *std::move(server);
}

int run_daemon(const Places& places, const DaemonCommandLine& line, const std::wstring& instance) {
    const win32::GdiplusSession gdiplus;
    auto scripts = std::make_unique<win32::ChildProcess>(places.program);
    auto desktop = win32::Win32Desktop::create({
        .profile = places.profile.user,
        .unwatched =
            {L"hyrax.log", L"hyrax.1.log", L"hyrax.2.log", L"state.json", L"state.json.new"},
        .config_file = places.profile.config,
        .scripts_folder = places.profile.user / "scripts",
        .log_file = places.log,
        .executable = places.program,
        .restart_arguments = win32::restart_arguments(line.profile),
        .instance_name = instance,
        .control = control_pipe(instance),
        .scripts_event = scripts->event(),
        .parse_arguments = requests_of,
        .for_testing = line.common.for_testing,
    });
    if (!desktop) {
        return fail(desktop.error());
    }
    DaemonOptions options{
        .profile = places.profile,
        .decode = win32::make_gdiplus_decoder(),
        .scripts = std::make_unique<RemoteScriptHost>(std::move(scripts)),
        .control = make_controller(win32::save_file),
        .trace = {},
        .requests = line.common.requests,
        .fps = {},
        .seed = line.common.for_testing ? 1U : seed_of_the_day(),
        .paint_text = win32::make_text_painter(),
    };
    if (line.common.trace) {
        auto trace = Trace::open(*line.common.trace);
        if (!trace) {
            return fail(trace.error());
        }
        options.trace = *std::move(trace);
    }
    Daemon daemon(**desktop, std::move(options));
    (*desktop)->on_modal_tick([&daemon](const std::vector<Input>& inbox) {
        for (const Input& input : inbox) {
            daemon.handle(input);
        }
        daemon.run_due();
        return !daemon.is_ending();
    });
    (*desktop)->on_session_end([&daemon] { daemon.end(); });
    const auto tell_statistics = [&] {
        if (line.common.statistics) {
            log_failure(append_statistics(
                *line.common.statistics,
                {
                    .now = (*desktop)->now(),
                    .pets = daemon.engine().size(),
                    .moving = daemon.engine().report().awake,
                    .desktop = (*desktop)->counters(),
                    .process = win32::process_use(),
                }
            ));
        }
    };
    (*desktop)->on_statistics_request(tell_statistics);
    daemon.run();
    tell_statistics();

    const DesktopCounters counters = (*desktop)->counters();
    spdlog::info(
        "{} pets; {} presents of {:.1f} MB in all; woken {} times; bye",
        daemon.engine().size(),
        counters.overlay.presents,
        static_cast<double>(counters.overlay.bytes) / 1e6,
        counters.wakeups
    );
    return exit_ok;
}

// The life of this program when the daemon has started it to hold scripts.
int be_script_host(const std::vector<std::string>& arguments) {
    const auto process = win32::HostProcess::settle_in(arguments[1], arguments[2]);
    if (!process) {
        return fail(process.error());
    }
    return serve_scripts(
        **process, {.processor_time = win32::thread_processor_time, .pulse = &(*process)->pulse()}
    );
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() == 3 && arguments[0] == script_host_switch) {
        return be_script_host(arguments);
    }
    const auto parsed = parse_daemon_arguments(arguments);
    if (const auto* farewell = std::get_if<Farewell>(&parsed)) {
        win32::say(farewell->text);
        return farewell->exit_code;
    }
    const auto& line = std::get<DaemonCommandLine>(parsed);
    if (!line.common.for_testing) {
        set_check_handler(log_broken_check);
    }
    const auto folders = win32::find_folders();
    if (!folders) {
        return fail(folders.error());
    }
    const Places places = places_for(*folders, line);
    const auto instance = win32::SingleInstance::claim(places.profile.user);
    if (!instance) {
        return fail(instance.error());
    }
    if (!instance->is_first()) {
        const auto handed_over = instance->hand_over(arguments);
        return handed_over ? exit_ok : fail(handed_over.error());
    }
    if (asks_to_quit(line.common.requests)) {
        return exit_ok;
    }
    open_log(places.log);
    if (const auto prepared = prepare(places.profile); !prepared) {
        spdlog::error("{}", prepared.error().message);
    }
    return run_daemon(places, line, instance->name());
}

}  // namespace

int wWinMain(HINSTANCE, HINSTANCE, PWSTR, int) {
    win32::harden_process();
    try {
        return run(win32::command_line_arguments());
    } catch (const std::exception& error) {
        return fail({fmt::format("unexpected: {}", error.what())});
    }
}
