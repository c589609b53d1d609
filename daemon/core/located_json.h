// SPDX-License-Identifier: MIT
// JSON with comments, read into values that know where in the file they stand. Only for the
// *_json.cpp files: nlohmann and its exceptions stay there.
#pragma once

#include "daemon/core/result.h"
#include "daemon/core/text_cursor.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// "config.json:12:18", the form that editors jump to.
std::string place_in_file(std::string_view file, TextPosition at);

/// A value with its place. An object's members and an array's items are its children.
struct LocatedJson {
    std::string key;      ///< Of a member, with its escapes resolved; else empty.
    TextPosition key_at;  ///< Where the key's opening quote is; like `at` where there is no key.
    TextPosition at;      ///< Where the value begins.
    std::string_view source;  ///< As the file writes it; a view into the parsed text.
    nlohmann::json value;     ///< The scalar; an *empty* object or array where there are children.
    std::vector<LocatedJson> children;  ///< In the file's order; no key twice.

    /// The member of this name, or null.
    const LocatedJson* member(std::string_view name) const;
};

/// Deeper files are refused.
inline constexpr std::size_t max_json_depth = 64;

/// Parses UTF-8 text. Comments are allowed: from // to the end of a line, and from /* to */.
/// Refused in plain words that begin with `file`:line:column: wrong syntax, text after the value,
/// a key that comes twice in its object, nesting beyond the limit, bytes that are not UTF-8.
/// The result views into `text`.
[[nodiscard]] Result<LocatedJson> parse_located_json(std::string_view text, std::string_view file);

}  // namespace hyrax
