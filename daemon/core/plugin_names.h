// SPDX-License-Identifier: MIT
// What the names, versions and texts of a manifest look like. ASCII throughout.
#pragma once

#include <cstddef>
#include <string_view>

namespace hyrax {

/// The part before the next `mark`, which is taken away from the text with the mark.
std::string_view take_part(std::string_view& text, char mark);

/// Digits, no zero before others, small enough for an int.
bool is_count(std::string_view text);
/// As https://semver.org, version 2.0.0, has it.
bool is_version(std::string_view text);
/// 1 to `longest` bytes without control characters.
bool is_line(std::string_view text, std::size_t longest);
/// 1 to 64 small letters, digits and _, a letter first; "enabled" is not the plugin's.
bool is_setting_key(std::string_view text);
/// 1 to 23 small letters, digits, - and _: with an id and a slash no longer than a kind may be.
bool is_kind_name(std::string_view text);

}  // namespace hyrax
