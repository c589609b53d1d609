// SPDX-License-Identifier: MIT
// scripts/hyrax.d.lua describes exactly what exists.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
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
Names documented() {
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
