// SPDX-License-Identifier: MIT
#include "daemon/core/links.h"

#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <system_error>

using namespace hyrax;
namespace fs = std::filesystem;

TEST_CASE("links: a folder goes with all that is in it, a link alone") {
    const TemporaryFolder folder;
    folder.write("outside/file", "stays");
    folder.write("tree/a/file", "goes");
    const fs::path tree = folder.path() / "tree";
    CHECK_FALSE(is_link(tree));
    CHECK_FALSE(is_link(tree / "nothing"));
    CHECK(real_path(tree / "nothing").empty());
    CHECK(real_path(tree / "a" / ".." / "a") == real_path(tree / "a"));
    std::error_code error;
    fs::create_directory_symlink(folder.path() / "outside", tree / "a" / "link", error);
    // The library of mingw-w64 makes no links; test_control.py has one that Wine shows.
    if (!error) {
        fs::create_symlink("nowhere", tree / "loose");
        CHECK(is_link(tree / "a" / "link"));
        CHECK(is_link(tree / "loose"));
        CHECK(real_path(tree / "a" / "link" / "file") == real_path(folder.path() / "outside/file"));
        CHECK(real_path(tree / "loose").empty());
    }
    remove_tree(tree, error);
    CHECK_FALSE(error);
    CHECK_FALSE(fs::exists(tree));
    CHECK(folder.read("outside/file") == "stays");
    remove_tree(tree, error);
    CHECK_FALSE(error);
}
