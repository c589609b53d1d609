// SPDX-License-Identifier: MIT
// What a client may ask of the daemon: one entry for each verb. Checking, help, completion and
// docs/control.md are made from these entries.
#pragma once

#include "daemon/control/save_file.h"
#include "daemon/core/daemon.h"
#include "daemon/core/event.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

enum class ParameterType : std::uint8_t {
    number,
    whole_number,
    text,  ///< At most 64 bytes, no control characters.
    pet,   ///< As list shows it: "3.1".
    key,   ///< Of config.json: "physics.gravity" or "/physics/gravity".
    json,  ///< Anything. On the command line: JSON, or else a text.
    events,
};

struct Range {
    double low = 0.0;
    double high = 0.0;
};

struct Parameter {
    std::string_view name;
    ParameterType type = ParameterType::text;
    std::string_view help;
    Range range = {};            ///< Of a number.
    std::string_view unit = {};  ///< Of a number.
    bool required = false;
    bool positional = false;  ///< On the command line without its name.
};

/// Why a request is not carried out.
struct Refusal {
    std::string code;  ///< A word for programs.
    std::string message;
};

using Outcome = std::expected<nlohmann::ordered_json, Refusal>;

/// What a verb works on.
struct VerbContext {
    Daemon& daemon;
    const SaveFile& save;
    std::size_t watchers = 0;
    std::optional<EventMask> watch{};  ///< Set by a verb whose client is to stay.
};

struct Verb {
    std::string_view name;
    std::string_view help;
    std::span<const Parameter> parameters;
    std::string_view example;  ///< Arguments of hyraxctl.
    /// `arguments` has been checked by the parameters.
    Outcome (*carry_out)(VerbContext& context, const nlohmann::ordered_json& arguments);
};

/// All of them, in the order of the help.
std::span<const Verb> verbs();
/// Null for an unknown name.
const Verb* find_verb(std::string_view name);
std::vector<std::string_view> verb_names();

// The parts of the table.
std::span<const Verb> pet_verbs();
std::span<const Verb> daemon_verbs();
std::span<const Verb> config_verbs();
std::span<const Verb> plugin_verbs();

/// The names of what can be watched, in the order of EventKind.
std::span<const std::string_view> event_names();
std::string_view side_name(Side side);
std::string_view button_name(Button button);

/// "3.1" for index 3, generation 1.
std::string pet_text(PetId id);
std::optional<PetId> pet_from_text(std::string_view text);

}  // namespace hyrax
