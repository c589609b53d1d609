// SPDX-License-Identifier: MIT
#include "daemon/core/sprite_reading.h"

#include "daemon/core/plugins.h"

#include <fmt/format.h>

#include <exception>
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

// A set that was read already stays read; the daemon goes on with what it had of the others.
void SpriteReading::run() noexcept {
    try {
        read();
    } catch (const std::exception& error) {
        kinds_.push_back(
            {"hyrax", failure(fmt::format("sprite sets cannot be read: {}", error.what()))}
        );
    }
}

void SpriteReading::read() {
    kinds_ = load_kinds(profile_, decode_);
    std::size_t room = most_sheet_pixels;
    for (const ReadKind& kind : kinds_) {
        room -= kind.set ? kind.set->sheet.pixels.size() : 0;
    }
    for (const Plugin& plugin : plugins_) {
        for (ReadKind& kind : load_plugin_kinds(plugin, decode_, room)) {
            room -= kind.set ? kind.set->sheet.pixels.size() : 0;
            kinds_.push_back(std::move(kind));
        }
    }
}

}  // namespace hyrax
