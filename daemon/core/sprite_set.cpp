// SPDX-License-Identifier: MIT
#include "daemon/core/sprite_set.h"

#include "daemon/core/check.h"

#include <array>
#include <utility>

namespace hyrax {
namespace {

// Ellipses of one colour, drawn over each other.
struct Blob {
    double x;
    double y;
    double radius_x;
    double radius_y;
    Pixel colour;  // opaque
};

constexpr int placeholder_side = 96;
constexpr Rect placeholder_box{8, 12, 80, 80};

constexpr Pixel outline = 0xFF3A2C22;
constexpr Pixel fur = 0xFF8A7159;
constexpr Pixel pale = 0xFFEADCC0;
constexpr Pixel white = 0xFFFFFFFF;
constexpr Pixel black = 0xFF1C1817;

constexpr std::array placeholder_blobs{
    // Ears.
    Blob{24, 22, 9, 9, outline},
    Blob{72, 22, 9, 9, outline},
    Blob{24, 22, 6, 6, pale},
    Blob{72, 22, 6, 6, pale},
    // Body and belly.
    Blob{48, 52, 40, 40, outline},
    Blob{48, 52, 37.5, 37.5, fur},
    Blob{48, 68, 23, 18, pale},
    // Eyes, with a spark of light, and nose.
    Blob{35, 40, 7.5, 8.5, white},
    Blob{61, 40, 7.5, 8.5, white},
    Blob{37, 41, 4, 5, black},
    Blob{63, 41, 4, 5, black},
    Blob{38.5, 39, 1.4, 1.4, white},
    Blob{64.5, 39, 1.4, 1.4, white},
    Blob{49, 52, 5.5, 4, black},
};

// Covered share of a pixel in 16ths: a 4 by 4 grid of samples. No share but 0 is fainter than the
// alpha that loaded sheets are cleared at.
unsigned coverage(const Blob& blob, int x, int y) {
    constexpr int grid = 4;
    unsigned covered = 0;
    for (int i = 0; i < grid * grid; ++i) {
        const double dx = (x + (i % grid + 0.5) / grid - blob.x) / blob.radius_x;
        const double dy = (y + (i / grid + 0.5) / grid - blob.y) / blob.radius_y;
        covered += dx * dx + dy * dy <= 1.0 ? 1 : 0;
    }
    return covered;
}

// Source-over of an opaque colour. Each channel is the same blend, rounded down, so none of the
// colours can exceed alpha.
Pixel blended(Pixel under, Pixel colour, unsigned covered) {
    Pixel result = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        const unsigned below = under >> shift & 0xFFU;
        const unsigned above = colour >> shift & 0xFFU;
        result |= (below * (16 - covered) + above * covered) / 16 << shift;
    }
    return result;
}

}  // namespace

Ticks Animation::duration() const {
    Ticks sum = 0;
    for (const AnimationFrame& frame : frames) {
        sum += frame.duration;
    }
    return sum;
}

Shown shown_at(const Animation& animation, Ticks elapsed) {
    const Ticks total = animation.duration();
    HYRAX_CHECK(total > 0 && elapsed >= 0);
    const std::vector<AnimationFrame>& frames = animation.frames;
    if (total <= 0 || (!animation.loop && elapsed >= total)) {
        return {frames.empty() ? 0 : frames.back().cell, never};
    }
    Ticks until = elapsed - elapsed % total;
    std::size_t index = 0;
    for (; until + frames[index].duration <= elapsed; ++index) {
        until += frames[index].duration;
    }
    // Frames that show the same cell again are no reason to wake up.
    const int cell = frames[index].cell;
    for (std::size_t step = 0; step < frames.size(); ++step, ++index) {
        if (index == frames.size()) {
            if (!animation.loop) {
                break;
            }
            index = 0;
        }
        if (frames[index].cell != cell) {
            return {cell, until};
        }
        until += frames[index].duration;
    }
    return {cell, never};
}

Rect SpriteSet::cell_rect(int index) const {
    const int columns = sheet.size.width / cell.width;
    return {index % columns * cell.width, index / columns * cell.height, cell.width, cell.height};
}

const Animation& SpriteSet::animation(std::string_view animation_name) const {
    const auto found = animations.find(animation_name);
    return found != animations.end() ? found->second : animations.at("idle");
}

SpriteSet placeholder_sprite_set(std::string name) {
    SpriteSet set;
    set.name = std::move(name);
    set.cell = {placeholder_side, placeholder_side};
    set.box = placeholder_box;
    set.sheet = Image(set.cell);
    for (int y = 0; y < placeholder_side; ++y) {
        for (int x = 0; x < placeholder_side; ++x) {
            for (const Blob& blob : placeholder_blobs) {
                Pixel& pixel = set.sheet.at(x, y);
                pixel = blended(pixel, blob.colour, coverage(blob, x, y));
            }
        }
    }
    for (const char* each : {"idle", "fall", "held", "land", "rest", "walk"}) {
        set.animations[each] = {.frames = {{.cell = 0, .duration = ticks_per_second}}};
    }
    return set;
}

}  // namespace hyrax
