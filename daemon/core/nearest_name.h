// SPDX-License-Identifier: MIT
// "Did you mean ...?" for misspelt names.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace hyrax {

/// The known name that needs the fewest edits (a letter added, dropped or changed, two neighbours
/// swapped; capitals count as small letters), the first of several. Nothing where more than about
/// a third of the letters differ. The view is one of `known`.
std::optional<std::string_view> nearest_name(
    std::string_view unknown, std::span<const std::string_view> known
);

}  // namespace hyrax
