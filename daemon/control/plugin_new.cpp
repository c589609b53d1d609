// SPDX-License-Identifier: MIT
// The plugin that everybody begins with.
#include "daemon/control/plugin_folder.h"
#include "daemon/core/files.h"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <system_error>
#include <utility>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view manifest = R"json({
    "manifest": 1,
    "id": "@ID@",
    "version": "0.1.0",
    "api": "1.0",
    "name": "@ID@",
    "description": "A hyrax that jumps when it is clicked, and tells how high it has been.",
    "license": "MIT",
    "permissions": [],
    "config": [
        {
            "key": "jump",
            "type": "number",
            "default": 800,
            "min": 100,
            "max": 3000,
            "label": "How fast it jumps [px/s]"
        }
    ]
}
)json";

constexpr std::string_view entry =
    R"lua(-- A hyrax that jumps when it is clicked, and tells how high it has been.

local top                                    -- y of the highest point of this jump

local function appear()
  return hyrax.spawn{ tag = "jumper" }
end

hyrax.on("click", function(pet)
  if pet.tag ~= "jumper" then return end
  top = pet.y
  pet:fling(0, -hyrax.config.jump)
end)

hyrax.on("tick", function()
  local pet = hyrax.pets{ tag = "jumper" }[1]
  if top and pet then top = math.min(top, pet.y) end
end)

hyrax.on("land", function(pet)
  if pet.tag ~= "jumper" or not top then return end
  pet:say(("%d pixels!"):format(pet.y - top), 2)
  top = nil
end)

appear()

-- hyraxctl plugin check runs these; only then is there a hyrax.test.
if hyrax.test then
  hyrax.test.case("it appears and comes to the ground", function()
    local pet = appear()
    hyrax.wait_for(pet, "land", 10)
    hyrax.test.expect(pet.valid and pet.y > 0)
  end)
end
)lua";

constexpr std::string_view readme = R"md(# @ID@

A hyrax that jumps when it is clicked, and tells how high it has been.

* `plugin.json` says what this is, what it may do and what users can set.
* `main.lua` runs when hyrax starts, and again whenever it is saved.

```
hyraxctl plugin check .          what is wrong with it, if anything
hyraxctl plugin install .        puts a copy into your profile
```
)md";

std::string filled(std::string_view text, const std::string& id) {
    constexpr std::string_view blank = "@ID@";
    std::string result(text);
    for (std::size_t at = 0; (at = result.find(blank, at)) != std::string::npos;) {
        result.replace(at, blank.size(), id);
    }
    return result;
}

}  // namespace

Result<fs::path> new_plugin(const std::string& id, const fs::path& into) {
    if (!is_plugin_id(id)) {
        return failure(fmt::format(
            "\"{}\" is no id of a plugin: 3 to 40 small letters, digits and inner hyphens", id
        ));
    }
    const fs::path folder = into / id;
    std::error_code error;
    if (fs::exists(folder, error)) {
        return failure(utf8_from_path(folder) + ": is there already");
    }
    fs::create_directories(folder, error);
    if (error) {
        return failure(utf8_from_path(folder) + ": cannot be made: " + error.message());
    }
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> files{{
        {plugin_manifest_name, manifest},
        {"main.lua", entry},
        {"README.md", readme},
    }};
    for (const auto& [name, text] : files) {
        if (auto written = write_file_atomically(folder / name, filled(text, id)); !written) {
            return std::unexpected(written.error());
        }
    }
    return folder;
}

}  // namespace hyrax
