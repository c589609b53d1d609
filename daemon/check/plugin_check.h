// SPDX-License-Identifier: MIT
// Tries a plugin: its manifest, its texts, and a minute among pets that fall, fly and are clicked.
#pragma once

#include "daemon/core/image.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hyrax {

/// What is known of a plugin after it was tried.
struct PluginReport {
    std::vector<std::string> errors;    ///< "folder/main.lua:3: ..."
    std::vector<std::string> warnings;  ///< The same.
    std::vector<std::string> said;      ///< Lines that it wrote into the log.
    std::size_t cases = 0;              ///< Of hyrax.test, that passed.
    bool good() const { return errors.empty(); }
};

/// Reads the folder and, if there is no mistake in it, runs it in this process with every
/// permission that it asks for: 60 s of its own time, and then the cases that it makes with
/// hyrax.test. The same plugin gives the same report.
/// `shipped` holds the sprite sets that come with the program, below config/sprites.
PluginReport check_plugin(
    const std::filesystem::path& folder,
    const std::filesystem::path& shipped,
    const ImageDecoder& decode
);

}  // namespace hyrax
