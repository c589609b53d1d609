// SPDX-License-Identifier: MIT
#include "daemon/control/command_line.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace hyrax {
namespace {

std::filesystem::path path_of(const std::string& utf8) {
    return std::filesystem::path(std::u8string(utf8.begin(), utf8.end()));
}

// CLI11 parses into plain values that outlive the parsing.
struct Raw {
    int spawn = 1;
    std::string trace;
    std::string profile;
    std::string config;
    std::vector<std::string> scripts;
    std::string snapshot;
};

// CLI::Range lets NaN pass, which is neither below nor above anything.
CLI::Validator between(double low, double high) {
    return {
        [low, high](const std::string& text) -> std::string {
            double value = 0.0;
            const bool inside =
                CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
            return inside ? "" : fmt::format("expected a number from {} to {}", low, high);
        },
        "FLOAT",
    };
}

template <typename R>
void add_request(
    CLI::App& app, CommonOptions& common, const char* name, R request, const char* help
) {
    app.add_flag_callback(
        name, [&common, request] { common.requests.emplace_back(request); }, help
    );
}

void add_common(CLI::App& app, CommonOptions& common, Raw& raw) {
    app.set_version_flag("--version", std::string("hyrax ") + HYRAX_VERSION);
    app.add_option_function<int>(
           "--spawn",
           [&common](int count) { common.requests.emplace_back(request::Spawn{.count = count}); },
           "Spawn this many hyraxes"
    )
        ->check(CLI::Range(1, 1000));
    add_request(app, common, "--fling-all", request::FlingAll{}, "Throw every pet upwards");
    add_request(
        app, common, "--reset-all", request::ResetAll{}, "Put every pet back where it was spawned"
    );
    add_request(app, common, "--remove-all", request::RemoveAll{}, "Remove every pet");
    add_request(app, common, "--pause", request::SetPaused{true}, "Freeze pets and scripts");
    add_request(app, common, "--resume", request::SetPaused{false}, "Let them go on");
    add_request(
        app, common, "--reload", request::Reload{}, "Read config, sprite sets and scripts again"
    );
    app.add_option("--trace", raw.trace, "Write every frame of every pet to this CSV file");
    app.add_flag(
        "--for-testing", common.for_testing, "Broken checks abort; the same run every time"
    );
}

// Runs the parser; an answer means that the program has only to print it and to end.
std::optional<Farewell> parse(CLI::App& app, std::vector<std::string> arguments) {
    // CLI11 takes the arguments in reverse order.
    std::ranges::reverse(arguments);
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::ParseError& error) {
        std::ostringstream out;
        std::ostringstream err;
        const int code = app.exit(error, out, err);
        return Farewell{out.str() + err.str(), code == 0 ? 0 : 2};
    }
    return std::nullopt;
}

std::optional<std::filesystem::path> given(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional(path_of(text));
}

}  // namespace

std::variant<DaemonCommandLine, Farewell> parse_daemon_arguments(
    const std::vector<std::string>& arguments
) {
    CLI::App app("hyrax: many bouncing hyraxes on the desktop", "hyrax");
    app.footer(
        "A second start hands its options to the running daemon, without any option it spawns "
        "a hyrax."
    );
    DaemonCommandLine line;
    Raw raw;
    add_common(app, line.common, raw);
    add_request(app, line.common, "--quit", request::Quit{}, "End the running daemon");
    app.add_option("--profile", raw.profile, "Folder of config.json, scripts and sprites");
    if (std::optional<Farewell> farewell = parse(app, arguments)) {
        return *std::move(farewell);
    }
    line.common.trace = given(raw.trace);
    line.profile = given(raw.profile);
    return line;
}

std::variant<HeadlessCommandLine, Farewell> parse_headless_arguments(
    const std::vector<std::string>& arguments
) {
    CLI::App app(
        "hyrax-headless: the daemon without a desktop, on a virtual clock", "hyrax-headless"
    );
    HeadlessCommandLine line;
    Raw raw;
    add_common(app, line.common, raw);
    app.add_option(
        "--config", raw.config, "A config.json; sprites/ and scripts/ are looked for beside it"
    );
    app.add_option("--script", raw.scripts, "A Lua script to run, may be repeated");
    app.add_option("--seconds", line.seconds, "How long to run [virtual seconds]")
        ->check(between(0.0, 1e6))
        ->capture_default_str();
    app.add_option("--fps", line.fps, "Frames a second instead of the config's")
        ->check(between(1.0, 1000.0));
    app.add_option(
           "--monitors", line.monitors, "WIDTHxHEIGHT+X+Y[,...]; the first one is the primary"
    )
        ->capture_default_str();
    app.add_option("--snapshot", raw.snapshot, "Write the last frame to this PNG file");
    app.add_flag(
        "--script-process",
        line.script_process,
        "Run scripts in a process of their own, as hyrax.exe does; time waits for it"
    );
    if (std::optional<Farewell> farewell = parse(app, arguments)) {
        return *std::move(farewell);
    }
    line.common.trace = given(raw.trace);
    line.config = given(raw.config);
    line.snapshot = given(raw.snapshot);
    for (const std::string& script : raw.scripts) {
        line.scripts.push_back(path_of(script));
    }
    return line;
}

}  // namespace hyrax
