// SPDX-License-Identifier: MIT
#include "daemon/control/archive.h"

#include "daemon/core/ascii.h"
#include "daemon/core/file_name.h"
#include "daemon/core/files.h"
#include "daemon/core/plugin.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <system_error>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

std::unexpected<Error> unsafe(std::string_view name, std::string_view why) {
    constexpr std::size_t longest = 200;
    const nlohmann::json quoted = std::string(name.substr(0, longest));
    return failure(fmt::format(
        "{}: {}", quoted.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace), why
    ));
}

// Windows leaves out dots and blanks at the end of a name.
bool is_plain_part(std::string_view part) {
    constexpr std::string_view forbidden = "\\:*?\"<>|";
    constexpr std::size_t longest = 100;
    return !part.empty() && part.size() <= longest && part.back() != '.' && part.back() != ' ' &&
           part.front() != ' ' && std::ranges::all_of(part, [&forbidden](char c) {
               return c >= 0x20 && c < 0x7F && !forbidden.contains(c);
           });
}

std::string folded(std::string_view name) {
    std::string small(name);
    std::ranges::transform(small, small.begin(), lower_ascii);
    return small;
}

// Counts what comes, whatever the archive says of itself.
class Budget {
public:
    Result<void> take_file() {
        return ++files_ <= most_plugin_files
                   ? Result<void>()
                   : failure(fmt::format("holds more than {} files", most_plugin_files));
    }
    Result<void> take(std::size_t bytes) {
        bytes_ += bytes;
        return bytes_ <= most_plugin_bytes
                   ? Result<void>()
                   : failure(fmt::format("holds more than {} MiB", most_plugin_bytes >> 20U));
    }

private:
    std::size_t files_ = 0;
    std::size_t bytes_ = 0;
};

Result<void> write_entry(Archive& archive, const fs::path& path, Budget& budget) {
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (error || !file) {
        return failure(utf8_from_path(path) + ": cannot be written");
    }
    const Result<void> read = archive.read([&](std::string_view piece) {
        const Result<void> fits = budget.take(piece.size());
        file.write(piece.data(), static_cast<std::streamsize>(piece.size()));
        return fits;
    });
    if (!read) {
        return read;
    }
    file.close();
    return file ? Result<void>() : failure(utf8_from_path(path) + ": cannot be written");
}

}  // namespace

Result<fs::path> safe_path(std::string_view name) {
    fs::path path;
    std::string_view rest = name;
    if (rest.ends_with('/')) {
        rest.remove_suffix(1);
    }
    while (true) {
        const std::string_view part = rest.substr(0, rest.find('/'));
        if (!is_plain_part(part) || names_device(part)) {
            return unsafe(name, "is no name that is safe on every system");
        }
        path /= fs::path(std::string(part));
        if (part.size() == rest.size()) {
            return path;
        }
        rest.remove_prefix(part.size() + 1);
    }
}

Result<void> unpack(Archive& archive, const fs::path& folder) {
    Budget budget;
    std::set<std::string> names;
    ArchiveEntry entry;
    while (true) {
        const Result<bool> more = archive.next(entry);
        if (!more) {
            return std::unexpected(more.error());
        }
        if (!*more) {
            return {};
        }
        if (const Result<void> fits = budget.take_file(); !fits) {
            return fits;
        }
        if (entry.is_link || entry.is_encrypted) {
            return unsafe(entry.name, entry.is_link ? "is a link" : "is encrypted");
        }
        const Result<fs::path> path = safe_path(entry.name);
        if (!path) {
            return std::unexpected(path.error());
        }
        if (!names.insert(folded(entry.name)).second) {
            return unsafe(entry.name, "comes twice, as far as some systems see");
        }
        if (entry.name.ends_with('/')) {
            continue;
        }
        if (const Result<void> written = write_entry(archive, folder / *path, budget); !written) {
            return written;
        }
    }
}

}  // namespace hyrax
