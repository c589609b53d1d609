// SPDX-License-Identifier: MIT
#include "daemon/win32/overlay.h"

#include "daemon/core/coarse_outline.h"
#include "daemon/win32/process.h"
#include "daemon/win32/text.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace hyrax::win32 {

namespace {

/// Windows copies what a call says is dirty. Wine 8 copies the whole window in every call, too:
/// at 1920x1080 that takes 2.7 ms, and 9.7 ms with all of it dirty. A call that names no dirty
/// part saves it one of its copies.
PresentCost cost_on(const Rect& pane, std::size_t panes, bool wine) {
    if (!wine) {
        return {.most_calls = calls_for_each_of(panes)};
    }
    return {.call_px = pane.area() * 2 / 5, .whole_percent = 75};
}

/// Each present takes Wine some 26 round trips, and X draws anew what lies below. Of the prices
/// tried this was the cheapest for two, for ten and for a hundred pets.
constexpr long long wine_window_price = 80'000;

/// Where panes may lie. Wine 8 takes a window that fills a screen for that of a full-screen program
/// and hands it to the window manager, or waits for one: there the top row of pixels stays free.
std::vector<Monitor> room_for_panes(
    std::span<const Monitor> monitors, std::span<const Rect> kept_free, bool wine
) {
    std::vector<Monitor> room;
    for (const Monitor& monitor : monitors) {
        if (std::ranges::find(kept_free, monitor.bounds) == kept_free.end()) {
            room.push_back(monitor);
            room.back().bounds.y += wine ? 1 : 0;
            room.back().bounds.height -= wine ? 1 : 0;
        }
    }
    return room;
}

}  // namespace

Overlay::Overlay(MessageHandler& handler, PaneClicks clicks)
    : handler_(handler), clicks_(clicks), wine_(runs_under_wine()) {}

void Overlay::present(const Frame& frame, std::span<const Monitor> monitors, Ticks now) {
    if (frame == frame_ && !undrawn_ && now < due()) {
        return;
    }
    undrawn_ = false;
    stale_ = false;
    ++counters_.frames;
    std::vector<Pane> next = planned(frame, monitors, now, true);
    sort_for_showing(next, plan_);
    plan_ = std::move(next);
    const Changes changes{changed_places(frame_, frame), places_of(frame_)};
    for (const Pane& pane : plan_) {
        show(pane, frame, changes, now);
    }
    frame_ = frame;
    retire_windows();
}

std::vector<Pane> Overlay::planned(
    const Frame& frame, std::span<const Monitor> monitors, Ticks now, bool drawable
) const {
    const std::vector<Monitor> room = room_for_panes(monitors, frame.kept_free, wine_);
    const std::vector<Rect> places = places_of(frame);
    const PaneScene scene{
        .monitors = room,
        .sprites = places,
        .drawable = drawable,
        .window_px = wine_ ? wine_window_price : window_price,
    };
    return plan_panes(scene, plan_, now);
}

void Overlay::show(const Pane& pane, const Frame& frame, const Changes& changes, Ticks now) {
    PaneWindow* const window = window_of(pane, now);
    if (window == nullptr) {
        return;
    }
    const PresentCost cost = cost_on(pane.area, plan_.size(), wine_);
    const std::vector<Rect> dirty = dirty_clusters(changes.changed, pane.area, cost);
    const int rows = wine_ ? outline_rows(frame.sprites.size()) : 1;
    const bool appears = !window->visible();
    window->show({pane, frame, dirty, changes.before, renderer_, rows}, now, counters_);
    if (appears && hidden_from_capture_) {
        apply_capture(*window);
    }
}

Ticks Overlay::due() const {
    if (stale_) {
        return 0;
    }
    Ticks due = next_plan(plan_);
    if (undrawn_) {
        return due;  // Only another frame helps, which was asked for.
    }
    due = std::min(due, window_retry_at_);
    for (const auto& window : windows_) {
        due = std::min(due, window->retry_at());
    }
    return due;
}

bool Overlay::present_again(std::span<const Monitor> monitors, Ticks now) {
    stale_ = false;
    plan_ = planned(frame_, monitors, now, false);
    for (const Pane& pane : plan_) {
        if (PaneWindow* const window = window_of(pane, now)) {
            undrawn_ = !window->show_again(pane.area, now, counters_) || undrawn_;
        }
    }
    retire_windows();
    return !undrawn_;
}

/// Windows without a pane are hidden until another pane needs one; without any pet, they go.
void Overlay::retire_windows() {
    std::erase_if(windows_, [&](const std::unique_ptr<PaneWindow>& window) {
        if (std::ranges::find(plan_, window->slot(), &Pane::slot) != plan_.end()) {
            return false;
        }
        if (window->window() == held_) {
            window->show_nothing(counters_);
            return false;
        }
        window->hide();
        return frame_.sprites.empty();
    });
}

PaneWindow* Overlay::find(HWND window) const {
    const auto found =
        std::ranges::find(windows_, window, [](const auto& pane) { return pane->window(); });
    return found != windows_.end() ? found->get() : nullptr;
}

/// None while the system gives none.
PaneWindow* Overlay::window_of(const Pane& pane, Ticks now) {
    const auto found =
        std::ranges::find(windows_, pane.slot, [](const auto& window) { return window->slot(); });
    if (found != windows_.end()) {
        return found->get();
    }
    if (window_retry_at_ != never && now < window_retry_at_) {
        return nullptr;
    }
    Result<std::unique_ptr<PaneWindow>> created = PaneWindow::create(pane.slot, clicks_, handler_);
    if (!created) {
        if (std::exchange(window_retry_at_, now + retry_after) == never) {
            spdlog::error("{}; tried again every 5 s", created.error().message);
        }
        return nullptr;
    }
    window_retry_at_ = never;
    (*created)->take_place(layer_);
    windows_.push_back(std::move(*created));
    return windows_.back().get();
}

void Overlay::use_renderer(Renderer renderer) {
    if (std::exchange(renderer_, renderer) == renderer) {
        return;
    }
    undrawn_ = true;
    for (const auto& window : windows_) {
        window->forget_pixels();
    }
}

/// Said again whenever a window appears: some systems forget it while the window is hidden.
void Overlay::apply_capture(PaneWindow& window) {
    const bool done = window.exclude_from_capture(hidden_from_capture_);
    if (!done && hidden_from_capture_ && !capture_refused_) {
        spdlog::warn("{}", system_error("captures of the screen show the pets").message);
    }
    capture_refused_ = hidden_from_capture_ && !done;
}

void Overlay::hide_from_capture(bool hidden) {
    if (hidden == hidden_from_capture_) {
        return;
    }
    hidden_from_capture_ = hidden;
    capture_refused_ = false;
    for (const auto& window : windows_) {
        apply_capture(*window);
    }
}

bool Overlay::visible() const {
    return std::ranges::any_of(windows_, [](const auto& window) { return window->visible(); });
}

void Overlay::use_layer(Layer layer) {
    if (std::exchange(layer_, layer) == layer) {
        return;
    }
    for (const auto& window : windows_) {
        window->take_place(layer);
    }
}

void Overlay::use_clicks(PaneClicks clicks) {
    if (std::exchange(clicks_, clicks) == clicks) {
        return;
    }
    for (const auto& window : windows_) {
        window->use_clicks(clicks);
    }
}

bool Overlay::buried() const {
    return std::ranges::any_of(windows_, [](const auto& window) { return window->buried(); });
}

void Overlay::raise() {
    for (const auto& window : windows_) {
        if (window->visible()) {
            window->take_place(layer_);
        }
    }
}

void Overlay::forget_pixels() {
    stale_ = true;
    for (const auto& window : windows_) {
        window->forget_pixels();
    }
}

bool Overlay::has_pixel_at(HWND window, Point point) const {
    const PaneWindow* const pane = find(window);
    return pane != nullptr && pane->has_pixel_at(point);
}

void Overlay::release() {
    held_ = nullptr;
    stale_ = true;
}

}  // namespace hyrax::win32
