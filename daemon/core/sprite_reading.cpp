// SPDX-License-Identifier: MIT
#include "daemon/core/sprite_reading.h"

#include "daemon/core/plugins.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

namespace hyrax {

SpriteReading::SpriteReading(
    Profile profile, std::span<const PluginEntry> plugins, ImageDecoder decode
)
    : profile_(std::move(profile)), decode_(std::move(decode)) {
    for (const PluginEntry& entry : plugins) {
        if (entry.state == PluginState::on) {
            plugins_.push_back(*entry.plugin);
        }
    }
}

void SpriteReading::run() noexcept {
    try {
        kinds_ = read();
    } catch (const std::exception& error) {
        kinds_ = failure(fmt::format("sprite sets cannot be read: {}", error.what()));
    }
}

std::vector<ReadKind> SpriteReading::read() const {
    std::vector<ReadKind> kinds = load_kinds(profile_, decode_);
    for (const Plugin& plugin : plugins_) {
        std::vector<ReadKind> more = load_plugin_kinds(plugin, decode_, room_beside(kinds));
        std::ranges::move(more, std::back_inserter(kinds));
    }
    return kinds;
}

}  // namespace hyrax
