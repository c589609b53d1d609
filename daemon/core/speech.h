// SPDX-License-Identifier: MIT
// Speech bubbles: wrapped and drawn once, then placed above whoever speaks.
#pragma once

#include "daemon/core/engine.h"
#include "daemon/core/frame.h"
#include "daemon/core/image.h"
#include "physics/geometry.h"

#include <cstddef>
#include <functional>
#include <list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// Draws a line of UTF-8 in black: premultiplied, as wide as the text and as high as a line. Each
/// desktop brings its own (GDI, FreeType).
using TextPainter = std::function<Result<Image>(std::string_view line)>;

inline constexpr int bubble_text_width = 220;  ///< Lines are wrapped to this [px].
inline constexpr std::size_t bubble_lines = 3;

/// Breaks a text at blanks, and long words within, so that `width` says at most `most` of each
/// line; what is too much for `lines` ends in "...".
std::vector<std::string> wrapped(
    std::string_view text,
    const std::function<int(std::string_view)>& width,
    int most,
    std::size_t lines
);

/// A bubble around these lines, without its tail.
Image bubble_image(std::span<const Image> lines);

/// Where a bubble stands, and its tail.
struct BubblePlace {
    Point body;  ///< Top-left corners, virtual desktop [px].
    Point tail;
    bool below = false;  ///< There is no room above.
};

/// Over the middle of the box, within the screen.
BubblePlace place_bubble(const Rect& box, Size bubble, Size tail, const Rect& screen);

/// The bubbles of a scene.
class Speeches {
public:
    /// Without a painter nobody speaks.
    explicit Speeches(TextPainter paint);

    /// True if show() has something to do.
    bool concern(std::span<const PetId> speakers) const {
        return !speakers.empty() || !bubbles_.empty();
    }
    /// Adds the bubbles of these pets to the frame. Images stay until a frame without them has been
    /// presented and show() is called again.
    void show(Frame& frame, const Engine& engine, std::span<const PetId> speakers);

private:
    struct Bubble {
        PetId pet;
        std::string text;
        Image image;
        bool retired = false;
    };

    const Bubble* bubble_of(PetId pet, const std::string& text);

    TextPainter paint_;
    Image tail_down_;
    Image tail_up_;
    std::list<Bubble> bubbles_;
    bool told_ = false;  ///< That texts cannot be drawn.
};

}  // namespace hyrax
