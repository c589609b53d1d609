// SPDX-License-Identifier: MIT
#include "daemon/core/profile.h"

#include "tests/support/profile_folder.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace hyrax;

namespace {

Result<Image> no_decoder(std::span<const std::byte>) {
    return failure("not a readable PNG");
}

std::vector<std::string> names(const LoadedScripts& loaded) {
    std::vector<std::string> result;
    for (const ScriptSource& source : loaded.sources) {
        result.push_back(source.name);
    }
    return result;
}

}  // namespace

TEST_CASE("patterns match within one folder level") {
    CHECK(matches("*.lua", "a.lua"));
    CHECK(matches("*", ""));
    CHECK(matches("a?c*", "abcdef"));
    CHECK(matches("*a*b*c", "xxaxxbxxbxc"));
    CHECK(matches("examples/*.lua", "examples/fountain.lua"));
    CHECK_FALSE(matches("*.lua", "examples/fountain.lua"));
    CHECK_FALSE(matches("*.lua", "a.luac"));
    CHECK_FALSE(matches("a?c", "a/c"));
    CHECK_FALSE(matches("", "a"));
    // A pattern that a naive matcher would never finish.
    CHECK_FALSE(matches("*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*b", std::string(200, 'a')));
}

TEST_CASE("scripts come from the user's folder, named ones also from the shipped one") {
    const TemporaryFolder folder;
    folder.write("user/scripts/b.lua", "-- b");
    folder.write("user/scripts/a.lua", "-- a");
    folder.write("user/scripts/hyrax.d.lua", "-- meta");
    folder.write("user/scripts/notes.txt", "no");
    folder.write("user/scripts/deeper/c.lua", "-- c");
    folder.write("shipped/scripts/examples/fountain.lua", "-- fountain");
    folder.write("shipped/scripts/shipped_only.lua", "-- no");
    folder.write("shipped/scripts/examples/a.lua", "-- shipped a");
    const Profile profile = profile_in(folder);

    CHECK(names(load_scripts(profile, {"*.lua"})) == std::vector<std::string>{"a.lua", "b.lua"});
    CHECK(
        names(load_scripts(profile, {"deeper/*.lua"})) == std::vector<std::string>{"deeper/c.lua"}
    );
    CHECK(
        names(load_scripts(profile, {"examples/fountain.lua", "a.lua", "a.lua"})) ==
        std::vector<std::string>{"a.lua", "examples/fountain.lua"}
    );
    CHECK(load_scripts(profile, {"a.lua"}).sources[0].text == "-- a");
    CHECK(load_scripts(profile, {}).sources.empty());
}

TEST_CASE("a script that is not there is named, with the places it was looked for in") {
    const TemporaryFolder folder;
    folder.write("user/scripts/a.lua", "-- a");
    folder.write("outside.lua", "-- no");
    const LoadedScripts loaded =
        load_scripts(profile_in(folder), {"missing.lua", "../../outside.lua", "a.lua"});
    CHECK(names(loaded) == std::vector<std::string>{"a.lua"});
    REQUIRE(loaded.problems.size() == 2);
    CHECK(loaded.problems[0].contains("there is no script \"missing.lua\""));
    CHECK(loaded.problems[1].contains("\"../../outside.lua\""));
}

TEST_CASE("without a readable sprite set there is still a pet to show") {
    const TemporaryFolder folder;
    const Profile profile = profile_in(folder);
    const LoadedKinds none = completed(load_kinds(profile, no_decoder), {}, profile);
    REQUIRE(none.sets.size() == 1);
    CHECK(none.sets[0].name == "hyrax");
    REQUIRE(none.problems.size() == 1);
    CHECK(none.problems[0].contains("no sprite set \"hyrax\""));

    folder.write("user/sprites/hyrax/sprite.json", "{ broken");
    const LoadedKinds broken = completed(load_kinds(profile, no_decoder), {}, profile);
    CHECK(broken.sets.size() == 1);
    REQUIRE(broken.problems.size() == 2);
    CHECK(broken.problems[0].contains("sprite.json:1:"));
}

TEST_CASE("preparing a profile makes what is missing and overwrites nothing") {
    const TemporaryFolder folder;
    folder.write("shipped/config/config.json", "{\"overlay\": {\"fps\": 30}}");
    folder.write("shipped/config/schema.json", "new");
    folder.write("user/schema.json", "old");
    const Profile profile = profile_in(folder);
    REQUIRE(prepare(profile));
    CHECK(folder.read("user/config.json") == "{\"overlay\": {\"fps\": 30}}");
    CHECK(folder.read("user/schema.json") == "new");
    CHECK(std::filesystem::is_directory(profile.user / "scripts"));

    folder.write("user/config.json", "{}");
    REQUIRE(prepare(profile));
    CHECK(folder.read("user/config.json") == "{}");
}
