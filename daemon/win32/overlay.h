// SPDX-License-Identifier: MIT
// All panes together: carries out what panes.h plans.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/dirty.h"
#include "daemon/core/frame.h"
#include "daemon/core/panes.h"
#include "daemon/core/topmost.h"
#include "daemon/win32/pane_window.h"
#include "physics/ticks.h"

#include <memory>
#include <vector>

namespace hyrax::win32 {

class Overlay {
public:
    /// The handler gets the messages of every pane.
    explicit Overlay(MessageHandler& handler, PaneClicks clicks = PaneClicks::on_pixels);

    /// Shows the frame. Does nothing if it equals the one before and no pane is due to shrink.
    void present(const Frame& frame, std::span<const Monitor> monitors, Ticks now);
    /// When to call present_again(): a pane may shrink, or is not shown as it should. Else `never`.
    Ticks due() const;
    /// Shows once more what the latest present() has drawn; needs none of its images. False where
    /// that is not enough: only another present(), maybe of the same frame, shows all of it.
    [[nodiscard]] bool present_again(std::span<const Monitor> monitors, Ticks now);

    /// Draws everything anew with another one.
    void use_renderer(Renderer renderer);
    /// Leaves the panes out of screenshots and recordings, as far as the system obeys.
    void hide_from_capture(bool hidden);
    bool capture_refused() const { return capture_refused_; }

    bool visible() const;
    /// Where panes stand among all windows.
    void use_layer(Layer layer);
    /// What the mouse meets where a pet is seen.
    void use_clicks(PaneClicks clicks);
    /// Something that should be below lies above a pane.
    bool buried() const;
    void raise();
    const Frame& frame() const { return frame_; }

    /// Everything has to be drawn anew: screens have changed.
    void forget_pixels();

    bool owns(HWND window) const { return find(window) != nullptr; }
    bool has_pixel_at(HWND window, Point point) const;

    /// Keeps this pane's window on the screen, empty if need be, until release(). X11 ends a drag
    /// when the window that got the press goes away.
    void hold(HWND window) { held_ = window; }
    void release();

    const OverlayCounters& counters() const { return counters_; }

private:
    struct Changes {
        std::vector<Rect> changed;  ///< Places that look otherwise than before,
        std::vector<Rect> before;   ///< and those of all sprites of the frame before.
    };

    PaneWindow* find(HWND window) const;
    std::vector<Pane> planned(
        const Frame& frame, std::span<const Monitor> monitors, Ticks now, bool drawable
    ) const;
    PaneWindow* window_of(const Pane& pane, Ticks now);
    void show(const Pane& pane, const Frame& frame, const Changes& changes, Ticks now);
    void apply_capture(PaneWindow& window);
    void retire_windows();

    MessageHandler& handler_;
    PaneClicks clicks_;
    std::vector<std::unique_ptr<PaneWindow>> windows_;
    std::vector<Pane> plan_;
    Frame frame_;
    Renderer renderer_ = Renderer::blit;
    Layer layer_ = Layer::above_taskbar;
    HWND held_ = nullptr;
    Ticks window_retry_at_ = never;  ///< After the system gave no window.
    bool stale_ = false;             ///< A window must be presented, hidden or removed at once.
    bool undrawn_ = false;           ///< The next present() must draw even an equal frame.
    bool hidden_from_capture_ = false;
    bool capture_refused_ = false;
    bool wine_;
    OverlayCounters counters_;
};

}  // namespace hyrax::win32
