// SPDX-License-Identifier: MIT
// Changes one value in the text of a config.json and leaves all else as its writer made it:
// comments, order, indentation, keys that nobody knows.
#pragma once

#include "daemon/core/result.h"

#include <string>
#include <string_view>

namespace hyrax {

/// The text with `value` (JSON text) at `pointer` ("/physics/gravity"), whose steps name members of
/// objects. Objects that are missing on the way are added. Fails, naming `file` and the place, on
/// text that is no JSON, and where a step would lead into something that is no object. Whether the
/// value fits there is not checked.
[[nodiscard]] Result<std::string> with_value(
    std::string_view text, std::string_view pointer, std::string_view value, std::string_view file
);

}  // namespace hyrax
