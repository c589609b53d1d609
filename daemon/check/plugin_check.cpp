// SPDX-License-Identifier: MIT
#include "daemon/check/plugin_check.h"

#include "daemon/check/check_run.h"
#include "daemon/core/files.h"
#include "daemon/core/plugins.h"
#include "daemon/core/profile.h"
#include "daemon/core/sprite_set.h"
#include "daemon/core/stage.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

constexpr double minute = 60.0;
constexpr double longest_tests = 3'600.0;

void add_lines(std::vector<std::string>& list, std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        list.emplace_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
}

// Those that everybody has, and its own.
std::vector<Kind> kinds_for(
    const Plugin& plugin, const fs::path& shipped, const ImageDecoder& decode, PluginReport& report
) {
    const Profile profile{
        .config = {}, .user = shipped / "config", .shipped = shipped, .more_scripts = {}
    };
    std::vector<SpriteSet> sets = completed(load_kinds(profile, decode), {}, profile).sets;
    for (ReadKind& kind : load_plugin_kinds(plugin, decode)) {
        if (kind.set) {
            sets.push_back(*std::move(kind.set));
        } else {
            add_lines(report.errors, kind.set.error().message);
        }
    }
    return kinds_of(sets);
}

// Scripts know themselves by the plugin's id, people by where their files are.
std::string with_place(const Plugin& plugin, const std::string& text) {
    const std::string folder = utf8_from_path(plugin.folder);
    if (text.starts_with(plugin.id + "/")) {
        return folder + text.substr(plugin.id.size());
    }
    const std::string entry = folder + "/" + plugin.entry + ":";
    if (text.starts_with(plugin.id + ":")) {
        return entry + text.substr(plugin.id.size() + 1);
    }
    return entry + " " + text;
}

void tell(const Plugin& plugin, const CheckRun& run, PluginReport& report) {
    for (const ScriptLog& line : run.log) {
        const bool is_frame = line.text.starts_with("    ");
        switch (line.level) {
            case LogLevel::error:
                report.errors.push_back(is_frame ? line.text : with_place(plugin, line.text));
                break;
            case LogLevel::warning:
                report.warnings.push_back(with_place(plugin, line.text));
                break;
            case LogLevel::info:
                report.said.push_back(line.text);
                break;
        }
    }
}

void run_cases(
    ScriptSource source, const Plugin& plugin, std::vector<Kind> kinds, PluginReport& report
) {
    source.testing = true;
    CheckRun run = run_script(std::move(source), std::move(kinds), longest_tests);
    for (const ScriptTest& test : run.tests) {
        if (test.problem.empty()) {
            ++report.cases;
        } else {
            report.errors.push_back(
                with_place(plugin, test.problem) + " (in the case \"" + test.name + "\")"
            );
        }
    }
    if (run.open_tests > 0) {
        report.errors.push_back(with_place(
            plugin, fmt::format("{} cases did not end within {} s", run.open_tests, longest_tests)
        ));
    }
}

}  // namespace

PluginReport check_plugin(
    const fs::path& folder, const fs::path& shipped, const ImageDecoder& decode
) {
    PluginReport report;
    const Result<Plugin> plugin = read_plugin(folder, report.warnings);
    if (!plugin) {
        add_lines(report.errors, plugin.error().message);
        return report;
    }
    const std::vector<Kind> kinds = kinds_for(*plugin, shipped, decode, report);
    if (!report.good()) {
        return report;
    }
    // Nothing is chosen: the defaults hold, and none of them can be wrong.
    const ScriptSource source = source_of(*plugin, {}, report.errors);
    tell(*plugin, run_script(source, kinds, minute), report);
    if (report.good()) {
        run_cases(source, *plugin, kinds, report);
    }
    return report;
}

}  // namespace hyrax
