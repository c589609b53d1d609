// SPDX-License-Identifier: MIT
#include "daemon/control/verb.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace hyrax {
namespace {

constexpr std::array<std::string_view, 9> events{
    "spawn", "remove", "grab", "throw", "bounce", "land", "click", "collide", "monitors"
};

std::vector<Verb> joined() {
    std::vector<Verb> all;
    for (const std::span<const Verb> part :
         {pet_verbs(), daemon_verbs(), config_verbs(), script_verbs(), plugin_verbs()}) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

}  // namespace

std::span<const Verb> verbs() {
    static const std::vector<Verb> all = joined();
    return all;
}

const Verb* find_verb(std::string_view name) {
    const auto found = std::ranges::find(verbs(), name, &Verb::name);
    return found == verbs().end() ? nullptr : &*found;
}

std::vector<std::string_view> verb_names() {
    std::vector<std::string_view> names;
    for (const Verb& verb : verbs()) {
        names.push_back(verb.name);
    }
    return names;
}

std::span<const std::string_view> event_names() {
    return events;
}

std::string_view side_name(Side side) {
    constexpr std::array<std::string_view, 4> names{"left", "right", "top", "bottom"};
    return names[std::to_underlying(side)];
}

std::string_view button_name(Button button) {
    constexpr std::array<std::string_view, 3> names{"left", "right", "middle"};
    return names[std::to_underlying(button)];
}

std::string pet_text(PetId id) {
    return fmt::format("{}.{}", id.index, id.generation);
}

std::optional<PetId> pet_from_text(std::string_view text) {
    const char* const end = text.data() + text.size();
    PetId id;
    const auto index = std::from_chars(text.data(), end, id.index);
    if (index.ec != std::errc{} || index.ptr == end || *index.ptr != '.') {
        return std::nullopt;
    }
    const auto generation = std::from_chars(index.ptr + 1, end, id.generation);
    if (generation.ec != std::errc{} || generation.ptr != end) {
        return std::nullopt;
    }
    return id;
}

}  // namespace hyrax
