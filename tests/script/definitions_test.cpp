// SPDX-License-Identifier: MIT
// scripts/hyrax.d.lua describes exactly what exists.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

using namespace hyrax;

namespace {

using Names = std::set<std::string>;

// The letters, digits and underscores at the front.
std::string_view word(std::string_view text) {
    const auto is_word = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    const auto end = std::ranges::find_if_not(text, is_word);
    return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

// Removes the prefix; false if the text does not begin with it.
bool skip(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) {
        return false;
    }
    text.remove_prefix(prefix.size());
    return true;
}

// "Class.name" for each documented field and function, "event.name" for each event.
// `writable` tells of each field of a pet whether it is said to be.
Names documented(std::map<std::string, bool>* writable = nullptr) {
    std::ifstream file(HYRAX_SOURCE_DIR "/scripts/hyrax.d.lua");
    REQUIRE(file.good());
    Names names;
    std::string current;
    for (std::string line; std::getline(file, line);) {
        std::string_view rest = line;
        if (skip(rest, "---@class hyrax")) {
            current = skip(rest, ".") ? word(rest) : "hyrax";
        } else if (skip(rest, "---@field ")) {
            skip(rest, "readonly ");
            if (const std::string_view name = word(rest); writable != nullptr && current == "Pet") {
                const bool can_only_be_read = line.contains("---@field readonly ");
                (*writable)[std::string(name)] = !can_only_be_read;
            }
            names.insert(current + "." + std::string(word(rest)));
        } else if (skip(rest, "function ")) {
            const std::string owner(word(rest));
            rest.remove_prefix(owner.size() + 1);
            names.insert(owner + "." + std::string(word(rest)));
        } else if (skip(rest, "---| \"")) {
            names.insert("event." + std::string(word(rest)));
        }
    }
    return names;
}

// The names that an error message lists, when it knows nothing near.
void add_listed(Names& names, const std::string& prefix, const std::string& text) {
    const std::string error = errors_of(text);
    const std::string_view opening = "(there are: ";
    const std::size_t start = error.find(opening);
    REQUIRE_MESSAGE(start != std::string::npos, error);
    const std::size_t end = error.find(')', start);
    std::istringstream words(error.substr(start + opening.size(), end - start - opening.size()));
    for (std::string name; words >> name;) {
        names.insert(prefix + "." + std::string(word(name)));
    }
}

Names existing() {
    FakeWorld world(ScriptLimits{.log_line = 4'096});
    world.load(
        {{.name = "test.lua",
          .text = R"(
        for name in pairs(hyrax) do print("hyrax." .. name) end
        for name in pairs(hyrax.log) do print("Log." .. name) end
        for name in pairs(hyrax.store) do print("Store." .. name) end
        for name in pairs(hyrax.plugin) do print("Plugin." .. name) end
        for name in pairs(hyrax.test) do print("Test." .. name) end
        for name in pairs(hyrax.arena()) do print("Rect." .. name) end
        for name in pairs(hyrax.monitors()[1]) do
            if hyrax.arena()[name] == nil then print("Monitor." .. name) end
        end
        assert(type(hyrax.on("land", print).cancel) == "function") print("Subscription.cancel")
    )",
          .testing = true}}
    );
    CHECK(world.errors() == "");
    Names names;
    std::istringstream lines(world.said());
    for (std::string line; std::getline(lines, line);) {
        names.insert(line);
    }
    add_listed(names, "Pet", "print(hyrax.spawn().qqqqqqqqqq)");
    add_listed(names, "SpawnOptions", "hyrax.spawn{ qqqqqqqqqq = 1 }");
    add_listed(names, "PlayOptions", "hyrax.spawn():play('idle', { qqqqqqqqqq = 1 })");
    add_listed(names, "PetFilter", "hyrax.pets{ qqqqqqqqqq = 1 }");
    add_listed(names, "Near", "hyrax.pets{ near = { qqqqqqqqqq = 1 } }");
    add_listed(names, "event", "hyrax.on('qqqqqqqqqq', print)");
    return names;
}

}  // namespace

TEST_CASE("hyrax.d.lua lists what exists, and nothing else") {
    const Names described = documented();
    const Names real = existing();
    for (const std::string& name : described) {
        CHECK_MESSAGE(real.contains(name), "described but missing: " << name);
    }
    for (const std::string& name : real) {
        CHECK_MESSAGE(described.contains(name), "not described: " << name);
    }
    CHECK(described.size() > 90);
}

TEST_CASE("every described field and method of a pet can be read") {
    std::string text = "local p = hyrax.spawn()\n";
    for (const std::string& name : documented()) {
        if (name.starts_with("Pet.")) {
            text += "assert(p." + name.substr(4) + " ~= nil)\n";
        }
    }
    CHECK(errors_of(text) == "");
}

TEST_CASE("the fields of a pet that are said to be writable are, and the others are not") {
    std::map<std::string, bool> writable;
    static_cast<void>(documented(&writable));
    CHECK(writable.size() > 10);
    for (const auto& [name, can_be_set] : writable) {
        CAPTURE(name);
        const std::string field = "p." + name;
        const std::string error = errors_of("local p = hyrax.spawn() " + field + " = " + field);
        CHECK(error.contains("can only be read") == !can_be_set);
        CHECK((error == "") == can_be_set);
    }
}

TEST_CASE("every event gives its handler as many values as it is said to") {
    std::ifstream file(HYRAX_SOURCE_DIR "/scripts/hyrax.d.lua");
    std::string counts;
    for (std::string line; std::getline(file, line);) {
        std::string_view rest = line;
        if (!skip(rest, "---| \"")) {
            continue;
        }
        const std::string name(word(rest));
        const std::size_t open = rest.find("fun(");
        REQUIRE(open != std::string_view::npos);
        const std::string_view arguments = rest.substr(open + 4, rest.find(')') - open - 4);
        const auto commas = std::ranges::count(arguments, ':');
        counts += name + " " + std::to_string(commas) + "\n";
    }
    FakeWorld world;
    const PetKey a = world.add_pet();
    const PetKey b = world.add_pet();
    ScriptSource source{
        .name = "test.lua",
        .text = "for _, name in ipairs{ 'ready', 'tick', 'spawn', 'remove', 'grab', 'throw', "
                "'bounce', 'land', 'click', 'collide', 'monitors', 'config', 'unload' } do "
                "local s s = hyrax.on(name, function(...) print(name, select('#', ...)) s:cancel() "
                "end) end",
    };
    world.load({source});
    world.skip(1.0);
    for (const EventKind kind :
         {EventKind::spawn,
          EventKind::grab,
          EventKind::throw_pet,
          EventKind::bounce,
          EventKind::land,
          EventKind::click}) {
        world.happens({.kind = kind}, a);
        world.run();
        if (kind == EventKind::spawn) {
            world.take_away(b);
            world.run();
        }
    }
    const PetKey c = world.add_pet();
    world.happens_between({.kind = EventKind::collide}, a, c);
    world.happens({.kind = EventKind::monitors}, 0);
    source.config = {{"x", {true}}};
    world.load({source});
    world.load("");
    // The setting is told before the events of its run.
    const auto sorted = [](std::string text) {
        std::istringstream lines(text);
        std::set<std::string> all;
        for (std::string line; std::getline(lines, line);) {
            all.insert(line);
        }
        return all;
    };
    CHECK(sorted(world.said()) == sorted(counts));
    CHECK(world.errors() == "");
}
