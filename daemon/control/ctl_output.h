// SPDX-License-Identifier: MIT
// Answers as people read them: tables for lists, a line each for the rest.
#pragma once

#include <string>
#include <string_view>

namespace hyrax {

struct ShownAnswer {
    std::string text;
    std::string refusal;  ///< The code of it; empty when all is well.
};

/// What an answer of the daemon looks like on a terminal.
ShownAnswer shown_answer(std::string_view answer);
/// An event, on one line.
std::string shown_event(std::string_view event);

}  // namespace hyrax
