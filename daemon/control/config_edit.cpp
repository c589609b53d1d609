// SPDX-License-Identifier: MIT
#include "daemon/control/config_edit.h"

#include "daemon/core/located_json.h"

#include <fmt/format.h>

namespace hyrax {
namespace {

using nlohmann::json;

// The first step of a pointer; the pointer keeps the rest.
std::string_view take_step(std::string_view& pointer) {
    pointer.remove_prefix(1);
    const std::string_view step = pointer.substr(0, pointer.find('/'));
    pointer.remove_prefix(step.size());
    return step;
}

// A member that brings the objects on its way: "physics": {"gravity": 300}
std::string new_member(std::string_view step, std::string_view rest, std::string_view value) {
    const std::string inner =
        rest.empty() ? std::string(value) : "{" + new_member(take_step(rest), rest, value) + "}";
    return json(step).dump() + ": " + inner;
}

std::string_view blanks_at(std::string_view text) {
    return text.substr(0, std::min(text.find_first_not_of(" \t"), text.size()));
}

// Where a first member is to stand in an object that has members, and what goes around it. A
// comment above the member that was first so far stays with that one, a comment beside the { with
// this.
struct Gap {
    std::size_t offset = 0;
    std::string before;
    std::string after;
};

Gap gap_in(std::string_view text, std::size_t inside, const LocatedJson& object) {
    const std::size_t end = std::min(text.find('\n', inside), text.size());
    const std::string_view line = text.substr(inside, end - inside);
    const std::string_view words = line.substr(blanks_at(line).size());
    const bool own_lines = object.children.front().key_at.line > object.at.line;
    if (!own_lines || !(words.empty() || words == "\r" || words.starts_with("//"))) {
        return {inside, "", ", "};
    }
    const std::size_t break_at = line.ends_with('\r') ? end - 1 : end;
    const std::string line_break(text.substr(break_at, end + 1 - break_at));
    // As far in as the member that was first so far.
    std::size_t start = 0;
    for (std::size_t at = 1; at < object.children.front().key_at.line; ++at) {
        start = text.find('\n', start) + 1;
    }
    return {break_at, line_break + std::string(blanks_at(text.substr(start))), ","};
}

std::string with_new_member(
    std::string_view text, const LocatedJson& object, const std::string& member
) {
    const std::size_t inside = static_cast<std::size_t>(object.source.data() - text.data()) + 1;
    const Gap gap = object.children.empty() ? Gap{inside, "", ""} : gap_in(text, inside, object);
    std::string changed(text);
    return changed.insert(gap.offset, gap.before + member + gap.after);
}

}  // namespace

Result<std::string> with_value(
    std::string_view text, std::string_view pointer, std::string_view value, std::string_view file
) {
    const Result<LocatedJson> root = parse_located_json(text, file);
    if (!root) {
        return std::unexpected(root.error());
    }
    const LocatedJson* place = &*root;
    std::string_view rest = pointer;
    while (!rest.empty()) {
        if (!place->value.is_object()) {
            return failure(fmt::format(
                "{}: {}: is no object, so that {} cannot be in it",
                place_in_file(file, place->at),
                pointer.substr(0, pointer.size() - rest.size()),
                rest
            ));
        }
        const std::string_view step = take_step(rest);
        const LocatedJson* const member = place->member(step);
        if (member == nullptr) {
            return with_new_member(text, *place, new_member(step, rest, value));
        }
        place = member;
    }
    std::string changed(text);
    const auto offset = static_cast<std::size_t>(place->source.data() - text.data());
    return changed.replace(offset, place->source.size(), value);
}

}  // namespace hyrax
