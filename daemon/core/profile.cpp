// SPDX-License-Identifier: MIT
#include "daemon/core/profile.h"

#include "daemon/core/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_script_bytes = std::size_t{1} << 20U;

// UTF-8, whatever the system's own encoding of paths is.
std::string text_of(const fs::path& path) {
    const std::u8string text = path.generic_u8string();
    return {text.begin(), text.end()};
}

// Folders that hold a sprite.json, by name; a name that is there already stays.
void find_sprite_folders(const fs::path& root, std::map<std::string, fs::path>& found) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(root, error)) {
        if (fs::exists(entry.path() / "sprite.json", error)) {
            found.emplace(text_of(entry.path().filename()), entry.path());
        }
    }
}

// Relative names of all Lua files below a folder, sorted.
std::set<std::string> lua_files(const fs::path& root) {
    std::set<std::string> names;
    std::error_code error;
    auto entry = fs::recursive_directory_iterator(root, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        const std::string name = text_of(entry->path().lexically_relative(root));
        if (name.ends_with(".lua") && !name.ends_with(".d.lua")) {
            names.insert(name);
        }
    }
    return names;
}

bool has_wildcard(std::string_view pattern) {
    return pattern.find_first_of("*?") != std::string_view::npos;
}

// A plain name must stay inside the folder it is looked up in.
bool is_inside(const fs::path& name) {
    return name.is_relative() && !name.has_root_name() &&
           std::ranges::none_of(name, [](const fs::path& part) { return part == ".."; });
}

}  // namespace

std::vector<ReadKind> load_kinds(const Profile& profile, const ImageDecoder& decode) {
    std::map<std::string, fs::path> folders;
    find_sprite_folders(profile.user / "sprites", folders);
    find_sprite_folders(profile.shipped / "config" / "sprites", folders);

    std::vector<ReadKind> kinds;
    const auto read = [&](const std::string& name, const fs::path& folder) {
        Result<SpriteSet> set = load_sprite_set(folder, decode, room_beside(kinds));
        if (set) {
            set->name = name;
        }
        kinds.push_back({name, std::move(set)});
    };
    // Whoever else wants room, there is always a hyrax.
    if (const auto first = folders.find("hyrax"); first != folders.end()) {
        read(first->first, first->second);
        folders.erase(first);
    }
    for (const auto& [name, folder] : folders) {
        read(name, folder);
    }
    std::ranges::sort(kinds, {}, &ReadKind::name);
    return kinds;
}

std::size_t room_beside(std::span<const ReadKind> kinds) {
    std::size_t room = most_sheet_pixels;
    for (const ReadKind& kind : kinds) {
        room -= kind.set ? kind.set->sheet.pixels.size() : 0;
    }
    return room;
}

LoadedKinds completed(
    std::vector<ReadKind> read, std::vector<SpriteSet> before, const Profile& profile
) {
    LoadedKinds loaded;
    std::size_t room = room_beside(read);
    for (ReadKind& kind : read) {
        if (kind.set) {
            loaded.sets.push_back(*std::move(kind.set));
            continue;
        }
        loaded.problems.push_back(kind.set.error().message);
        const auto old = std::ranges::find(before, kind.name, &SpriteSet::name);
        if (old != before.end() && old->sheet.pixels.size() <= room) {
            room -= old->sheet.pixels.size();
            loaded.sets.push_back(std::move(*old));
            before.erase(old);
        }
    }
    if (std::ranges::find(loaded.sets, "hyrax", &SpriteSet::name) == loaded.sets.end()) {
        loaded.problems.push_back(fmt::format(
            "no sprite set \"hyrax\" in {} or {}: showing a plain round pet instead",
            text_of(profile.user / "sprites"),
            text_of(profile.shipped / "config" / "sprites")
        ));
        loaded.sets.insert(loaded.sets.begin(), placeholder_sprite_set("hyrax"));
    }
    return loaded;
}

LoadedScripts load_scripts(const Profile& profile, const std::vector<std::string>& patterns) {
    const fs::path own = profile.user / "scripts";
    const fs::path shipped = profile.shipped / "scripts";
    const std::set<std::string> names = lua_files(own);

    LoadedScripts loaded;
    std::map<std::string, fs::path> chosen;
    for (const std::string& pattern : patterns) {
        if (has_wildcard(pattern)) {
            for (const std::string& name : names) {
                if (matches(pattern, name)) {
                    chosen.emplace(name, own / fs::path(std::u8string(name.begin(), name.end())));
                }
            }
            continue;
        }
        const fs::path name(std::u8string(pattern.begin(), pattern.end()));
        std::error_code error;
        if (is_inside(name) && fs::exists(own / name, error)) {
            chosen.emplace(pattern, own / name);
        } else if (is_inside(name) && fs::exists(shipped / name, error)) {
            chosen.emplace(pattern, shipped / name);
        } else {
            loaded.problems.push_back(fmt::format(
                "config.json: /scripts/run: there is no script \"{}\" in {} or {}",
                pattern,
                text_of(own),
                text_of(shipped)
            ));
        }
    }
    const auto read = [&loaded](const std::string& name, const fs::path& path) {
        Result<std::string> text = read_text_file(path, max_script_bytes);
        if (text) {
            loaded.sources.push_back({
                .name = name,
                .text = *std::move(text),
                .permissions = {script_permissions.begin(), script_permissions.end()},
            });
        } else {
            loaded.problems.push_back(text.error().message);
        }
    };
    for (const auto& [name, path] : chosen) {
        read(name, path);
    }
    for (const fs::path& path : profile.more_scripts) {
        if (std::error_code error; fs::is_directory(path, error)) {
            continue;  // A plugin: plugins.h
        }
        read(text_of(path.filename()), path);
    }
    return loaded;
}

// Only the last star is ever tried again: what an earlier one could take instead, the later one
// can take as well, and none crosses a '/'.
bool matches(std::string_view pattern, std::string_view name) {
    std::size_t at = 0;
    std::size_t position = 0;
    std::optional<std::size_t> star;
    std::size_t star_end = 0;
    while (position < name.size()) {
        const bool one =
            at < pattern.size() && pattern[at] != '*' &&
            (pattern[at] == name[position] || (pattern[at] == '?' && name[position] != '/'));
        if (one) {
            ++at;
            ++position;
        } else if (at < pattern.size() && pattern[at] == '*') {
            star = at++;
            star_end = position;
        } else if (star && name[star_end] != '/') {
            at = *star + 1;
            position = ++star_end;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', at) == std::string_view::npos;
}

Result<void> prepare(const Profile& profile) {
    std::error_code error;
    for (const fs::path& folder :
         {profile.user, profile.user / "scripts", profile.user / "sprites", profile.user / "plugins"
         }) {
        fs::create_directories(folder, error);
        if (error) {
            return failure(fmt::format("{}: cannot be made: {}", text_of(folder), error.message()));
        }
    }
    if (!fs::exists(profile.config, error)) {
        fs::copy_file(profile.shipped / "config" / "config.json", profile.config, error);
        if (error) {
            return failure(fmt::format(
                "{}: cannot be copied from the shipped one: {}",
                text_of(profile.config),
                error.message()
            ));
        }
    }
    // The schemas describe this program's keys, whatever an older one has left here.
    // Not fs::copy_file: in mingw-w64's library it never overwrites.
    for (const char* schema : {"schema.json", "sprite.schema.json", "plugin.schema.json"}) {
        if (const auto text =
                read_text_file(profile.shipped / "config" / schema, max_script_bytes)) {
            if (auto written = write_file_atomically(profile.user / schema, *text); !written) {
                return written;
            }
        }
    }
    return {};
}

}  // namespace hyrax
