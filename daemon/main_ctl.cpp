// SPDX-License-Identifier: MIT
// hyraxctl: one request to the daemon that runs, and its answer.
#include "daemon/check/plugin_check.h"
#include "daemon/control/client.h"
#include "daemon/control/connection.h"
#include "daemon/control/conversation.h"
#include "daemon/control/ctl_command_line.h"
#include "daemon/control/ctl_output.h"
#include "daemon/control/ctl_task.h"
#include "daemon/control/save_file.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <variant>

namespace {

using namespace hyrax;

int no_daemon(const Error& error) {
    fmt::print(stderr, "hyraxctl: {}\n", error.message);
    return exit_no_daemon;
}

bool print(const std::string& text) {
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() &&
           std::fflush(stdout) == 0;
}

// Until the daemon ends, or nobody reads what is printed.
int print_events(Connection& connection, bool json) {
    Conversation conversation(connection);
    while (true) {
        const Result<std::optional<std::string>> event = conversation.more();
        if (!event) {
            return no_daemon(event.error());
        }
        if (!*event || !print(json ? **event + "\n" : shown_event(**event))) {
            return exit_ok;
        }
    }
}

// As compilers tell it.
int check(ControlSystem& system, const std::filesystem::path& folder) {
    const PluginReport report = check_plugin(folder, system.shipped(), system.decoder());
    for (const std::string& line : report.said) {
        fmt::print("{}\n", line);
    }
    for (const std::string& line : report.warnings) {
        fmt::print(stderr, "warning: {}\n", line);
    }
    for (const std::string& line : report.errors) {
        fmt::print(stderr, "{}{}\n", line.starts_with(' ') ? "" : "error: ", line);
    }
    if (report.good()) {
        fmt::print("good: it ran for a minute; {} cases passed\n", report.cases);
    }
    return report.good() ? exit_ok : exit_refused;
}

int run(ControlSystem& system, const CtlCommandLine& line) {
    const Result<std::filesystem::path> profile =
        line.profile ? *line.profile : system.usual_profile();
    if (!profile) {
        return no_daemon(profile.error());
    }
    if (line.task) {
        return perform(
            *line.task,
            {system,
             *profile,
             [&system](const std::filesystem::path& folder) { return check(system, folder); },
             line.json}
        );
    }
    const Client client(system, *profile);
    // The daemon itself does not wait for a file that another program holds: pets would stand
    // still.
    constexpr int attempts = 40;
    constexpr std::chrono::milliseconds pause{50};
    Result<Talk> talk = client.ask(line.request);
    for (int i = 1; i < attempts && talk && shown_answer(talk->answer).refusal == not_saved; ++i) {
        std::this_thread::sleep_for(pause);
        talk = client.ask(line.request);
    }
    if (!talk) {
        return no_daemon(talk.error());
    }
    const ShownAnswer shown = shown_answer(talk->answer);
    const bool refused = !shown.refusal.empty();
    if (line.json) {
        print(talk->answer + "\n");
    } else if (refused) {
        fmt::print(stderr, "hyraxctl: {}\n", shown.text);
    } else if (!line.stays) {
        print(shown.text);
    }
    if (refused) {
        return exit_refused;
    }
    return line.stays ? print_events(*talk->connection, line.json) : exit_ok;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::unique_ptr<ControlSystem> system = make_control_system(argc, argv);
        const auto parsed = parse_ctl_arguments(system->arguments());
        if (const auto* farewell = std::get_if<Farewell>(&parsed)) {
            fmt::print(farewell->exit_code == 0 ? stdout : stderr, "{}", farewell->text);
            return farewell->exit_code;
        }
        return run(*system, std::get<CtlCommandLine>(parsed));
    } catch (const std::exception& error) {
        return no_daemon({error.what()});
    }
}
