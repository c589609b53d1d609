// SPDX-License-Identifier: MIT
// One window of the overlay: transparent, always on top, never active, and open to the mouse only
// where it has visible pixels.
#pragma once

#include "daemon/core/frame.h"
#include "daemon/core/result.h"
#include "daemon/win32/message_window.h"
#include "daemon/win32/surface.h"
#include "physics/geometry.h"

#include <cstdint>
#include <memory>
#include <span>

namespace hyrax::win32 {

/// What was asked of the system since the start.
struct OverlayCounters {
    std::uint64_t frames = 0;    ///< Frames that differed from the one before.
    std::uint64_t presents = 0;  ///< Calls of UpdateLayeredWindowIndirect.
    std::uint64_t bytes = 0;     ///< In the rectangles that these calls presented.
    std::uint64_t resizes = 0;   ///< Of panes: the system makes a new surface for each.
    std::uint64_t failures = 0;  ///< Of presents.
};

/// What a click on a visible pixel does.
enum class PaneClicks : std::uint8_t { on_pixels, pass_through };

class PaneWindow {
public:
    /// `monitor` bounds the window for its whole life.
    [[nodiscard]] static Result<std::unique_ptr<PaneWindow>> create(
        const Rect& monitor, PaneClicks clicks, MessageHandler& handler
    );

    PaneWindow(const PaneWindow&) = delete;
    PaneWindow& operator=(const PaneWindow&) = delete;
    ~PaneWindow();

    const Rect& monitor() const { return monitor_; }
    HWND window() const { return window_.raw(); }
    bool visible() const { return visible_; }

    /// Shows the part of the frame that lies in `area` (within the monitor). If the window already
    /// shows this area, only the `dirty` rectangles are drawn and presented.
    void show(
        const Rect& area, const Frame& frame, std::span<const Rect> dirty, OverlayCounters& counters
    );
    /// Presents the pixels that show() has drawn, or those of them in a smaller area. False if
    /// there are none.
    bool show_again(const Rect& area, OverlayCounters& counters);
    void hide();
    /// Stays visible for the system, but without a pixel.
    void show_nothing(OverlayCounters& counters);
    /// The next show() draws everything: the system may have lost what it had.
    void forget_pixels() { complete_ = false; }

    /// Whether the window shows something there (virtual desktop).
    bool has_pixel_at(Point point) const;

private:
    explicit PaneWindow(const Rect& monitor) : monitor_(monitor) {}

    bool present(const Rect* dirty, OverlayCounters& counters);
    void renew_layer();

    Rect monitor_;
    Surface surface_;
    Window window_;
    Rect area_;
    bool visible_ = false;
    bool complete_ = false;  ///< The system shows all of area_ as the surface has it.
    bool blank_ = false;     ///< The system shows no pixel of area_.
};

}  // namespace hyrax::win32
