// SPDX-License-Identifier: MIT
#include "daemon/core/files.h"

#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>

using namespace hyrax;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t plenty = 1000;

fs::path written(const TemporaryFolder& folder, std::string_view name, std::string_view text) {
    folder.write(name, text);
    return folder.path() / name;
}

std::string complaint(const fs::path& path, std::size_t max_bytes = plenty) {
    const Result<std::string> text = read_text_file(path, max_bytes);
    return text ? "read it" : text.error().message;
}

}  // namespace

TEST_CASE("files: a text comes as it is, without the mark of UTF-8") {
    const TemporaryFolder folder;
    const std::string text("one\r\ntwo\n\0three", 14);
    CHECK(read_text_file(written(folder, "a.txt", text), plenty) == text);
    CHECK(read_text_file(written(folder, "b.txt", "\xEF\xBB\xBFtext"), plenty) == "text");
    CHECK(read_text_file(written(folder, "c.txt", ""), plenty) == "");
    CHECK(read_binary_file(written(folder, "d.txt", "\xEF\xBB\xBFtext"), plenty)->size() == 7);
}

TEST_CASE("files: what cannot be read says what it is") {
    const TemporaryFolder folder;
    const std::string missing = utf8_from_path(folder.path() / "missing.txt");
    CHECK(complaint(folder.path() / "missing.txt") == missing + ": there is no such file");
    CHECK(complaint(folder.path() / "no" / "where").ends_with(": there is no such file"));
    CHECK(complaint(folder.path()) == utf8_from_path(folder.path()) + ": is a folder, not a file");
    const fs::path file = written(folder, "a.txt", "12345");
    CHECK(complaint(file, 5) == "read it");
    CHECK(
        complaint(file, 4) == utf8_from_path(file) + ": is too large: 5 bytes, at most 4 are read"
    );
    CHECK(complaint(file / "below").starts_with(utf8_from_path(file / "below") + ": "));
}

TEST_CASE("files: a huge file is refused by its size") {
    const TemporaryFolder folder;
    const fs::path file = written(folder, "huge.json", "");
    fs::resize_file(file, 100'000'000);
    CHECK(complaint(file).ends_with(": is too large: 100000000 bytes, at most 1000 are read"));
}

TEST_CASE("files: what may not be read says so") {
    const TemporaryFolder folder;
    const fs::path file = written(folder, "secret.txt", "secret");
    fs::permissions(file, fs::perms::none);
    const std::string text = complaint(file);
    // The administrator, and Windows, whose file modes know no such bit, may read it all the same.
    if (text != "read it") {
        CHECK(text == utf8_from_path(file) + ": cannot be opened: Permission denied");
    }
    fs::permissions(file, fs::perms::owner_all);
}

TEST_CASE("files: a device is refused, not read for ever") {
    if (fs::exists("/dev/zero")) {
        CHECK(complaint("/dev/zero") == "/dev/zero: is not an ordinary file");
    }
}

TEST_CASE("files: writing replaces the whole file and leaves nothing else behind") {
    const TemporaryFolder folder;
    const fs::path file = written(folder, "a.txt", "a longer text than the new one");
    REQUIRE(write_file_atomically(file, "new\n"));
    CHECK(read_text_file(file, plenty) == "new\n");
    REQUIRE(write_file_atomically(folder.path() / "b.txt", "fresh"));
    CHECK(read_text_file(folder.path() / "b.txt", plenty) == "fresh");
    CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 2);
}

TEST_CASE("files: writing that fails keeps the old state") {
    const TemporaryFolder folder;
    const Result<void> nowhere = write_file_atomically(folder.path() / "no" / "a.txt", "text");
    REQUIRE_FALSE(nowhere);
    CHECK(
        nowhere.error().message.ends_with("a.txt.new: cannot be written: No such file or directory")
    );

    fs::create_directories(folder.path() / "taken" / "inside");
    const Result<void> over_folder = write_file_atomically(folder.path() / "taken", "text");
    REQUIRE_FALSE(over_folder);
    CHECK(over_folder.error().message.contains("taken: cannot be replaced: "));
    CHECK_FALSE(fs::exists(folder.path() / "taken.new"));
}

TEST_CASE("files: names beyond ASCII work on every system") {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / path_from_utf8("d\xC3\xA4ssie \xE5\xB2\xA9.txt");
    REQUIRE(write_file_atomically(file, "text"));
    CHECK(read_text_file(file, plenty) == "text");
    CHECK(utf8_from_path(file.filename()) == "d\xC3\xA4ssie \xE5\xB2\xA9.txt");
}
