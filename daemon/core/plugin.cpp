// SPDX-License-Identifier: MIT
// A plugin's folder: what is in it, and what it weighs.
#include "daemon/core/plugin.h"

#include "daemon/core/files.h"
#include "daemon/core/links.h"
#include "daemon/core/png_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_manifest_bytes = std::size_t{256} << 10U;

std::string range_text(const PluginSetting& setting) {
    const bool above = setting.low > -most_setting;
    const bool below = setting.high < most_setting;
    if (above && below) {
        return fmt::format(" from {} to {}", setting.low, setting.high);
    }
    return above   ? fmt::format(" of at least {}", setting.low)
           : below ? fmt::format(" of at most {}", setting.high)
                   : "";
}

std::optional<double> number_in(const ScriptValue& value) {
    if (const auto* const whole = std::get_if<std::int64_t>(&value.data)) {
        return static_cast<double>(*whole);
    }
    const auto* const number = std::get_if<double>(&value.data);
    return number == nullptr ? std::nullopt : std::optional(*number);
}

Result<ScriptValue> fitted_number(const PluginSetting& setting, const ScriptValue& value) {
    const bool whole = setting.type == SettingType::integer;
    const std::optional<double> number = number_in(value);
    if (!number || !(*number >= setting.low && *number <= setting.high) ||
        (whole && *number != std::floor(*number))) {
        return failure(
            fmt::format("must be a {}number{}", whole ? "whole " : "", range_text(setting))
        );
    }
    return whole ? ScriptValue{static_cast<std::int64_t>(*number)} : ScriptValue{*number};
}

Result<ScriptValue> fitted_text(const PluginSetting& setting, const ScriptValue& value) {
    const auto* const text = std::get_if<std::string>(&value.data);
    if (text == nullptr) {
        return failure("must be a text in double quotes");
    }
    if (!setting.choices.empty() && std::ranges::count(setting.choices, *text) == 0) {
        return failure(fmt::format("must be \"{}\"", fmt::join(setting.choices, "\" or \"")));
    }
    return value;
}

// Files of the folder by their names relative to it.
using Files = std::map<std::string, fs::path>;

// The lines of one error message.
class Faults {
public:
    void add(std::string line) { lines_.push_back(std::move(line)); }
    bool any() const { return !lines_.empty(); }
    std::unexpected<Error> as_failure() const {
        return failure(fmt::format("{}", fmt::join(lines_, "\n")));
    }

private:
    std::vector<std::string> lines_;
};

bool is_hidden(const fs::path& path) {
    return path.filename().native().starts_with('.');
}

// Whether the file is in the folder once every link has been followed.
bool stays_inside(const fs::path& file, const fs::path& real_folder) {
    const fs::path real = real_path(file);
    const auto [end, rest] = std::ranges::mismatch(real_folder, real);
    return end == real_folder.end();
}

// Stops looking once there are too many.
Files files_in(const fs::path& folder, Faults& faults) {
    Files files;
    std::error_code error;
    const fs::path real_folder = real_path(folder);
    std::uintmax_t bytes = 0;
    auto entry = fs::recursive_directory_iterator(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        if (is_hidden(entry->path())) {
            entry.disable_recursion_pending();
            continue;
        }
        std::error_code unreadable;
        if (!entry->is_regular_file(unreadable)) {
            // Some libraries would go on behind it, and so would whoever names a file there.
            if (is_link(entry->path())) {
                faults.add(fmt::format(
                    "{}: is a link, but not to a file of the plugin", utf8_from_path(entry->path())
                ));
                entry.disable_recursion_pending();
            }
            continue;
        }
        if (!stays_inside(entry->path(), real_folder)) {
            faults.add(fmt::format(
                "{}: is a link to something outside of the plugin's folder",
                utf8_from_path(entry->path())
            ));
            continue;
        }
        bytes += entry->file_size(unreadable);
        const fs::path name = entry->path().lexically_relative(folder);
        files.emplace(utf8_from_path(fs::path(name.generic_u8string())), entry->path());
        if (files.size() > most_plugin_files || bytes > most_plugin_bytes) {
            faults.add(fmt::format(
                "{}: holds more than {} files or {} MiB",
                utf8_from_path(folder),
                most_plugin_files,
                most_plugin_bytes >> 20U
            ));
            break;
        }
    }
    return files;
}

std::optional<Size> picture_size(const fs::path& path) {
    std::array<char, png_header_bytes> beginning{};
    std::ifstream file(path, std::ios::binary);
    file.read(beginning.data(), beginning.size());
    return file ? png_size(std::as_bytes(std::span(beginning))) : std::nullopt;
}

// Before anything is decoded. Whatever its name: sprite.json may call its sheet as it likes.
void check_pictures(const Files& files, Faults& faults) {
    for (const auto& [name, path] : files) {
        const std::optional<Size> size = picture_size(path);
        if (size && std::max(size->width, size->height) > most_plugin_side) {
            faults.add(fmt::format(
                "{}: is {} x {} pixels; a plugin's pictures have at most {} a side",
                utf8_from_path(path),
                size->width,
                size->height,
                most_plugin_side
            ));
        }
    }
}

// "lib/score.lua" is "lib.score"; nothing for a name that `require` does not take.
std::optional<std::string> module_name(std::string_view file) {
    constexpr std::size_t longest = 64;
    file.remove_suffix(std::string_view(".lua").size());
    std::string name;
    for (const char c : file) {
        const bool first = name.empty() || name.back() == '.';
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        if (!letter && (first || !((c >= '0' && c <= '9') || c == '/'))) {
            return std::nullopt;
        }
        name += c == '/' ? '.' : c;
    }
    return name.empty() || name.size() > longest ? std::nullopt : std::optional(name);
}

void read_sources(
    Plugin& plugin, const Files& files, Faults& faults, std::vector<std::string>& warnings
) {
    std::size_t bytes = 0;
    for (const auto& [name, path] : files) {
        if (!name.ends_with(".lua") || name.ends_with(".d.lua")) {
            continue;
        }
        Result<std::string> text = read_text_file(path, most_plugin_source - bytes);
        if (!text) {
            faults.add(fmt::format(
                "{} (the Lua of a plugin may be {} bytes in all)",
                text.error().message,
                most_plugin_source
            ));
            continue;
        }
        bytes += text->size();
        if (name == plugin.entry) {
            plugin.text = *std::move(text);
        } else if (auto module = module_name(name); module && *module != "hyrax") {
            plugin.modules.push_back({*std::move(module), *std::move(text)});
        } else {
            warnings.push_back(fmt::format(
                "{}: nothing can require it: the names of files and folders must be letters, "
                "digits and _",
                utf8_from_path(path)
            ));
        }
    }
    std::ranges::sort(plugin.modules, {}, &ScriptModule::name);
}

void look_for(
    const Files& files,
    const std::string& file,
    const std::string& manifest,
    std::string_view pointer,
    Faults& faults
) {
    if (!files.contains(file)) {
        faults.add(fmt::format(
            "{}: {}: must be a file in this folder, got \"{}\", which is not there",
            manifest,
            pointer,
            file
        ));
    }
}

}  // namespace

Result<ScriptValue> fitted(const PluginSetting& setting, const ScriptValue& value) {
    switch (setting.type) {
        case SettingType::boolean:
            if (!std::holds_alternative<bool>(value.data)) {
                return failure("must be true or false");
            }
            return value;
        case SettingType::integer:
        case SettingType::number:
            return fitted_number(setting, value);
        case SettingType::string:
            return fitted_text(setting, value);
    }
    return failure("must be of a type that is known");
}

Result<Plugin> read_plugin(const fs::path& folder, std::vector<std::string>& warnings) {
    const fs::path file = folder / plugin_manifest_name;
    const std::string manifest = utf8_from_path(file);
    const Result<std::string> text = read_text_file(file, most_manifest_bytes);
    if (!text) {
        return std::unexpected(text.error());
    }
    Result<Plugin> plugin = parse_plugin(*text, manifest, warnings);
    if (!plugin) {
        return plugin;
    }
    plugin->folder = folder;
    Faults faults;
    const Files files = files_in(folder, faults);
    if (!faults.any()) {
        look_for(files, plugin->entry, manifest, "/entry", faults);
        for (const PluginKind& kind : plugin->kinds) {
            look_for(files, kind.file, manifest, "/kinds/" + kind.name, faults);
        }
        check_pictures(files, faults);
        read_sources(*plugin, files, faults, warnings);
    }
    if (faults.any()) {
        return faults.as_failure();
    }
    return plugin;
}

}  // namespace hyrax
