// SPDX-License-Identifier: MIT
// One window of the overlay: transparent, always on top, never active, and open to the mouse only
// where it has visible pixels.
#pragma once

#include "daemon/core/frame.h"
#include "daemon/core/panes.h"
#include "daemon/core/result.h"
#include "daemon/core/statistics.h"
#include "daemon/core/topmost.h"
#include "daemon/win32/message_window.h"
#include "daemon/win32/surface.h"
#include "physics/geometry.h"
#include "physics/ticks.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace hyrax::win32 {

/// How long nothing is tried that the system has refused.
inline constexpr Ticks retry_after = 5 * ticks_per_second;

/// What a pane is to show.
struct PanePicture {
    const Pane& pane;  ///< Its area is the part of the frame.
    const Frame& frame;
    std::span<const Rect> dirty;
    std::span<const Rect> before;  ///< Where the sprites of the frame before stand.
    Renderer renderer = Renderer::blit;
    int outline_rows = 1;  ///< Of coarse_outline.h.
};

/// What a click on a visible pixel does.
enum class PaneClicks : std::uint8_t { on_pixels, pass_through };

class PaneWindow {
public:
    [[nodiscard]] static Result<std::unique_ptr<PaneWindow>> create(
        std::size_t slot, PaneClicks clicks, MessageHandler& handler
    );

    PaneWindow(const PaneWindow&) = delete;
    PaneWindow& operator=(const PaneWindow&) = delete;
    ~PaneWindow();

    /// Shows the panes of this slot, one after the other.
    std::size_t slot() const { return slot_; }
    HWND window() const { return window_.raw(); }
    bool visible() const { return visible_; }

    /// Shows the picture. If the window already shows its area, only the dirty rectangles are drawn
    /// and presented. When the system refuses, nothing is tried for 5 s.
    void show(const PanePicture& picture, Ticks now, OverlayCounters& counters);
    /// Presents the pixels that show() has drawn, or those of them in a smaller area, unless they
    /// are there. False if there are none.
    bool show_again(const Rect& area, Ticks now, OverlayCounters& counters);
    /// When to try again what the system has refused; else `never`.
    Ticks retry_at() const { return retry_at_; }
    void hide();
    /// Stays visible for the system, but without a pixel.
    void show_nothing(OverlayCounters& counters);
    /// Leaves the window out of what programs capture of the screen. False: the system refuses.
    bool exclude_from_capture(bool exclude);
    /// Instead of those it was created with.
    void use_clicks(PaneClicks clicks);
    /// Among all windows where the layer has it, now or again.
    void take_place(Layer layer);
    /// No longer topmost, or, if it should be above taskbars, below one that lies where the pane
    /// is. Whoever is to be at the bottom never is.
    bool buried() const;
    /// The next show() draws everything: the system may have lost what it had.
    void forget_pixels() { complete_ = false; }

    /// Whether the window shows something there (virtual desktop).
    bool has_pixel_at(Point point) const;

private:
    explicit PaneWindow(std::size_t slot) : slot_(slot) {}

    void appear();
    void stand_in_layer(UINT more);
    bool below_taskbar() const;
    void draw(
        const PanePicture& picture, std::span<const Rect> parts, std::span<const Rect> before
    );
    bool present(const Rect* dirty, OverlayCounters& counters);
    void present_all(Ticks now, OverlayCounters& counters);
    void refused(Ticks now, const std::string& why);
    void renew_layer();

    std::size_t slot_;
    Surface surface_;
    Window window_;
    Layer layer_ = Layer::above_taskbar;
    Rect area_;
    int outline_rows_ = 1;
    Ticks retry_at_ = never;
    bool visible_ = false;
    bool complete_ = false;  ///< The system shows all of area_ as the surface has it.
    bool outdated_ = false;  ///< The surface lacks frames that came while nothing was tried.
    bool blank_ = false;     ///< The system shows no pixel of area_.
};

}  // namespace hyrax::win32
