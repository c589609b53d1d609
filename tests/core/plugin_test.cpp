// SPDX-License-Identifier: MIT
// Manifests and the folders around them.
#include "daemon/core/plugin.h"

#include "daemon/core/files.h"
#include "tests/support/png_header.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace hyrax;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

// Every field once, and right.
const json whole = json::parse(R"({
    "$schema": "plugin.schema.json", "manifest": 1, "id": "rock-concert", "version": "1.2.0-rc.1+5",
    "api": "1.0", "name": "Rock Concert", "description": "d", "author": "a", "license": "MIT",
    "entry": "start.lua", "permissions": ["hotkeys", "cursor", "hotkeys"],
    "kinds": {"rocker": "sprites/rocker/sprite.json"},
    "config": [{"key": "jumps", "type": "integer", "default": 5, "min": 1, "max": 20, "label": "l"},
               {"key": "mood", "type": "string", "default": "wild", "choices": ["wild", "calm"]}],
    "on_reload": "remove"
})");

json changed(const std::string& pointer, const json& value) {
    json manifest = whole;
    manifest[json::json_pointer(pointer)] = value;
    return manifest;
}

std::string errors_of(const std::string& text) {
    std::vector<std::string> warnings;
    const Result<Plugin> plugin = parse_plugin(text, "plugin.json", warnings);
    return plugin ? "no error" : plugin.error().message;
}

std::string errors_of(const json& manifest) {
    return errors_of(manifest.dump());
}

std::vector<std::string> warnings_of(const json& manifest) {
    std::vector<std::string> warnings;
    CHECK(parse_plugin(manifest.dump(), "plugin.json", warnings));
    return warnings;
}

// What is refused: the value, and how the message tells it.
struct Wrong {
    std::string pointer;
    json value;
    std::string expected;
    std::string found;
};

const std::vector<Wrong> wrong_values{
    {"/manifest", 2, "must be a whole number from 1 to 1", "2"},
    {"/manifest", "1", "must be a whole number from 1 to 1", "\"1\""},
    {"/id", "Rock", "must be 3 to 40 small letters", "\"Rock\""},
    {"/id", "-ab", "must be 3 to 40 small letters", "\"-ab\""},
    {"/id", "ab", "must be 3 to 40 small letters", "\"ab\""},
    {"/id", "com1", "must be 3 to 40 small letters", "\"com1\""},
    {"/id", "../ab", "must be 3 to 40 small letters", "\"../ab\""},
    {"/id", "user", "must be 3 to 40 small letters", "\"user\""},
    {"/id", 7, "must be 3 to 40 small letters", "7"},
    {"/version", "1.2", "must be a version as semver.org has it", "\"1.2\""},
    {"/version", "01.2.3", "must be a version as semver.org has it", "\"01.2.3\""},
    {"/version", "1.2.3-", "must be a version as semver.org has it", "\"1.2.3-\""},
    {"/version", "1.2.3-a..b", "must be a version as semver.org has it", "\"1.2.3-a..b\""},
    {"/version", "1.2.3-01", "must be a version as semver.org has it", "\"1.2.3-01\""},
    {"/version", "1.2.3.4", "must be a version as semver.org has it", "\"1.2.3.4\""},
    {"/version", 1.2, "must be a version as semver.org has it", "1.2"},
    {"/api", "2.0", "must be a version of hyrax.api", "\"2.0\""},
    {"/api", "1.99", "must be a version of hyrax.api", "\"1.99\""},
    {"/api", "1", "must be a version of hyrax.api", "\"1\""},
    {"/api", 1.0, "must be a version of hyrax.api", "1.0"},
    {"/name", "", "must be a text of 1 to 100 bytes in one line", "\"\""},
    {"/name", "a\nb", "must be a text of 1 to 100 bytes in one line", "\"a\\nb\""},
    {"/description", 1, "must be a text of 1 to 500 bytes in one line", "1"},
    {"/author", json::array(), "must be a text of 1 to 100 bytes in one line", "a list [ ]"},
    {"/license", nullptr, "must be a text of 1 to 100 bytes in one line", "null"},
    {"/entry", "../main.lua", "must be a file in this folder", "\"../main.lua\""},
    {"/entry", "/main.lua", "must be a file in this folder", "\"/main.lua\""},
    {"/entry", "c:main.lua", "must be a file in this folder", "\"c:main.lua\""},
    {"/entry", "a\\main.lua", "must be a file in this folder", "\"a\\\\main.lua\""},
    {"/entry", "main.txt", "must be a file in this folder that ends in .lua", "\"main.txt\""},
    {"/entry", "nul.lua", "must be a file in this folder", "\"nul.lua\""},
    {"/entry", "a./b.lua", "must be a file in this folder", "\"a./b.lua\""},
    {"/entry", true, "must be a file in this folder", "true"},
    {"/permissions", "cursor", "must be a list [ ] of 0 to 64 items", "\"cursor\""},
    {"/permissions/0", "network", "must be \"cursor\", ", "\"network\""},
    {"/permissions/0", "hotkey", "must be \"cursor\", ", "\"hotkey\"; did you mean \"hotkeys\"?"},
    {"/kinds", json::array(), "must be an object { }", "a list [ ]"},
    {"/kinds/rocker", "rocker.png", "must be a file in this folder", "\"rocker.png\""},
    {"/kinds/rocker", "../sprite.json", "must be a file in this folder", "\"../sprite.json\""},
    {"/config", json::object(), "must be a list [ ] of 0 to 64 items", "an object { }"},
    {"/config/0", 1, "must be an object { }", "1"},
    {"/config/0/key", "enabled", "must be 1 to 64 small letters", "\"enabled\""},
    {"/config/0/key", "Jumps", "must be 1 to 64 small letters", "\"Jumps\""},
    {"/config/0/key", 3, "must be 1 to 64 small letters", "3"},
    {"/config/0/type", "int", "must be \"boolean\", ", "\"int\""},
    {"/config/0/default", 21, "must be a whole number from 1 to 20", "21"},
    {"/config/0/default", 1.5, "must be a whole number from 1 to 20", "1.5"},
    {"/config/0/default", "5", "must be a whole number from 1 to 20", "\"5\""},
    {"/config/0/default", nullptr, "must be a whole number from 1 to 20", "null"},
    {"/config/0/min", "1", "must be a number from -9000000000000000 to 9000", "\"1\""},
    {"/config/0/max", false, "must be a number from -9000000000000000 to 9000", "false"},
    {"/config/0/label", 5, "must be a text of 1 to 100 bytes in one line", "5"},
    {"/config/1/default", "sad", "must be \"wild\" or \"calm\"", "\"sad\""},
    {"/config/1/choices", json::array(), "must be a list [ ] of 1 to 64 items", "0"},
    {"/config/1/choices/0", 4, "must be a text of 1 to 100 bytes", "4"},
    {"/config/1/key", "jumps", "must be a key that no other setting has", "\"jumps\""},
    {"/on_reload", "stay", "must be \"keep\" or \"remove\"", "\"stay\""},
};

const std::string smallest =
    R"({"manifest": 1, "id": "abc", "version": "1.0.0", "api": "1.0", "name": "A"})";

Result<Plugin> read(const TemporaryFolder& folder, std::vector<std::string>* told = nullptr) {
    std::vector<std::string> warnings;
    Result<Plugin> plugin = read_plugin(folder.path(), warnings);
    if (told != nullptr) {
        *told = warnings;
    }
    return plugin;
}

}  // namespace

TEST_CASE("plugin: every field arrives where it belongs") {
    std::vector<std::string> warnings;
    const Result<Plugin> read = parse_plugin(whole.dump(), "plugin.json", warnings);
    REQUIRE_MESSAGE(read, errors_of(whole));
    const Plugin& plugin = *read;
    CHECK(warnings.empty());
    CHECK(plugin.id == "rock-concert");
    CHECK(plugin.version == "1.2.0-rc.1+5");
    CHECK(plugin.api == "1.0");
    CHECK(plugin.name == "Rock Concert");
    CHECK(plugin.description == "d");
    CHECK(plugin.author == "a");
    CHECK(plugin.license == "MIT");
    CHECK(plugin.entry == "start.lua");
    CHECK(plugin.permissions == std::vector<std::string>{"cursor", "hotkeys"});
    REQUIRE(plugin.kinds.size() == 1);
    CHECK(plugin.kinds[0].name == "rocker");
    CHECK(plugin.kinds[0].file == "sprites/rocker/sprite.json");
    REQUIRE(plugin.settings.size() == 2);
    CHECK(plugin.settings[0].key == "jumps");
    CHECK(plugin.settings[0].low == 1.0);
    CHECK(plugin.settings[0].high == 20.0);
    CHECK(plugin.settings[0].default_value == ScriptValue{std::int64_t{5}});
    CHECK(plugin.settings[1].choices == std::vector<std::string>{"wild", "calm"});
    CHECK_FALSE(plugin.keep_pets);
}

TEST_CASE("plugin: each field wrong in turn: a message with file, field, expected and found") {
    std::set<std::string> wrong_once{"/$schema"};
    for (const Wrong& wrong : wrong_values) {
        CAPTURE(wrong.pointer);
        const std::string message = errors_of(changed(wrong.pointer, wrong.value));
        CHECK_MESSAGE(message.starts_with("plugin.json:1:"), message);
        // What depends on a broken field may fail as well, behind it.
        const std::string line = ": " + wrong.pointer + ": " + wrong.expected;
        CHECK_MESSAGE(message.contains(line), message);
        CHECK_MESSAGE(message.contains(", got " + wrong.found), message);
        std::string path = wrong.pointer;
        if (path.starts_with("/config/")) {
            path = "/config/*" + path.substr(9);
        }
        wrong_once.insert(path);
    }
    for (const PluginField& field : plugin_fields()) {
        CHECK_MESSAGE(wrong_once.contains(field.path), field.path);
    }
}

TEST_CASE("plugin: each required field missing in turn") {
    for (const PluginField& field : plugin_fields()) {
        CAPTURE(field.path);
        json manifest = whole;
        std::string path = field.path;
        if (path.starts_with("/config/*")) {
            path.replace(8, 1, "0");
        }
        const std::size_t slash = path.rfind('/');
        const std::string key = path.substr(slash + 1);
        manifest[json::json_pointer(path.substr(0, slash))].erase(key);
        const std::string message = errors_of(manifest);
        if (field.required) {
            CHECK_MESSAGE(message.contains("\"" + key + "\" is missing"), message);
        } else {
            CHECK(message == "no error");
        }
    }
}

TEST_CASE("plugin: what only some settings have") {
    const json boolean{{"key", "on"}, {"type", "boolean"}, {"default", true}};
    CHECK(errors_of(changed("/config/0", boolean)) == "no error");
    for (const auto& [key, value] :
         std::map<std::string, json>{{"min", 1}, {"max", 1}, {"choices", {"a"}}}) {
        json setting = boolean;
        setting[key] = value;
        const std::string message = errors_of(changed("/config/0", setting));
        CHECK_MESSAGE(message.contains(": /config/0/" + key + ": only a "), message);
    }
    CHECK(errors_of(changed("/config/0/min", 30)).contains("/config/0/min: must not be above max"));
}

TEST_CASE("plugin: unknown fields are warnings that name the nearest one") {
    CHECK(warnings_of(changed("/permisions", 1))
              .at(0)
              .ends_with(": /permisions: unknown key; did you mean \"permissions\"?"));
    CHECK(warnings_of(changed("/config/0/lable", 1))
              .at(0)
              .ends_with(": /config/0/lable: unknown key; did you mean \"label\"?"));
}

TEST_CASE("plugin: names of kinds are as restricted as ids") {
    for (const char* const bad : {"a/b", "..", "", "A", "-a", "a234567890123456789012345"}) {
        json kinds = json::object();
        kinds[bad] = "a/sprite.json";
        const std::string message = errors_of(changed("/kinds", kinds));
        CHECK_MESSAGE(message.contains("a kind's name must be"), bad);
    }
}

TEST_CASE("plugin: values fit settings, or the message says what does") {
    PluginSetting setting{.key = "k", .type = SettingType::number, .low = 0.5};
    CHECK(fitted(setting, {std::int64_t{3}}) == ScriptValue{3.0});
    CHECK(fitted(setting, {0.0}).error().message == "must be a number of at least 0.5");
    setting = {.key = "k", .type = SettingType::integer, .high = 9};
    CHECK(fitted(setting, {3.0}) == ScriptValue{std::int64_t{3}});
    CHECK(fitted(setting, {10.0}).error().message == "must be a whole number of at most 9");
    setting = {.key = "k", .type = SettingType::string};
    CHECK(fitted(setting, {std::string("x")}) == ScriptValue{std::string("x")});
    CHECK(fitted(setting, {}).error().message == "must be a text in double quotes");
    setting = {.key = "k", .type = SettingType::boolean};
    CHECK(fitted(setting, {std::int64_t{1}}).error().message == "must be true or false");
}

TEST_CASE("plugin: the folder's Lua files are read, by the names that require takes") {
    const TemporaryFolder folder;
    folder.write("plugin.json", smallest);
    folder.write("main.lua", "-- main");
    folder.write("lib/score.lua", "-- score");
    folder.write("lib/deep/_x1.lua", "-- x");
    folder.write("odd-name.lua", "-- odd");
    folder.write("hyrax.d.lua", "-- not a script");
    folder.write(".git/hook.lua", "-- hidden");
    std::vector<std::string> warnings;
    const Result<Plugin> plugin = read(folder, &warnings);
    REQUIRE_MESSAGE(plugin, plugin.error().message);
    CHECK(plugin->text == "-- main");
    CHECK(
        plugin->modules ==
        std::vector<ScriptModule>{{"lib.deep._x1", "-- x"}, {"lib.score", "-- score"}}
    );
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].contains("odd-name.lua: nothing can require it"));
}

TEST_CASE("plugin: files that the manifest names must be there") {
    const TemporaryFolder folder;
    CHECK(read(folder).error().message.ends_with("plugin.json: there is no such file"));
    json manifest = json::parse(smallest);
    manifest["kinds"]["ball"] = "ball/sprite.json";
    folder.write("plugin.json", manifest.dump());
    const std::string message = read(folder).error().message;
    CHECK(message.contains("/entry: must be a file in this folder, got \"main.lua\""));
    CHECK(message.contains("/kinds/ball: must be a file in this folder, got \"ball/sprite.json\""));
}

TEST_CASE("plugin: links out of the folder are refused, links within it are fine") {
    const TemporaryFolder folder;
    folder.write("p/plugin.json", smallest);
    folder.write("p/real.lua", "-- real");
    folder.write("outside.lua", "-- outside");
    std::vector<std::string> warnings;
    std::error_code error;
    fs::create_symlink("real.lua", folder.path() / "p/main.lua", error);
    if (error) {
        return;  // Windows lets few people make links
    }
    CHECK(read_plugin(folder.path() / "p", warnings)->text == "-- real");
    fs::create_symlink("../outside.lua", folder.path() / "p/more.lua");
    const Result<Plugin> refused = read_plugin(folder.path() / "p", warnings);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.contains("more.lua: is a link to something outside"));
    // Behind a link to a folder nobody has looked, and sprite.json could name what is there.
    for (const fs::path target : {"..", ".", "nowhere"}) {
        fs::remove(folder.path() / "p/more.lua");
        fs::create_symlink(target, folder.path() / "p/more.lua");
        const Result<Plugin> other = read_plugin(folder.path() / "p", warnings);
        REQUIRE_FALSE(other);
        CHECK(other.error().message.ends_with("more.lua: is a link, but not to a file of the plugin"
        ));
    }
}

TEST_CASE("plugin: folders that are too large are refused") {
    const TemporaryFolder folder;
    folder.write("plugin.json", smallest);
    folder.write("main.lua", "");
    folder.write("big.bin", "");
    fs::resize_file(folder.path() / "big.bin", most_plugin_bytes);
    CHECK(read(folder).error().message.contains("holds more than 200 files or 32 MiB"));
    fs::resize_file(folder.path() / "big.bin", 0);
    CHECK(read(folder));
    folder.write("a.lua", std::string(most_plugin_source / 2 + 1, ' '));
    folder.write("b.lua", std::string(most_plugin_source / 2 + 1, ' '));
    CHECK(read(folder).error().message.contains("b.lua: is too large"));
    for (int i = 0; i < 200; ++i) {
        folder.write("f" + std::to_string(i), "");
    }
    CHECK(read(folder).error().message.contains("holds more than 200 files"));
}

TEST_CASE("plugin: pictures that say they are too large are refused, whatever their names") {
    const TemporaryFolder folder;
    folder.write("plugin.json", smallest);
    folder.write("main.lua", "");
    folder.write("art/sheet.png", png_header(most_plugin_side, most_plugin_side));
    CHECK(read(folder));
    folder.write("art/more.dat", png_header(5, most_plugin_side + 1));
    folder.write("art/sheet.png", png_header(0xFFFFFFFF, 5));
    const std::string message = read(folder).error().message;
    CHECK(message.contains("more.dat: is 5 x 4097 pixels; a plugin's pictures have at most 4096 "));
    CHECK(message.contains("sheet.png: is 2147483647 x 5 pixels; "));
}

TEST_CASE("plugin: plugin.schema.json and the program know the same fields") {
    const auto text =
        read_text_file(fs::path(HYRAX_SOURCE_DIR) / "config" / "plugin.schema.json", 1U << 20U);
    REQUIRE(text);
    const json schema = json::parse(*text);
    json top = schema["properties"];
    json items = schema["properties"]["config"]["items"]["properties"];
    for (const PluginField& field : plugin_fields()) {
        CAPTURE(field.path);
        const bool setting = field.path.starts_with("/config/*");
        const std::string key = field.path.substr(field.path.rfind('/') + 1);
        json& place = setting ? items : top;
        REQUIRE(place.contains(key));
        CHECK(place[key]["description"] == field.description);
        CHECK(place[key].value("title", "") != "");
        if (!field.type.empty()) {
            CHECK(place[key]["type"] == field.type);
        }
        const json required =
            setting ? schema["properties"]["config"]["items"]["required"] : schema["required"];
        CHECK((std::ranges::count(required, json(key)) != 0) == field.required);
        place.erase(key);
    }
    CHECK(top.empty());
    CHECK(items.empty());
    CHECK(
        schema["properties"]["permissions"]["items"]["enum"] ==
        json(std::vector<std::string>(script_permissions.begin(), script_permissions.end()))
    );
}
