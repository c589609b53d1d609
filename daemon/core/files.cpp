// SPDX-License-Identifier: MIT
#include "daemon/core/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <system_error>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

// Generic conditions have English texts; Windows would describe its own codes in the code page.
std::string reason(const std::error_code& code) {
    const std::error_condition condition = code.default_error_condition();
    return condition.category() == std::generic_category() ? condition.message()
                                                           : fmt::format("error {}", code.value());
}

// Streams report through errno at best.
std::string stream_reason() {
    return errno != 0 ? reason({errno, std::generic_category()}) : "unknown error";
}

std::string too_large(const fs::path& path, std::uintmax_t size, std::size_t max_bytes) {
    return fmt::format(
        "{}: is too large: {} bytes, at most {} are read", utf8_from_path(path), size, max_bytes
    );
}

// Asked before opening: opening a named pipe could wait forever.
Result<std::size_t> checked_size(const fs::path& path, std::size_t max_bytes) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (status.type() == fs::file_type::not_found) {
        return failure(fmt::format("{}: there is no such file", utf8_from_path(path)));
    }
    if (status.type() == fs::file_type::directory) {
        return failure(fmt::format("{}: is a folder, not a file", utf8_from_path(path)));
    }
    if (status.type() == fs::file_type::none || status.type() == fs::file_type::unknown) {
        return failure(fmt::format("{}: cannot be read: {}", utf8_from_path(path), reason(code)));
    }
    if (status.type() != fs::file_type::regular) {
        return failure(fmt::format("{}: is not an ordinary file", utf8_from_path(path)));
    }
    const std::uintmax_t size = fs::file_size(path, code);
    if (code) {
        return failure(fmt::format("{}: cannot be read: {}", utf8_from_path(path), reason(code)));
    }
    if (size > max_bytes) {
        return failure(too_large(path, size, max_bytes));
    }
    return static_cast<std::size_t>(size);
}

// `Buffer` is a string or a vector of bytes.
template <typename Buffer>
Result<Buffer> read_file(const fs::path& path, std::size_t max_bytes) {
    const Result<std::size_t> size = checked_size(path, max_bytes);
    if (!size) {
        return std::unexpected(size.error());
    }
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return failure(
            fmt::format("{}: cannot be opened: {}", utf8_from_path(path), stream_reason())
        );
    }
    Buffer content(*size, typename Buffer::value_type{});
    file.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(*size));
    if (file.bad()) {
        return failure(fmt::format("{}: cannot be read: {}", utf8_from_path(path), stream_reason())
        );
    }
    // Shorter than announced when another program is just writing it.
    content.resize(static_cast<std::size_t>(file.gcount()));
    return content;
}

Result<void> write_file(const fs::path& path, std::string_view text) {
    errno = 0;
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) {
        return failure(
            fmt::format("{}: cannot be written: {}", utf8_from_path(path), stream_reason())
        );
    }
    return {};
}

}  // namespace

Result<std::string> read_text_file(const fs::path& path, std::size_t max_bytes) {
    constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
    Result<std::string> text = read_file<std::string>(path, max_bytes);
    if (text && text->starts_with(utf8_mark)) {
        text->erase(0, utf8_mark.size());
    }
    return text;
}

Result<std::vector<std::byte>> read_binary_file(const fs::path& path, std::size_t max_bytes) {
    return read_file<std::vector<std::byte>>(path, max_bytes);
}

Result<void> write_file_atomically(const fs::path& path, std::string_view text) {
    fs::path fresh = path;
    fresh += ".new";
    std::error_code code;
    const Result<void> written = write_file(fresh, text);
    if (!written) {
        fs::remove(fresh, code);
        return written;
    }
    fs::rename(fresh, path, code);
    if (code) {
        const std::string why = reason(code);
        fs::remove(fresh, code);
        return failure(fmt::format("{}: cannot be replaced: {}", utf8_from_path(path), why));
    }
    return {};
}

std::string stamp_of_folder(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code unreadable;
        files.push_back(fmt::format(
            " {} {} {}",
            utf8_from_path(entry->path()),
            entry->is_regular_file(unreadable) ? entry->file_size(unreadable) : 0,
            entry->last_write_time(unreadable).time_since_epoch().count()
        ));
    }
    // The order of a folder's entries is nobody's promise.
    std::ranges::sort(files);
    return fmt::format("{}", fmt::join(files, ""));
}

std::string utf8_from_path(const fs::path& path) {
    try {
        const std::u8string text = path.u8string();
        return {reinterpret_cast<const char*>(text.data()), text.size()};
    } catch (const std::exception&) {  // Windows allows names that are not valid UTF-16
        return "(a file whose name is not valid Unicode)";
    }
}

fs::path path_from_utf8(std::string_view text) {
    return std::u8string(reinterpret_cast<const char8_t*>(text.data()), text.size());
}

}  // namespace hyrax
