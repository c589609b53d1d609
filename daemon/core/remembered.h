// SPDX-License-Identifier: MIT
// What the user has chosen in the menu and what outlives the program: state.json. config.json is
// the user's own file and is never written.
#pragma once

#include "daemon/core/result.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

struct Remembered {
    bool hidden = false;
    std::optional<std::int64_t> hidden_until{};  ///< Seconds since 1970, UTC; none: until shown.
    std::optional<bool> quiet{};                 ///< Instead of the config's.
    std::optional<bool> click_through{};         ///< Instead of the config's.
    std::map<std::string, bool> monitors{};      ///< Instead of the config's, by identity().
    std::set<std::string> scripts_off{};         ///< Of those that the config names.
    std::map<std::string, bool> plugins{};       ///< Whether they run, instead of the config's.
    /// What plugins asked for and the user allowed.
    std::map<std::string, std::vector<std::string>> granted{};
    bool greeted = false;  ///< The first-run notice has been shown.
    bool operator==(const Remembered&) const = default;
};

/// `file` names the text in messages. Keys that are not there keep their defaults.
[[nodiscard]] Result<Remembered> parse_remembered(std::string_view text, std::string_view file);
std::string text_of(const Remembered& remembered);

/// A file that is not there is an empty memory, not an error.
[[nodiscard]] Result<Remembered> load_remembered(const std::filesystem::path& file);
/// Atomically; makes the folder.
[[nodiscard]] Result<void> save_remembered(
    const std::filesystem::path& file, const Remembered& remembered
);

}  // namespace hyrax
