// SPDX-License-Identifier: MIT
#include "daemon/control/plugin_folder.h"

#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

using namespace hyrax;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a new plugin is whole, and makes no folder twice") {
    const TemporaryFolder folder;
    const Result<fs::path> made = new_plugin("catch-me", folder.path());
    REQUIRE(made.has_value());
    CHECK(*made == folder.path() / "catch-me");
    CHECK(names_in(*made) == Names{"README.md", "main.lua", "plugin.json"});
    std::vector<std::string> warnings;
    const Result<Plugin> plugin = read_plugin(*made, warnings);
    REQUIRE_MESSAGE(plugin.has_value(), plugin.error().message);
    CHECK(plugin->id == "catch-me");
    CHECK(warnings.empty());
    CHECK(new_plugin("catch-me", folder.path()).error().message.ends_with("is there already"));
    CHECK(new_plugin("../x", folder.path()).error().message.contains("is no id of a plugin"));
}

TEST_CASE("a plugin is installed as a whole, replaced on demand, and removed") {
    const TemporaryFolder folder;
    const fs::path profile = folder.path() / "profile";
    const fs::path made = new_plugin("catch-me", folder.path()).value();
    folder.write("catch-me/.git/config", "no part of it");
    const Result<Plugin> installed = install_plugin(made, profile, false);
    REQUIRE_MESSAGE(installed.has_value(), installed.error().message);
    CHECK(installed->folder == profile / "plugins" / "catch-me");
    CHECK(names_in(profile / "plugins") == Names{"catch-me"});
    CHECK(names_in(installed->folder) == Names{"README.md", "main.lua", "plugin.json"});

    folder.write("catch-me/main.lua", "-- another one");
    CHECK(install_plugin(made, profile, false).error().message.contains("--replace"));
    CHECK(folder.read("profile/plugins/catch-me/main.lua") != "-- another one");
    REQUIRE(install_plugin(made, profile, true).has_value());
    CHECK(folder.read("profile/plugins/catch-me/main.lua") == "-- another one");
    CHECK(names_in(profile / "plugins") == Names{"catch-me"});

    // What is broken takes nobody's place.
    folder.write("catch-me/plugin.json", "{");
    CHECK(install_plugin(made, profile, true)
              .error()
              .message.starts_with((made / "plugin.json").string() + ":1:"));
    CHECK(folder.read("profile/plugins/catch-me/main.lua") == "-- another one");

    CHECK_FALSE(remove_plugin("..", profile).has_value());
    CHECK_FALSE(remove_plugin("other", profile).has_value());
    CHECK(remove_plugin("catch-me", profile).has_value());
    CHECK(names_in(profile / "plugins").empty());
}

TEST_CASE("a plugin's folder that is a link is not followed when it goes") {
    const TemporaryFolder folder;
    const fs::path profile = folder.path() / "profile";
    const fs::path made = new_plugin("catch-me", folder.path()).value();
    fs::create_directories(profile / "plugins");
    std::error_code error;
    fs::create_directory_symlink(made, profile / "plugins" / "catch-me", error);
    if (error) {
        return;  // the library of mingw-w64 makes no links
    }
    CHECK_FALSE(remove_plugin("catch-me", profile).has_value());
    const fs::path other = folder.path() / "other";
    fs::copy(made, other);
    REQUIRE(install_plugin(other, profile, true).has_value());
    CHECK(names_in(profile / "plugins") == Names{"catch-me"});
    CHECK(names_in(made) == Names{"README.md", "main.lua", "plugin.json"});
}

TEST_CASE("what is no plugin is told, and leaves no trace") {
    const TemporaryFolder folder;
    const fs::path profile = folder.path() / "profile";
    CHECK_FALSE(install_plugin(folder.path() / "nothing", profile, false).has_value());
    folder.write("empty/readme.txt", "no plugin");
    CHECK(install_plugin(folder.path() / "empty", profile, false)
              .error()
              .message.contains("plugin.json"));
    folder.write("text.zip", "no zip file");
    CHECK(install_plugin(folder.path() / "text.zip", profile, false)
              .error()
              .message.contains("text.zip"));
    CHECK(names_in(profile / "plugins").empty());
}
