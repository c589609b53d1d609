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
    script,  ///< A name of at most 256 bytes, no control characters.
    code,    ///< Any text.
    flag,    ///< Whether; on the command line it takes no value.
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

/// The code of a refusal: the script has an error, which the message is.
inline constexpr std::string_view script_error = "script_error";

/// Why a request is not carried out.
struct Refusal {
    std::string code;  ///< A word for programs.
    std::string message;
};

using Outcome = std::expected<nlohmann::ordered_json, Refusal>;

/// Makes the answer for a client that has waited for scripts.
using FinishVerb =
    Outcome (*)(const Daemon& daemon, const std::string& script, const Evaluated& evaluated);

/// Set by a verb whose client waits for scripts.
struct Waits {
    std::uint64_t evaluation = 0;
    std::string script;
    FinishVerb finish = nullptr;
};

/// A script that comes in several requests, as far as it has come.
struct Upload {
    std::string name;
    std::string text;
};

/// What a verb works on.
struct VerbContext {
    Daemon& daemon;
    const SaveFile& save;
    Upload& upload;
    std::size_t watchers = 0;
    std::optional<EventMask> watch{};  ///< Set by a verb whose client is to stay.
    std::optional<Waits> waits{};      ///< Then what carry_out() returns is not sent.
};

struct Verb {
    std::string_view name;
    std::string_view help;
    std::span<const Parameter> parameters;
    std::string_view example;  ///< Arguments of hyraxctl.
    /// `arguments` has been checked by the parameters.
    Outcome (*carry_out)(VerbContext& context, const nlohmann::ordered_json& arguments);
    std::string_view usage = {};  ///< Where the command line is not made from the parameters.
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
std::span<const Verb> script_verbs();
std::span<const Verb> plugin_verbs();

/// That `run` takes [bytes].
inline constexpr std::size_t longest_script = std::size_t{1} << 20U;

/// The names of what can be watched, in the order of EventKind.
std::span<const std::string_view> event_names();
std::string_view side_name(Side side);
std::string_view button_name(Button button);

/// Adds what a script or a plugin uses: pets, memory, units, errors, and what it hears of.
void add_use(nlohmann::ordered_json& item, std::size_t pets, const ScriptUse& use);

/// "3.1" for index 3, generation 1.
std::string pet_text(PetId id);
std::optional<PetId> pet_from_text(std::string_view text);

}  // namespace hyrax
