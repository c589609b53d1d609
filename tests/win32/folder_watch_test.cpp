// SPDX-License-Identifier: MIT
#include "daemon/win32/folder_watch.h"

#include "daemon/win32/clock.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace hyrax;
using namespace hyrax::win32;

namespace {

namespace fs = std::filesystem;

class TestFolder {
public:
    TestFolder() { fs::create_directories(path / "logs"); }
    ~TestFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    const fs::path path =
        fs::temp_directory_path() / ("hyrax watch " + std::to_string(::GetCurrentProcessId()));
};

void write(const fs::path& file) {
    std::ofstream(file) << "text";
}

int changes_within(FolderWatch& watch, Ticks span) {
    int changes = 0;
    for (const Ticks end = clock_now() + span; clock_now() < end;) {
        ::WaitForSingleObject(watch.event(), 20);
        changes += watch.check(clock_now()) ? 1 : 0;
    }
    return changes;
}

/// Waits for a change, patiently for the sake of busy machines, and that it is the only one.
bool changes_once(FolderWatch& watch) {
    for (int i = 0; i < 50; ++i) {
        if (const int changes = changes_within(watch, 200 * ticks_per_ms)) {
            return changes + changes_within(watch, 600 * ticks_per_ms) == 1;
        }
    }
    return false;
}

}  // namespace

TEST_CASE("a burst of writes is one change, in folders below as well") {
    const TestFolder folder;
    fs::create_directories(folder.path / "scripts");
    FolderWatch watch(folder.path, {L"logs"}, clock_now());
    CHECK(changes_within(watch, 300 * ticks_per_ms) == 0);

    write(folder.path / "config.json.new");
    fs::rename(folder.path / "config.json.new", folder.path / "config.json");
    write(folder.path / "config.json");
    CHECK(changes_once(watch));

    write(folder.path / "scripts" / "a.lua");
    CHECK(changes_once(watch));
}

TEST_CASE("what is ignored is ignored, whatever its case") {
    const TestFolder folder;
    FolderWatch watch(folder.path, {L"LOGS"}, clock_now());
    write(folder.path / "logs" / "hyrax.log");
    CHECK(changes_within(watch, 600 * ticks_per_ms) == 0);
}

TEST_CASE("a folder that goes and comes back is watched again") {
    const TestFolder folder;
    write(folder.path / "config.json");
    FolderWatch watch(folder.path, {L"logs"}, clock_now());
    fs::remove_all(folder.path);
    CHECK(changes_once(watch));
    fs::create_directories(folder.path);
    CHECK(changes_once(watch));
    write(folder.path / "config.json");
    CHECK(changes_once(watch));
}

TEST_CASE("a folder that is not there yet is found") {
    const TestFolder folder;
    FolderWatch watch(folder.path / "later", {}, clock_now());
    fs::create_directories(folder.path / "later");
    CHECK(changes_once(watch));
}
