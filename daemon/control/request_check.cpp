// SPDX-License-Identifier: MIT
#include "daemon/control/request_check.h"

#include "daemon/control/config_key.h"
#include "daemon/core/located_json.h"
#include "daemon/core/nearest_name.h"
#include "daemon/core/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hyrax {
namespace {

using json = nlohmann::ordered_json;
using Checked = std::expected<void, Refusal>;

constexpr std::size_t longest_text = 64;
constexpr std::size_t longest_script_name = 256;

std::unexpected<Refusal> refused(std::string message) {
    return std::unexpected(Refusal{"bad_request", std::move(message)});
}

std::size_t depth_of(const LocatedJson& value) {
    std::size_t deepest = 0;
    for (const LocatedJson& child : value.children) {
        deepest = std::max(deepest, depth_of(child));
    }
    return deepest + (value.value.is_structured() ? 1 : 0);
}

bool is_number_in(const json& value, Range range) {
    return value.is_number() && value.get<double>() >= range.low &&
           value.get<double>() <= range.high;
}

bool is_text(const json& value, std::size_t longest) {
    const auto* const text = value.get_ptr<const json::string_t*>();
    return text != nullptr && !text->empty() && text->size() <= longest &&
           std::ranges::all_of(*text, [](char c) { return static_cast<unsigned char>(c) >= 0x20; });
}

bool fits(const Parameter& parameter, const json& value) {
    const auto* const text = value.get_ptr<const json::string_t*>();
    switch (parameter.type) {
        case ParameterType::number:
            return is_number_in(value, parameter.range);
        case ParameterType::whole_number:
            return is_number_in(value, parameter.range) &&
                   value.get<double>() == std::floor(value.get<double>());
        case ParameterType::text:
            return is_text(value, longest_text);
        case ParameterType::script:
            return is_text(value, longest_script_name);
        case ParameterType::code:
            return text != nullptr;
        case ParameterType::flag:
            return value.is_boolean();
        case ParameterType::pet:
            return text != nullptr && pet_from_text(*text).has_value();
        case ParameterType::key:
            return text != nullptr;
        case ParameterType::json:
            return true;
        case ParameterType::events:
            return value.is_array() &&
                   std::ranges::all_of(value, [](const json& item) { return item.is_string(); });
    }
    std::unreachable();
}

std::vector<std::string_view> views(const std::vector<std::string>& names) {
    return {names.begin(), names.end()};
}

// Names that are not among those there are: of settings and of events.
Checked check_names(const Parameter& parameter, const json& value) {
    if (parameter.type == ParameterType::key) {
        const std::vector<std::string> keys = settable_keys();
        const std::string key = dotted(pointer_of(value.get<std::string>()));
        if (!key.starts_with(plugin_prefix) && std::ranges::count(keys, key) == 0) {
            return refused(fmt::format("{}: {}", parameter.name, unknown_name(key, views(keys))));
        }
    }
    if (parameter.type == ParameterType::events) {
        for (const json& item : value) {
            const auto name = item.get<std::string>();
            if (std::ranges::count(event_names(), name) == 0) {
                return refused(
                    fmt::format("{}: {}", parameter.name, unknown_name(name, event_names()))
                );
            }
        }
    }
    return {};
}

Checked check_value(const Parameter& parameter, const json& value) {
    if (!fits(parameter, value)) {
        constexpr std::size_t longest = 60;
        return refused(fmt::format(
            "{}: must be {}, got {}",
            parameter.name,
            expectation(parameter),
            shortened(value.dump(), longest)
        ));
    }
    return check_names(parameter, value);
}

}  // namespace

std::string plain_number(double value) {
    return value == std::floor(value) ? fmt::format("{:.0f}", value) : fmt::format("{}", value);
}

std::string expectation(const Parameter& parameter) {
    const std::string bounds = fmt::format(
        "from {} to {}", plain_number(parameter.range.low), plain_number(parameter.range.high)
    );
    switch (parameter.type) {
        case ParameterType::number:
            return "a number " + bounds;
        case ParameterType::whole_number:
            return "a whole number " + bounds;
        case ParameterType::text:
            return fmt::format("a text of 1 to {} bytes", longest_text);
        case ParameterType::script:
            return "a script's name, as scripts shows it";
        case ParameterType::code:
            return "a text";
        case ParameterType::flag:
            return "true or false";
        case ParameterType::pet:
            return "a pet's id such as \"3.1\", as list shows it";
        case ParameterType::key:
            return "a setting such as \"physics.gravity\" or \"plugins.catch.balls\", as config "
                   "get shows it";
        case ParameterType::json:
            return "a value";
        case ParameterType::events:
            return fmt::format("a list of these names: {}", fmt::join(event_names(), ", "));
    }
    std::unreachable();
}

std::string unknown_name(std::string_view name, std::span<const std::string_view> known) {
    constexpr std::size_t longest = 60;
    const std::string quoted = json(shortened(name, longest)).dump();
    const std::optional<std::string_view> nearest = nearest_name(name, known);
    return nearest ? fmt::format("there is no {}; did you mean \"{}\"?", quoted, *nearest)
                   : fmt::format("there is no {}; known: {}", quoted, fmt::join(known, ", "));
}

std::expected<void, Refusal> check_arguments(const Verb& verb, const json& arguments) {
    std::vector<std::string_view> known;
    for (const Parameter& parameter : verb.parameters) {
        known.push_back(parameter.name);
        if (parameter.required && !arguments.contains(parameter.name)) {
            return refused(fmt::format("{}: is missing: {}", parameter.name, expectation(parameter))
            );
        }
    }
    for (const auto& [name, value] : arguments.items()) {
        const auto parameter = std::ranges::find(verb.parameters, name, &Parameter::name);
        if (parameter == verb.parameters.end()) {
            return refused(
                known.empty()
                    ? fmt::format("{} takes no arguments, got {}", verb.name, json(name).dump())
                    : fmt::format("{}: {}", verb.name, unknown_name(name, known))
            );
        }
        if (Checked checked = check_value(*parameter, value); !checked) {
            return checked;
        }
    }
    return {};
}

std::expected<CheckedRequest, Refusal> check_request(std::string_view text) {
    // Strict about what nlohmann would let pass: names that come twice, bytes that are no UTF-8.
    const Result<LocatedJson> located = parse_located_json(text, "request");
    if (!located) {
        return std::unexpected(Refusal{"bad_json", located.error().message});
    }
    if (depth_of(*located) > max_request_depth) {
        return std::unexpected(
            Refusal{"bad_json", fmt::format("request: nested more than {} deep", max_request_depth)}
        );
    }
    json request = json::parse(text, nullptr, true, true);
    if (!request.is_object()) {
        return refused(R"(a request must be an object such as {"do": "status"})");
    }
    const auto name = request.find("do");
    if (name == request.end() || !name->is_string()) {
        return refused(R"(do: must be the name of a verb, as in {"do": "status"})");
    }
    const Verb* const verb = find_verb(name->get_ref<const std::string&>());
    if (verb == nullptr) {
        return std::unexpected(
            Refusal{"unknown_verb", "do: " + unknown_name(name->get<std::string>(), verb_names())}
        );
    }
    request.erase(name);
    if (Checked checked = check_arguments(*verb, request); !checked) {
        return std::unexpected(checked.error());
    }
    return CheckedRequest{verb, std::move(request)};
}

}  // namespace hyrax
