// SPDX-License-Identifier: MIT
// Reads all sprite sets that a daemon has use for. Shares nothing with the daemon, so that a thread
// of its own may do it: pictures may take long to decode.
#pragma once

#include "daemon/core/image.h"
#include "daemon/core/plugin.h"
#include "daemon/core/profile.h"

#include <span>
#include <utility>
#include <vector>

namespace hyrax {

struct PluginEntry;

class SpriteReading {
public:
    /// Of the profile and of those plugins that are on.
    SpriteReading(Profile profile, std::span<const PluginEntry> plugins, ImageDecoder decode);

    /// Reads the files, once, on any thread.
    void run() noexcept;
    /// What run() has read, once: the profile's sets by name, then those of plugins. Together their
    /// sheets have at most most_sheet_pixels; sets without room left fail.
    [[nodiscard]] Result<std::vector<ReadKind>> take() { return std::move(kinds_); }

private:
    std::vector<ReadKind> read() const;

    Profile profile_;
    std::vector<Plugin> plugins_;
    ImageDecoder decode_;
    Result<std::vector<ReadKind>> kinds_;
};

}  // namespace hyrax
