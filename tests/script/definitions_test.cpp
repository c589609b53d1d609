// SPDX-License-Identifier: MIT
// scripts/hyrax.d.lua describes exactly what exists.
#include "daemon/script/schedule.h"
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

using namespace hyrax;

namespace {

using Names = std::set<std::string>;

// "Class.name" for each documented field and function, "event.name" for each event.
Names documented() {
    std::ifstream file(HYRAX_SOURCE_DIR "/scripts/hyrax.d.lua");
    REQUIRE(file.good());
    const std::regex class_line(R"(---@class hyrax\.?(\w*).*)");
    const std::regex field_line(R"(---@field (?:readonly )?(\w+)\?? .*)");
    const std::regex function_line(R"(function (\w+)[.:](\w+)\(.*)");
    const std::regex event_line(R"re(---\| "(\w+)".*)re");
    Names names;
    std::string current;
    std::string line;
    std::smatch match;
    while (std::getline(file, line)) {
        if (std::regex_match(line, match, class_line)) {
            current = match[1].length() == 0 ? "hyrax" : match[1].str();
        } else if (std::regex_match(line, match, field_line)) {
            names.insert(current + "." + match[1].str());
        } else if (std::regex_match(line, match, function_line)) {
            names.insert(match[1].str() + "." + match[2].str());
        } else if (std::regex_match(line, match, event_line)) {
            names.insert("event." + match[1].str());
        }
    }
    return names;
}

// The names that an error message lists, when it knows nothing near.
void add_listed(Names& names, const std::string& prefix, const std::string& text) {
    const std::string error = errors_of(text);
    const std::regex listed(R"(\(there are: ([\w, ]+)\))");
    std::smatch match;
    REQUIRE_MESSAGE(std::regex_search(error, match, listed), error);
    std::istringstream words(match[1].str());
    for (std::string word; words >> word;) {
        std::erase(word, ',');
        names.insert(prefix + "." + word);
    }
}

Names existing() {
    FakeWorld world(ScriptLimits{.log_line = 4'096});
    world.load(R"(
        for name in pairs(hyrax) do print("hyrax." .. name) end
        for name in pairs(hyrax.log) do print("Log." .. name) end
        for name in pairs(hyrax.arena()) do print("Rect." .. name) end
        for name in pairs(hyrax.monitors()[1]) do
            if hyrax.arena()[name] == nil then print("Monitor." .. name) end
        end
        assert(type(hyrax.on("land", print).cancel) == "function") print("Subscription.cancel")
    )");
    CHECK(world.errors() == "");
    Names names;
    std::istringstream lines(world.said());
    for (std::string line; std::getline(lines, line);) {
        names.insert(line);
    }
    add_listed(names, "Pet", "print(hyrax.spawn().qqqqqqqqqq)");
    add_listed(names, "SpawnOptions", "hyrax.spawn{ qqqqqqqqqq = 1 }");
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
    CHECK(described.size() > 50);
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
