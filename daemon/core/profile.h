// SPDX-License-Identifier: MIT
// The user's folder and the shipped one: where config, sprite sets and scripts are found.
#pragma once

#include "daemon/core/script_port.h"
#include "daemon/core/sprite_set.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// What the user has in `user` comes before what is shipped in `shipped`.
struct Profile {
    std::filesystem::path config;   ///< The file; usually user/config.json.
    std::filesystem::path user;     ///< Holds sprites/, scripts/ and plugins/.
    std::filesystem::path shipped;  ///< Holds config/config.json, config/sprites/ and scripts/.
    std::vector<std::filesystem::path>
        more_scripts;  ///< Files, and folders of plugins, that run whatever the config says.
    /// state.json, beside which store/ is, where scripts keep things; empty: nothing outlives the
    /// program.
    std::filesystem::path state{};
};

/// A sprite set that was looked for.
struct ReadKind {
    std::string name;
    Result<SpriteSet> set;
};

/// What most_sheet_pixels leaves for the sheets of others [pixels].
std::size_t room_beside(std::span<const ReadKind> kinds);

struct LoadedKinds {
    std::vector<SpriteSet> sets;        ///< Never empty; "hyrax" is always there.
    std::vector<std::string> problems;  ///< One line for each set that could not be read.
};

/// Reads every folder with a sprite.json in user/sprites and shipped/config/sprites, sorted by
/// name. Sets fail for which the sheets of "hyrax" and of those before leave no room.
std::vector<ReadKind> load_kinds(const Profile& profile, const ImageDecoder& decode);

/// What is used from now on: a set that could not be read stays as it was `before`, or is left out
/// if it is new, or if most_sheet_pixels leaves no room for what it was; where there is no "hyrax",
/// a placeholder takes its place.
LoadedKinds completed(
    std::vector<ReadKind> read, std::vector<SpriteSet> before, const Profile& profile
);

struct LoadedScripts {
    std::vector<ScriptSource> sources;
    std::vector<std::string> problems;
};

/// Reads the scripts that the patterns name: first in user/scripts, where * and ? match within one
/// folder level; a plain name that is not there is looked up in shipped/scripts. Files ending
/// in .d.lua describe the API and never run. `more_scripts` come last, under their file names. Each
/// script is at most 1 MiB. The user's own scripts have every permission.
LoadedScripts load_scripts(const Profile& profile, const std::vector<std::string>& patterns);

/// True when `name` fits: * is any run of characters but '/', ? is one of them.
bool matches(std::string_view pattern, std::string_view name);

/// Makes the user's folder with scripts/ and sprites/ and a copy of the shipped config.json, as far
/// as they are missing. Overwrites nothing but the schemas, which editors look for beside it.
[[nodiscard]] Result<void> prepare(const Profile& profile);

}  // namespace hyrax
