// SPDX-License-Identifier: MIT
#include "daemon/headless/memory_overlay.h"

#include "daemon/core/blit.h"

#include <algorithm>
#include <cstddef>

namespace hyrax {

Frame flattened(const Frame& frame) {
    Frame flat{.sprites = frame.sprites, .kept_free = frame.kept_free, .edition = frame.edition};
    flat.sprites.insert(flat.sprites.end(), frame.bubbles.begin(), frame.bubbles.end());
    return flat;
}

void MemoryOverlay::present(const Frame& frame, std::span<const Monitor> monitors, Ticks now) {
    if (!frame.bubbles.empty()) {
        return present(flattened(frame), monitors, now);
    }
    if (frame == frame_ && now < due()) {
        return;
    }
    ++counters_.frames;
    plan({monitors, places_of(frame), frame.kept_free}, now);
    const std::vector<Rect> changed = changed_places(frame_, frame);
    const std::vector<Rect> before = places_of(frame_);
    for (const Pane& pane : plan_) {
        const PresentCost cost{.most_calls = calls_for_each_of(plan_.size())};
        draw(shown_in(pane.slot), pane.area, {frame, changed, before, cost});
    }
    frame_ = frame;
}

void MemoryOverlay::present_again(std::span<const Monitor> monitors, Ticks now) {
    plan({monitors, places_of(frame_), frame_.kept_free, false}, now);
    for (const Pane& pane : plan_) {
        Shown& shown = shown_in(pane.slot);
        if (shown.area != pane.area && shown.area.contains(pane.area)) {
            crop(shown, pane.area);
        }
    }
}

void MemoryOverlay::plan(const PaneScene& scene, Ticks now) {
    plan_ = plan_panes(scene, plan_, now);
    std::erase_if(shown_, [this](const Shown& shown) {
        return std::ranges::find(plan_, shown.slot, &Pane::slot) == plan_.end();
    });
}

MemoryOverlay::Shown& MemoryOverlay::shown_in(std::size_t slot) {
    const auto found = std::ranges::find(shown_, slot, &Shown::slot);
    if (found != shown_.end()) {
        return *found;
    }
    shown_.push_back({.slot = slot, .area = {}, .pixels = {}});
    return shown_.back();
}

void MemoryOverlay::draw(Shown& shown, const Rect& area, const Change& change) {
    const bool anew = shown.area != area;
    if (anew) {
        const bool resized = shown.area.width != area.width || shown.area.height != area.height;
        counters_.resizes += resized ? 1U : 0U;
        shown.area = area;
        shown.pixels.resize(static_cast<std::size_t>(area.area()));
    }
    const PixelView view(shown.pixels.data(), area.width, {area.width, area.height});
    const std::vector<Rect> parts =
        anew ? std::vector{area} : dirty_clusters(change.places, area, change.cost);
    recompose(view, {area.x, area.y}, parts, anew ? parts : change.before, change.frame);
    for (const Rect& part : parts) {
        count(part);
    }
}

void MemoryOverlay::crop(Shown& shown, const Rect& area) {
    const Rect from = shown.area;
    // Towards the beginning, row by row: no row is overwritten before it has been moved.
    for (int y = 0; y < area.height; ++y) {
        const std::ptrdiff_t begin =
            std::ptrdiff_t{area.y - from.y + y} * from.width + (area.x - from.x);
        const auto row = shown.pixels.begin() + begin;
        std::copy_n(row, area.width, shown.pixels.begin() + std::ptrdiff_t{y} * area.width);
    }
    shown.area = area;
    shown.pixels.resize(static_cast<std::size_t>(area.area()));
    ++counters_.resizes;
    count(area);
}

void MemoryOverlay::count(const Rect& presented) {
    ++counters_.presents;
    counters_.bytes += static_cast<std::uint64_t>(presented.area()) * sizeof(Pixel);
}

Pixel MemoryOverlay::at(Point point) const {
    for (const Shown& shown : shown_) {
        if (shown.area.contains(point)) {
            const std::ptrdiff_t row = std::ptrdiff_t{point.y - shown.area.y} * shown.area.width;
            return shown.pixels[static_cast<std::size_t>(row + point.x - shown.area.x)];
        }
    }
    return 0;
}

}  // namespace hyrax
