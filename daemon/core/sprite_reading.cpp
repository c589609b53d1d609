// SPDX-License-Identifier: MIT
#include "daemon/core/sprite_reading.h"

#include "daemon/core/plugins.h"

#include <fmt/format.h>

#include <exception>
#include <utility>

namespace hyrax {
namespace {

std::size_t pixels_of(const ReadKind& kind) {
    return kind.set ? kind.set->sheet.pixels.size() : 0;
}

}  // namespace

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
    std::size_t room = most_sheet_pixels;
    for (const ReadKind& kind : kinds) {
        room -= pixels_of(kind);
    }
    for (const Plugin& plugin : plugins_) {
        for (ReadKind& kind : load_plugin_kinds(plugin, decode_, room)) {
            room -= pixels_of(kind);
            kinds.push_back(std::move(kind));
        }
    }
    return kinds;
}

}  // namespace hyrax
