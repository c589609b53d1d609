// SPDX-License-Identifier: MIT
// Text that came out of a script, made fit for logs and messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hyrax::script {

/// True for UTF-8 without control characters.
bool is_plain_text(std::string_view text);

bool is_utf8(std::string_view text);

/// Each run of control characters becomes one space, each byte that is not UTF-8 a question mark;
/// cut at a character after at most `longest` bytes, where "..." tells of the cut.
std::string clean_text(std::string_view text, std::size_t longest);

}  // namespace hyrax::script
