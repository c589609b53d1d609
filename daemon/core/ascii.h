// SPDX-License-Identifier: MIT
// Letters that are the same in every language.
#pragma once

namespace hyrax {

/// The small letter of A to Z; everything else as it is.
constexpr char lower_ascii(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace hyrax
