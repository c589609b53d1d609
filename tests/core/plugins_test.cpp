// SPDX-License-Identifier: MIT
// Which plugins run, and with which settings.
#include "daemon/core/plugins.h"

#include "daemon/core/config.h"
#include "tests/support/png_header.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

using namespace hyrax;

namespace {

std::string manifest(const std::string& id, const std::string& more = "") {
    return R"({"manifest": 1, "id": ")" + id +
           R"(", "version": "1.0.0", "api": "1.0", "name": "N")" + more + "}";
}

struct Found {
    Found() {
        folder.write("user/plugins/own/plugin.json", manifest("own"));
        folder.write("user/plugins/own/main.lua", "-- own");
        folder.write("shipped/scripts/plugins/own/plugin.json", manifest("own"));
        folder.write("shipped/scripts/plugins/own/main.lua", "-- shipped");
        folder.write("shipped/scripts/plugins/extra/plugin.json", manifest("extra"));
        folder.write("shipped/scripts/plugins/extra/main.lua", "-- extra");
    }
    void look() {
        warnings.clear();
        plugins = find_plugins(profile, plugins, warnings);
        judge(plugins, choices, remembered);
    }
    std::string states() const {
        std::string text;
        for (const PluginEntry& entry : plugins) {
            text += entry.id + " " + std::string(name_of(entry.state)) + "\n";
        }
        return text;
    }

    TemporaryFolder folder;
    Profile profile{
        .config = folder.path() / "user" / "config.json",
        .user = folder.path() / "user",
        .shipped = folder.path() / "shipped",
        .more_scripts = {},
    };
    PluginChoices choices;
    Remembered remembered;
    std::vector<PluginEntry> plugins;
    std::vector<std::string> warnings;
};

const std::string settings =
    R"(, "config": [{"key": "jumps", "type": "integer", "default": 5, "min": 1, "max": 20},)"
    R"({"key": "mood", "type": "string", "default": "wild"}])";

ScriptSource source_with(const std::string& config, std::vector<std::string>& problems) {
    std::vector<std::string> warnings;
    const Result<Plugin> plugin = parse_plugin(manifest("own", settings), "plugin.json", warnings);
    REQUIRE(plugin);
    const Result<LoadedConfig> loaded =
        parse_config("{\"plugins\": {\"own\": " + config + "}}", "config.json");
    REQUIRE(loaded);
    return source_of(*plugin, loaded->config.plugins.at("own"), problems);
}

}  // namespace

TEST_CASE("plugins: the user's are on, shipped ones off, and the user's come first") {
    Found found;
    found.look();
    CHECK(found.states() == "extra off\nown on\n");
    CHECK(found.plugins[1].plugin->text == "-- own");
    found.choices["own"].enabled = false;
    found.choices["extra"].enabled = true;
    found.look();
    CHECK(found.states() == "extra on\nown off\n");
    found.remembered.plugins = {{"own", true}, {"extra", false}};
    found.look();
    CHECK(found.states() == "extra off\nown on\n");
}

TEST_CASE("plugins: who asks for permissions waits for all of them") {
    Found found;
    const std::string asks = R"(, "permissions": ["wind", "cursor"])";
    found.folder.write("user/plugins/own/plugin.json", manifest("own", asks));
    found.look();
    CHECK(found.states() == "extra off\nown asks\n");
    CHECK(
        asking_text(found.plugins) == "plugin own asks for: cursor, wind (tray menu: Plugins, or "
                                      "hyraxctl plugins allow own)"
    );
    found.remembered.granted["own"] = {"cursor"};
    found.look();
    CHECK(found.plugins[1].missing == std::vector<std::string>{"wind"});
    found.remembered.granted["own"] = {"cursor", "wind"};
    found.look();
    CHECK(found.states() == "extra off\nown on\n");
    CHECK(asking_text(found.plugins).empty());
    found.remembered.plugins["own"] = false;
    found.remembered.granted.clear();
    found.look();
    CHECK(asking_text(found.plugins).empty());
}

TEST_CASE("plugins: a manifest that breaks keeps the one before it") {
    Found found;
    found.look();
    found.folder.write("user/plugins/own/plugin.json", "{");
    found.look();
    CHECK(found.states() == "extra off\nown on\n");
    CHECK(found.plugins[1].plugin->text == "-- own");
    REQUIRE(problems_of(found.plugins, {}).size() == 1);
    CHECK(problems_of(found.plugins, {})[0].contains("plugin.json:1:2: "));
    std::filesystem::remove_all(found.profile.user / "plugins" / "own");
    found.look();
    CHECK(found.states() == "extra off\nown off\n");  // the shipped one
}

TEST_CASE("plugins: broken from the start, in a folder of another name, named but not there") {
    Found found;
    found.folder.write("user/plugins/own/plugin.json", manifest("other"));
    found.choices["none"].enabled = true;
    found.look();
    CHECK(found.states() == "extra off\nown broken\n");
    const std::vector<std::string> problems = problems_of(found.plugins, found.choices);
    REQUIRE(problems.size() == 2);
    CHECK(problems[0].ends_with("/id: must be the name of its folder, \"own\", got \"other\""));
    CHECK(problems[1] == "config.json: /plugins/none: there is no such plugin");
}

TEST_CASE("plugins: warnings are told once for each change") {
    Found found;
    found.folder.write("user/plugins/own/plugin.json", manifest("own", ", \"nmae\": 1"));
    found.look();
    REQUIRE(found.warnings.size() == 1);
    CHECK(found.warnings[0].ends_with("/nmae: unknown key; did you mean \"name\"?"));
    found.look();
    CHECK(found.warnings.empty());
}

TEST_CASE("plugins: a folder on the command line runs with all that it asks for") {
    Found found;
    found.folder.write("there/plugin.json", manifest("there", R"(, "permissions": ["wind"])"));
    found.folder.write("there/main.lua", "");
    found.profile.more_scripts = {found.folder.path() / "there" / ""};
    found.look();
    CHECK(found.states() == "extra off\nown on\nthere on\n");
}

TEST_CASE("plugins: settings come from the config where they fit, else from the manifest") {
    std::vector<std::string> problems;
    ScriptSource source = source_with(R"({"jumps": 7.0})", problems);
    CHECK(source.name == "own");
    CHECK(source.version == "1.0.0");
    CHECK(
        source.config == ScriptTable{{"jumps", {std::int64_t{7}}}, {"mood", {std::string("wild")}}}
    );
    CHECK(problems.empty());
    source = source_with(R"({"enabled": true, "jumps": 30, "mood": [1], "moot": 1})", problems);
    CHECK(source.config[0].value == ScriptValue{std::int64_t{5}});
    REQUIRE(problems.size() == 3);
    CHECK(
        problems[0] == "config.json:1:48: /plugins/own/jumps: must be a whole number from 1 to 20, "
                       "got 30; the default 5 is used"
    );
    CHECK(
        problems[1] ==
        "config.json:1:60: /plugins/own/mood: must be a text in double quotes, got a "
        "list [ ]; the default \"wild\" is used"
    );
    CHECK(
        problems[2] == "config.json:1:73: /plugins/own/moot: the plugin has no such setting; did "
                       "you mean \"mood\"?"
    );
}

TEST_CASE("plugins: what its kinds take in memory is bounded, however they share pictures") {
    const TemporaryFolder folder;
    const std::string sprite = R"({"sheet": "sheet.png", "cell": {"width": 4096, "height": 1365},)"
                               R"( "box": {"x": 0, "y": 0, "width": 4096, "height": 1365},)"
                               R"( "animations": {"idle": {"frames": [{"cell": 0, "ms": 100}]}}})";
    Plugin plugin{.folder = folder.path(), .id = "own"};
    for (const std::string name : {"a", "b", "c", "d", "e"}) {
        folder.write(name + "/sprite.json", sprite);
        folder.write(name + "/sheet.png", png_header(4096, 1365));
        plugin.kinds.push_back({name, name + "/sprite.json"});
    }
    int decoded = 0;
    const ImageDecoder decode = [&decoded](std::span<const std::byte>) -> Result<Image> {
        ++decoded;
        return Image(Size{4096, 1365});
    };
    const std::vector<ReadKind> kinds = load_plugin_kinds(plugin, decode);
    CHECK(decoded == 4);
    REQUIRE(kinds.size() == 4);
    CHECK(kinds[2].name == "own/c");
    REQUIRE_MESSAGE(kinds[2].set, kinds[2].set.error().message);
    CHECK(kinds[2].set->name == "own/c");
    REQUIRE_FALSE(kinds[3].set);
    CHECK(kinds[3].set.error().message.ends_with(
        "plugin.json: /kinds/d: the pictures up to this one have 22364160 pixels; those of a "
        "plugin have at most 16777216"
    ));
}
