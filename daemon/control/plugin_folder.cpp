// SPDX-License-Identifier: MIT
#include "daemon/control/plugin_folder.h"

#include "daemon/control/archive.h"
#include "daemon/core/files.h"
#include "daemon/core/links.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>
#include <vector>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

// Not a plugin's name, so that a daemon that looks meanwhile sees none.
constexpr std::string_view unpacking = ".new";
constexpr std::string_view leaving = ".old";

std::unexpected<Error> file_failure(
    const fs::path& path, std::string_view what, const std::error_code& error
) {
    return failure(fmt::format("{}: {}: {}", utf8_from_path(path), what, error.message()));
}

/// An empty folder, which is gone with the object.
class Workplace {
public:
    static Result<Workplace> make(const fs::path& path) {
        std::error_code error;
        remove_tree(path, error);
        fs::create_directories(path, error);
        if (error) {
            return file_failure(path, "cannot be made", error);
        }
        return Workplace(path);
    }
    Workplace(Workplace&& other) noexcept : path_(std::exchange(other.path_, {})) {}
    Workplace& operator=(Workplace&&) = delete;
    ~Workplace() {
        std::error_code error;
        if (!path_.empty()) {
            remove_tree(path_, error);
        }
    }
    const fs::path& path() const { return path_; }

private:
    explicit Workplace(fs::path path) : path_(std::move(path)) {}
    fs::path path_;
};

// Links are followed by nobody: read_plugin() has looked at the folder, but it may have changed.
Result<void> copy_folder(const fs::path& from, const fs::path& to) {
    std::error_code error;
    auto entry = fs::recursive_directory_iterator(from, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        const fs::path& path = entry->path();
        if (path.filename().native().starts_with('.')) {
            entry.disable_recursion_pending();
            continue;
        }
        const fs::path target = to / path.lexically_relative(from);
        if (is_link(path)) {
            return failure(utf8_from_path(path) + ": is a link");
        }
        if (entry->is_directory(error)) {
            fs::create_directories(target, error);
        } else if (entry->is_regular_file(error)) {
            fs::copy_file(path, target, error);
        }
        if (error) {
            return file_failure(path, "cannot be copied", error);
        }
    }
    return error ? Result<void>(file_failure(from, "cannot be read", error)) : Result<void>();
}

Result<void> unpack_file(const fs::path& file, const fs::path& to) {
    const Result<std::unique_ptr<Archive>> archive = open_archive(file);
    if (!archive) {
        return std::unexpected(archive.error());
    }
    if (const Result<void> unpacked = unpack(**archive, to); !unpacked) {
        return failure(utf8_from_path(file) + ": " + unpacked.error().message);
    }
    return {};
}

// Many archives hold one folder, in which everything is.
fs::path root_in(const fs::path& folder) {
    std::error_code error;
    if (fs::exists(folder / plugin_manifest_name, error)) {
        return folder;
    }
    std::vector<fs::path> entries;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        entries.push_back(entry.path());
    }
    return entries.size() == 1 && fs::is_directory(entries.front(), error) ? entries.front()
                                                                           : folder;
}

// The old one steps aside first: if the new one cannot come, it is back.
Result<void> take_place(const fs::path& from, const fs::path& place) {
    std::error_code error;
    const fs::path aside = place.parent_path() / (place.filename().string() + std::string(leaving));
    const bool replaces = fs::exists(place, error);
    if (replaces) {
        remove_tree(aside, error);
        fs::rename(place, aside, error);
        if (error) {
            return file_failure(place, "cannot be replaced", error);
        }
    }
    fs::rename(from, place, error);
    if (error) {
        std::error_code ignored;
        if (replaces) {
            fs::rename(aside, place, ignored);
        }
        return file_failure(place, "cannot be made", error);
    }
    remove_tree(aside, error);
    return {};
}

}  // namespace

fs::path plugins_of(const fs::path& profile) {
    return profile / "plugins";
}

Result<Plugin> install_plugin(const fs::path& from, const fs::path& profile, bool replace) {
    const fs::path plugins = plugins_of(profile);
    std::error_code error;
    const bool is_folder = fs::is_directory(from, error);
    std::vector<std::string> warnings;
    if (is_folder) {
        // Before anything is copied: it may be any folder at all.
        if (Result<Plugin> plugin = read_plugin(from, warnings); !plugin) {
            return plugin;
        }
    }
    const Result<Workplace> work = Workplace::make(plugins / unpacking);
    if (!work) {
        return std::unexpected(work.error());
    }
    const Result<void> unpacked =
        is_folder ? copy_folder(from, work->path()) : unpack_file(from, work->path());
    if (!unpacked) {
        return std::unexpected(unpacked.error());
    }
    const fs::path root = root_in(work->path());
    Result<Plugin> plugin = read_plugin(root, warnings);
    if (!plugin) {
        // Where it comes from is of more use than where it was unpacked.
        std::string message = plugin.error().message;
        const std::string here = utf8_from_path(root);
        for (std::size_t at = 0; (at = message.find(here, at)) != std::string::npos;) {
            message.replace(at, here.size(), utf8_from_path(from));
        }
        return failure(message);
    }
    const fs::path place = plugins / plugin->id;
    if (!replace && fs::exists(place, error)) {
        return failure(fmt::format(
            "{}: is there already; --replace puts version {} in its place",
            utf8_from_path(place),
            plugin->version
        ));
    }
    if (const Result<void> placed = take_place(root, place); !placed) {
        return std::unexpected(placed.error());
    }
    plugin->folder = place;
    return plugin;
}

Result<void> remove_plugin(const std::string& id, const fs::path& profile) {
    const fs::path place = plugins_of(profile) / id;
    std::error_code error;
    if (!is_plugin_id(id) || is_link(place) || !fs::is_directory(place, error)) {
        return failure(
            fmt::format("there is no plugin \"{}\" in {}", id, utf8_from_path(plugins_of(profile)))
        );
    }
    // No daemon sees half of it.
    const fs::path aside = plugins_of(profile) / (id + std::string(leaving));
    fs::rename(place, aside, error);
    if (error) {
        return file_failure(place, "cannot be removed", error);
    }
    remove_tree(aside, error);
    return error ? Result<void>(file_failure(aside, "cannot be removed", error)) : Result<void>();
}

}  // namespace hyrax
