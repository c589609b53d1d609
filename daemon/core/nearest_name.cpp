// SPDX-License-Identifier: MIT
#include "daemon/core/nearest_name.h"

#include "daemon/core/ascii.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace hyrax {
namespace {

// Names of one letter are never near each other; names of two may differ in one.
std::size_t most_edits(std::string_view a, std::string_view b) {
    return (std::max(a.size(), b.size()) + 1) / 3;
}

// Optimal string alignment: Levenshtein's table, plus one look back for swapped neighbours.
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> above(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(above);
        above.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower_ascii(a[i - 1]) == lower_ascii(b[j - 1]);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0U : 1U)});
            if (i > 1 && j > 1 && lower_ascii(a[i - 1]) == lower_ascii(b[j - 2]) &&
                lower_ascii(a[i - 2]) == lower_ascii(b[j - 1])) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

}  // namespace

std::optional<std::string_view> nearest_name(
    std::string_view unknown, std::span<const std::string_view> known
) {
    std::optional<std::string_view> nearest;
    std::size_t least = 0;
    for (const std::string_view name : known) {
        const std::size_t limit = most_edits(unknown, name);
        const std::size_t lengths_apart =
            std::max(unknown.size(), name.size()) - std::min(unknown.size(), name.size());
        if (lengths_apart > limit) {  // also spares the table for absurdly long names
            continue;
        }
        const std::size_t distance = edits(unknown, name);
        if (distance <= limit && (!nearest || distance < least)) {
            nearest = name;
            least = distance;
        }
    }
    return nearest;
}

}  // namespace hyrax
