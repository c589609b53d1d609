// SPDX-License-Identifier: MIT
#include "daemon/control/command_line.h"

#include "daemon/control/cli_parse.h"

#include <fmt/format.h>

#include <limits>

namespace hyrax {
namespace {

std::filesystem::path path_of(const std::string& utf8) {
    return std::filesystem::path(std::u8string(utf8.begin(), utf8.end()));
}

// CLI11 parses into plain values that outlive the parsing.
struct Raw {
    int spawn = 1;
    std::string trace;
    std::string statistics;
    std::string profile;
    std::string config;
    std::vector<std::string> scripts;
    std::string windows;
    std::string snapshot;
    std::string test;
    std::string state;
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

/// For a request that holds nothing but whether it is on.
template <typename R>
void add_switch(CLI::App& app, CommonOptions& common, const char* name, const char* help) {
    app.add_option_function<std::string>(
           name,
           [&common](const std::string& word) { common.requests.emplace_back(R{word == "on"}); },
           help
    )
        ->check(CLI::IsMember({"on", "off"}));
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
    add_request(app, common, "--gather", request::Gather{}, "Call every pet to this monitor");
    add_request(app, common, "--hide", request::Hide{}, "Hide all pets until they are shown");
    add_request(app, common, "--show", request::Show{}, "Show them again");
    add_switch<request::SetQuiet>(
        app, common, "--quiet", "Pets sit still, and scripts may not move them"
    );
    add_switch<request::SetClickThrough>(
        app, common, "--click-through", "The mouse reaches what lies below the pets"
    );
    add_request(app, common, "--pause", request::SetPaused{true}, "Freeze pets and scripts");
    add_request(app, common, "--resume", request::SetPaused{false}, "Let them go on");
    add_request(
        app, common, "--reload", request::Reload{}, "Read config, sprite sets and scripts again"
    );
    app.add_option("--trace", raw.trace, "Write every frame of every pet to this CSV file");
    app.add_option(
        "--stats",
        raw.statistics,
        "Add what was counted to this file, a line of JSON at the end and when asked"
    );
    app.add_flag(
        "--for-testing", common.for_testing, "Broken checks abort; the same run every time"
    );
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
    app.add_flag("--autostart", line.autostart, "For the entry that starts hyrax at logon");
    app.add_option("--profile", raw.profile, "Folder of config.json, scripts and sprites");
    if (std::optional<Farewell> farewell = parse(app, arguments)) {
        return *std::move(farewell);
    }
    line.common.trace = given(raw.trace);
    line.common.statistics = given(raw.statistics);
    line.profile = given(raw.profile);
    return line;
}

double HeadlessCommandLine::duration() const {
    if (serve && !seconds) {
        return std::numeric_limits<double>::infinity();
    }
    return seconds.value_or(test ? 3'600.0 : 10.0);
}

std::variant<HeadlessCommandLine, Farewell> parse_headless_arguments(
    const std::vector<std::string>& arguments
) {
    CLI::App app(
        "hyrax-headless: the daemon without a desktop, on a virtual clock or the real one",
        "hyrax-headless"
    );
    HeadlessCommandLine line;
    Raw raw;
    add_common(app, line.common, raw);
    app.add_option(
        "--config", raw.config, "A config.json; sprites/ and scripts/ are looked for beside it"
    );
    app.add_option("--script", raw.scripts, "A Lua script to run, may be repeated");
    app.add_flag(
        "--serve", line.serve, "Run on the real clock until told to quit, and listen to hyraxctl"
    );
    app.add_option(
           "--seconds",
           line.seconds,
           "How long to run [seconds of its clock]: 10, or with --test 3600 at most"
    )
        ->check(between(0.0, 1e6));
    app.add_flag(
        "--real-time",
        line.real_time,
        "Wait as on a screen, and draw every frame into memory; SIGUSR1 adds a line to --stats"
    );
    app.add_option("--test", raw.test, "Run the cases that this script makes with hyrax.test")
        ->excludes("--script")
        ->excludes("--serve")
        ->excludes("--real-time");
    app.add_option(
        "--state", raw.state, "Folder for what outlives the program; without it nothing does"
    );
    app.add_option("--fps", line.fps, "Frames a second instead of the config's")
        ->check(between(1.0, 1000.0));
    app.add_option(
           "--monitors",
           line.monitors,
           "WIDTHxHEIGHT+X+Y[@SCALE][,...]; the first one is the primary"
    )
        ->capture_default_str();
    app.add_option(
           "--windows",
           raw.windows,
           "A CSV file of other programs' windows: time,id,x,y,width,height[,active hidden overlay "
           "bar maximised]; the lines of one time are all of them, the topmost first"
    )
        ->excludes("--serve")
        ->excludes("--real-time");
    app.add_option("--snapshot", raw.snapshot, "Write the last frame to this PNG file");
    app.add_flag(
           "--script-process",
           line.script_process,
           "Run scripts in a process of their own, as hyrax.exe does; the virtual clock waits for "
           "it"
    )
        ->excludes("--test")
        ->excludes("--real-time");
    if (std::optional<Farewell> farewell = parse(app, arguments)) {
        return *std::move(farewell);
    }
    line.common.trace = given(raw.trace);
    line.common.statistics = given(raw.statistics);
    line.config = given(raw.config);
    line.windows = given(raw.windows);
    line.snapshot = given(raw.snapshot);
    line.test = given(raw.test);
    line.state = given(raw.state);
    for (const std::string& script : raw.scripts) {
        line.scripts.push_back(path_of(script));
    }
    return line;
}

}  // namespace hyrax
