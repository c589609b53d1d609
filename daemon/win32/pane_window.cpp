// SPDX-License-Identifier: MIT
#include "daemon/win32/pane_window.h"

#include "daemon/core/blit.h"
#include "daemon/core/coarse_outline.h"
#include "daemon/win32/gdiplus_renderer.h"
#include "daemon/win32/text.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstddef>
#include <cwchar>
#include <iterator>
#include <utility>
#include <vector>

namespace hyrax::win32 {

namespace {

constexpr DWORD pane_style = WS_EX_LAYERED | WS_EX_TOPMOST | WS_EX_TOOLWINDOW | WS_EX_NOACTIVATE;

constexpr const wchar_t* not_rude = L"NonRudeHWND";

DWORD style_for(PaneClicks clicks) {
    return clicks == PaneClicks::on_pixels ? pane_style : pane_style | WS_EX_TRANSPARENT;
}

void render(
    const PixelView& target,
    const PanePicture& picture,
    std::span<const Rect> parts,
    std::span<const Rect> before
) {
    const Point origin{picture.pane.area.x, picture.pane.area.y};
    if (picture.renderer == Renderer::blit) {
        recompose(target, origin, parts, before, picture.frame);
        return;
    }
    for (const Rect& part : parts) {
        compose_with_gdiplus(target, origin, part, picture.frame);
    }
}

bool is_taskbar(HWND window) {
    wchar_t name[64] = L"";
    ::GetClassNameW(window, name, static_cast<int>(std::size(name)));
    return std::wcscmp(name, L"Shell_TrayWnd") == 0 ||
           std::wcscmp(name, L"Shell_SecondaryTrayWnd") == 0;
}

bool overlaps(const RECT& rect, const Rect& area) {
    return rect.left < area.right() && rect.right > area.x && rect.top < area.bottom() &&
           rect.bottom > area.y;
}

}  // namespace

Result<std::unique_ptr<PaneWindow>> PaneWindow::create(
    std::size_t slot, PaneClicks clicks, MessageHandler& handler
) {
    std::unique_ptr<PaneWindow> pane(new PaneWindow(slot));
    Result<Window> window = create_window(
        {.class_name = L"hyrax.pane", .title = L"hyrax pane", .extended_style = style_for(clicks)},
        handler
    );
    if (!window) {
        return std::unexpected(window.error());
    }
    pane->window_ = std::move(*window);
    // Must be there before the window is first shown. Without it Explorer takes a pane that covers
    // a monitor for a full-screen program and lowers the taskbar.
    ::SetPropW(pane->window(), not_rude, reinterpret_cast<HANDLE>(INT_PTR{TRUE}));
    return pane;
}

PaneWindow::~PaneWindow() {
    if (window_) {
        ::RemovePropW(window(), not_rude);
    }
}

void PaneWindow::show(const PanePicture& picture, Ticks now, OverlayCounters& counters) {
    const Rect& area = picture.pane.area;
    if (retry_at_ != never && now < retry_at_) {
        outdated_ = true;
        if (visible_ && area != area_) {
            ::ShowWindow(window(), SW_HIDE);  // Its pets may stand in another pane by now.
            visible_ = false;
        }
        return;
    }
    const Rect& monitor = picture.pane.monitor;
    const Size size{area.width, area.height};
    blank_ = false;
    if (!complete_ || area != area_ || picture.outline_rows != outline_rows_) {
        counters.resizes += size != Size{area_.width, area_.height} ? 1U : 0U;
        const Result<bool> room = surface_.make_room(size, {monitor.width, monitor.height});
        if (!room) {
            area_ = {};  // The old pixels are gone, too.
            refused(now, room.error().message);
            return;
        }
        area_ = area;
        outline_rows_ = picture.outline_rows;
        draw(picture, {&area, 1}, {&area, 1});
        outdated_ = false;
        present_all(now, counters);
    } else {
        std::vector<Rect> parts;
        for (const Rect& part : picture.dirty) {
            parts.push_back(whole_bands(part, area, outline_rows_));
        }
        // A coarse outline leaves pixels beside the sprites.
        draw(picture, parts, outline_rows_ == 1 ? picture.before : parts);
        for (const Rect& part : parts) {
            if (!present(&part, counters)) {
                present_all(now, counters);
                break;
            }
        }
    }
    if (!visible_ && complete_) {
        appear();
    }
}

/// Tried twice: what brings a layered window back whose updates fail, as they do once some other
/// program has called SetLayeredWindowAttributes on it, is to renew its layer.
void PaneWindow::present_all(Ticks now, OverlayCounters& counters) {
    complete_ = present(nullptr, counters);
    if (!complete_) {
        renew_layer();
        complete_ = present(nullptr, counters);
    }
    if (!complete_) {
        refused(now, system_error("pets cannot be shown").message);
    } else if (std::exchange(retry_at_, never) != never) {
        spdlog::info("pets are shown again");
    }
}

void PaneWindow::refused(Ticks now, const std::string& why) {
    complete_ = false;
    if (std::exchange(retry_at_, now + retry_after) == never) {
        spdlog::error("{}; tried again every 5 s", why);
    }
}

void PaneWindow::draw(
    const PanePicture& picture, std::span<const Rect> parts, std::span<const Rect> before
) {
    const PixelView view = surface_.view({area_.width, area_.height});
    render(view, picture, parts, before);
    for (const Rect& part : parts) {
        const Rect local{part.x - area_.x, part.y - area_.y, part.width, part.height};
        coarsen_outline(view, local, outline_rows_);
    }
}

bool PaneWindow::show_again(const Rect& area, Ticks now, OverlayCounters& counters) {
    if (!visible_ || blank_ || outdated_ || !area_.contains(area)) {
        return false;
    }
    if (complete_ && area == area_) {
        return true;
    }
    counters.resizes += area != area_ ? 1U : 0U;
    const PixelView view = surface_.view({area_.width, area_.height});
    // Towards the top left, row by row: no row is overwritten before it has been moved.
    for (int y = 0; y < area.height; ++y) {
        const Pixel* const from =
            view.pixels + std::ptrdiff_t{y + area.y - area_.y} * view.stride + (area.x - area_.x);
        std::copy_n(from, area.width, view.pixels + std::ptrdiff_t{y} * view.stride);
    }
    area_ = area;
    present_all(now, counters);
    return true;
}

/// The whole area, with its place and size, or the dirty part of it, which may be all.
bool PaneWindow::present(const Rect* dirty, OverlayCounters& counters) {
    POINT at{area_.x, area_.y};
    SIZE size{area_.width, area_.height};
    POINT source{0, 0};
    BLENDFUNCTION blend{AC_SRC_OVER, 0, 255, AC_SRC_ALPHA};
    UPDATELAYEREDWINDOWINFO update{};
    update.cbSize = sizeof update;
    update.hdcSrc = surface_.dc();
    update.pptSrc = &source;
    update.pblend = &blend;
    update.dwFlags = ULW_ALPHA;
    RECT part{};
    if (dirty == nullptr) {
        update.pptDst = &at;
        update.psize = &size;
    } else if (*dirty != area_) {
        part = {
            dirty->x - area_.x,
            dirty->y - area_.y,
            dirty->right() - area_.x,
            dirty->bottom() - area_.y
        };
        update.prcDirty = &part;
    }
    counters.presents += 1;
    counters.bytes +=
        static_cast<std::uint64_t>((dirty != nullptr ? *dirty : area_).area()) * sizeof(Pixel);
    if (::UpdateLayeredWindowIndirect(window(), &update) != 0) {
        return true;
    }
    counters.failures += 1;
    return false;
}

void PaneWindow::renew_layer() {
    const LONG_PTR styles = ::GetWindowLongPtrW(window(), GWL_EXSTYLE);
    ::SetWindowLongPtrW(window(), GWL_EXSTYLE, styles & ~LONG_PTR{WS_EX_LAYERED});
    ::SetWindowLongPtrW(window(), GWL_EXSTYLE, styles | WS_EX_LAYERED);
}

void PaneWindow::hide() {
    if (visible_) {
        ::ShowWindow(window(), SW_HIDE);
        visible_ = false;
    }
    surface_.let_go();
    area_ = {};
    complete_ = false;
    retry_at_ = never;
}

void PaneWindow::show_nothing(OverlayCounters& counters) {
    retry_at_ = never;
    if (visible_ && !blank_ && !area_.empty()) {
        erase(surface_.view({area_.width, area_.height}), {0, 0, area_.width, area_.height});
        blank_ = present(nullptr, counters);
        complete_ = false;
    }
}

bool PaneWindow::exclude_from_capture(bool exclude) {
    return ::SetWindowDisplayAffinity(window(), exclude ? WDA_EXCLUDEFROMCAPTURE : WDA_NONE) != 0;
}

void PaneWindow::take_place(Layer layer) {
    layer_ = layer;
    stand_in_layer(0);
}

/// In one step: a window that appears first and takes its place then has been in front of others.
void PaneWindow::appear() {
    stand_in_layer(SWP_SHOWWINDOW);
    visible_ = true;
}

void PaneWindow::stand_in_layer(UINT more) {
    ::SetWindowPos(
        window(),
        layer_ == Layer::bottom ? HWND_BOTTOM : HWND_TOPMOST,
        0,
        0,
        0,
        0,
        SWP_NOMOVE | SWP_NOSIZE | SWP_NOACTIVATE | SWP_NOOWNERZORDER | more
    );
}

/// Topmost is not for this to decide: take_place() may have taken it away.
void PaneWindow::use_clicks(PaneClicks clicks) {
    const LONG_PTR topmost = ::GetWindowLongPtrW(window(), GWL_EXSTYLE) & WS_EX_TOPMOST;
    const auto others = static_cast<LONG_PTR>(style_for(clicks) & ~DWORD{WS_EX_TOPMOST});
    ::SetWindowLongPtrW(window(), GWL_EXSTYLE, others | topmost);
    ::SetWindowPos(
        window(),
        nullptr,
        0,
        0,
        0,
        0,
        SWP_FRAMECHANGED | SWP_NOMOVE | SWP_NOSIZE | SWP_NOZORDER | SWP_NOACTIVATE |
            SWP_NOOWNERZORDER
    );
}

bool PaneWindow::buried() const {
    if (!visible_ || layer_ == Layer::bottom) {
        return false;
    }
    if ((::GetWindowLongPtrW(window(), GWL_EXSTYLE) & WS_EX_TOPMOST) == 0) {
        return true;
    }
    return layer_ == Layer::above_taskbar && below_taskbar();
}

bool PaneWindow::below_taskbar() const {
    // Windows come and go meanwhile: the walk has an end in any case.
    constexpr int most_above = 1000;
    HWND above = ::GetWindow(window(), GW_HWNDPREV);
    for (int i = 0; above != nullptr && i < most_above; ++i) {
        RECT place{};
        if (is_taskbar(above) && ::IsWindowVisible(above) != 0 &&
            ::GetWindowRect(above, &place) != 0 && overlaps(place, area_)) {
            return true;
        }
        above = ::GetWindow(above, GW_HWNDPREV);
    }
    return false;
}

bool PaneWindow::has_pixel_at(Point point) const {
    if (!visible_ || !area_.contains(point)) {
        return false;
    }
    const PixelView view = surface_.view({area_.width, area_.height});
    const Pixel* const row = view.pixels + std::ptrdiff_t{point.y - area_.y} * view.stride;
    return alpha_of(row[point.x - area_.x]) > alpha_of(faint_pixel);
}

}  // namespace hyrax::win32
