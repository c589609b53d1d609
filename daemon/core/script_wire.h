// SPDX-License-Identifier: MIT
// The language between the daemon and the script host's process: the plain data of script_port.h
// as bounded binary messages. A message is its length, a version, a type, and fields in the order
// of their structs, as this machine holds numbers: both ends are the same program.
//
// Decoding trusts nothing: lengths, counts, choices and flags are checked against the limits below,
// numbers of the world must be finite. Those in commands need not be: the engine refuses them.
// Whatever decodes encodes to the same bytes again.
#pragma once

#include "daemon/core/result.h"
#include "daemon/core/script_limits.h"
#include "daemon/core/script_port.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace hyrax::wire {

using Bytes = std::vector<std::byte>;

inline constexpr std::uint8_t version = 4;
/// Length, version and type.
inline constexpr std::size_t header_bytes = 6;
/// Of what follows the length. A message of more is broken.
inline constexpr std::size_t longest_to_host = std::size_t{16} << 20U;
inline constexpr std::size_t longest_to_daemon = std::size_t{16} << 20U;

inline constexpr std::size_t longest_name = 256;    ///< Of a kind, an owner, a tag [bytes].
inline constexpr std::size_t longest_line = 2'048;  ///< Of a log [bytes].
inline constexpr std::size_t longest_source = std::size_t{2} << 20U;
inline constexpr std::size_t most_scripts = 1'000;
inline constexpr std::size_t most_pets = 10'000;
inline constexpr std::size_t most_kinds = 10'000;
inline constexpr std::size_t most_monitors = 256;
inline constexpr std::size_t most_events = 4'096;
inline constexpr std::size_t most_commands = most_commands_in_all;
inline constexpr std::size_t most_lines = 2'000;
inline constexpr std::size_t most_animations = 1'000;
inline constexpr std::size_t most_windows = 1'000;
inline constexpr std::size_t most_told = 1'000;  ///< Pressed hotkeys, evaluations.
inline constexpr std::size_t longest_evaluation = std::size_t{64} << 10U;  ///< [bytes]
inline constexpr std::size_t longest_evaluated = std::size_t{8} << 10U;    ///< [bytes]
inline constexpr std::size_t most_permissions = 64;
inline constexpr std::size_t most_modules = 200;
inline constexpr std::size_t most_tests = 10'000;
inline constexpr std::size_t longest_text = std::size_t{1} << 20U;  ///< In a value [bytes].
inline constexpr std::size_t most_values = 500'000;  ///< In a message, those within values too.
inline constexpr std::size_t deepest_value = 32;     ///< Lists and tables within each other.

/// So many sources follow: ScriptHost::load(), after renew() if `anew`.
struct Load {
    ScriptLimits limits;
    std::uint32_t scripts = 0;
    bool anew = false;
};

struct Run {
    std::uint64_t number = 0;  ///< The answer carries it, too.
    ScriptWorld world;
    std::vector<ScriptEvent> events;
};

struct Answer {
    std::uint64_t number = 0;
    ScriptOutput output;
};

using ToHost = std::variant<Load, ScriptSource, Run>;

/// Each appends one message. What is above a limit is cut: texts at their end, lists behind the
/// last item that fits, values at the deepest place that may be. Too many values, or a message that
/// is too long, are not: whoever hears it refuses it.
void encode(Bytes& bytes, const Load& load);
void encode(Bytes& bytes, const ScriptSource& source);
void encode_run(
    Bytes& bytes,
    std::uint64_t number,
    const ScriptWorld& world,
    std::span<const ScriptEvent> events
);
void encode_answer(Bytes& bytes, std::uint64_t number, const ScriptOutput& output);

/// A whole message, as MessageStream gives it. The error says which field is wrong.
[[nodiscard]] Result<ToHost> decode_to_host(std::span<const std::byte> message);
[[nodiscard]] Result<Answer> decode_answer(std::span<const std::byte> message);

/// Cuts a stream of bytes into messages.
class MessageStream {
public:
    explicit MessageStream(std::size_t longest) : longest_(longest) {}

    void add(std::span<const std::byte> bytes);
    /// The next message, valid until add() or clear(); nothing while it is not complete.
    [[nodiscard]] Result<std::optional<std::span<const std::byte>>> next();
    void clear();

private:
    std::size_t longest_;
    Bytes bytes_;
    std::size_t done_ = 0;  // Bytes at the front that have been given out.
};

}  // namespace hyrax::wire
