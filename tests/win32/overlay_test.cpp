// SPDX-License-Identifier: MIT
// What the overlay presents, and when; told by its counters and its windows.
#include "daemon/win32/overlay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cwchar>
#include <utility>
#include <vector>

using namespace hyrax;
using namespace hyrax::win32;

namespace {

constexpr Ticks second = ticks_per_second;
constexpr std::uint64_t lone_pane = 192 * 192 * sizeof(Pixel);

struct Deaf final : MessageHandler {
    bool keeps_layers = false;  ///< Panes stay layered whatever is asked of them.

    std::optional<LRESULT> on_message(HWND, UINT message, WPARAM, LPARAM lparam) override {
        if (keeps_layers && message == WM_STYLECHANGING) {
            reinterpret_cast<STYLESTRUCT*>(lparam)->styleNew |= WS_EX_LAYERED;
            return 0;
        }
        return std::nullopt;
    }
};

std::vector<Monitor> screen(int width) {
    const Rect bounds{0, 0, width, 1080};
    return {{.bounds = bounds, .work = bounds, .primary = true, .name = "screen"}};
}

const std::vector<Monitor> usual = screen(1920);

Image plain(Size size) {
    Image image(size);
    std::ranges::fill(image.pixels, Pixel{0xFF804020});
    return image;
}

const Image picture = plain({96, 96});

Frame pets_at(const std::vector<Point>& places) {
    Frame frame;
    for (const Point& place : places) {
        const auto index = static_cast<std::uint32_t>(frame.sprites.size());
        frame.sprites.push_back({picture, place, {index, 1}});
    }
    return frame;
}

/// This thread's panes, which are those of the one overlay of a test.
std::vector<HWND> panes() {
    std::vector<HWND> found;
    const auto collect = [](HWND window, LPARAM list) -> BOOL {
        wchar_t name[32] = L"";
        ::GetClassNameW(window, name, 32);
        if (std::wcscmp(name, L"hyrax.pane") == 0) {
            reinterpret_cast<std::vector<HWND>*>(list)->push_back(window);
        }
        return TRUE;
    };
    ::EnumThreadWindows(::GetCurrentThreadId(), collect, reinterpret_cast<LPARAM>(&found));
    return found;
}

std::ptrdiff_t seen_panes() {
    return std::ranges::count_if(panes(), [](HWND pane) { return ::IsWindowVisible(pane) != 0; });
}

/// Presents and bytes since the last time.
struct Meter {
    const Overlay& overlay;
    OverlayCounters last{};

    std::pair<std::uint64_t, std::uint64_t> more() {
        const OverlayCounters now = overlay.counters();
        const OverlayCounters before = std::exchange(last, now);
        return {now.presents - before.presents, now.bytes - before.bytes};
    }
};

}  // namespace

TEST_CASE("a pane is presented whole at first, then only where it has changed, then not at all") {
    Deaf deaf;
    Overlay overlay(deaf);
    Meter meter{overlay};
    overlay.present(pets_at({{300, 400}}), usual, 0);
    CHECK(meter.more() == std::pair<std::uint64_t, std::uint64_t>{1, lone_pane});
    CHECK(seen_panes() == 1);
    overlay.present(pets_at({{304, 400}}), usual, 1);
    const auto [presents, bytes] = meter.more();
    CHECK(presents == 1);
    CHECK(bytes < lone_pane);
    overlay.present(pets_at({{304, 400}}), usual, 2);
    CHECK(meter.more().first == 0);
    CHECK(overlay.due() == never);
}

TEST_CASE("a change of modes has everything presented once more, without a new frame") {
    Deaf deaf;
    Overlay overlay(deaf);
    Meter meter{overlay};
    overlay.present(pets_at({{300, 400}}), usual, 0);
    meter.more();
    for (int i = 0; i < 50; ++i) {
        overlay.forget_pixels();
    }
    CHECK(overlay.due() == 0);
    CHECK(overlay.present_again(usual, 1));
    CHECK(meter.more() == std::pair<std::uint64_t, std::uint64_t>{1, lone_pane});
    CHECK(overlay.due() == never);
    // Another size of the pane: everything, too.
    overlay.present(pets_at({{300, 400}, {480, 400}}), usual, 2);
    const auto [presents, bytes] = meter.more();
    CHECK(presents == 1);
    CHECK(bytes > lone_pane);
}

TEST_CASE("where a screen changes under a pet that rests, the same frame is wanted again") {
    Deaf deaf;
    Overlay overlay(deaf);
    const Frame frame = pets_at({{300, 400}});
    overlay.present(frame, usual, 0);
    overlay.forget_pixels();
    if (!overlay.present_again(screen(2560), 1)) {
        overlay.present(frame, screen(2560), 1);
    }
    CHECK(seen_panes() == 1);
    CHECK(overlay.due() == never);
    CHECK(overlay.present_again(screen(2560), 2));
    // Its screen goes, and comes back.
    CHECK(overlay.present_again({}, 3));
    CHECK(seen_panes() == 0);
    CHECK_FALSE(overlay.present_again(usual, 4));
    overlay.present(frame, usual, 4);
    CHECK(seen_panes() == 1);
}

TEST_CASE("what the system refuses is tried again after five seconds, not with each frame") {
    Deaf deaf;
    Overlay overlay(deaf);
    overlay.present(pets_at({{300, 400}}), usual, 0);
    ::DestroyWindow(panes().at(0));
    overlay.present(pets_at({{302, 400}}), usual, second);
    const std::uint64_t failures = overlay.counters().failures;
    CHECK(failures > 0);
    CHECK(overlay.due() == 6 * second);
    overlay.present(pets_at({{304, 400}}), usual, 2 * second);
    CHECK(overlay.counters().failures == failures);
    CHECK_FALSE(overlay.present_again(usual, 6 * second));  // It does not have the latest frame.
    overlay.present(pets_at({{304, 400}}), usual, 6 * second);
    CHECK(overlay.counters().failures > failures);
    CHECK(overlay.due() == 11 * second);
}

TEST_CASE("after a refusal that ends, what is shown is where the pet has come meanwhile") {
    Deaf deaf;
    Overlay overlay(deaf);
    overlay.present(pets_at({{300, 400}}), usual, 0);
    const HWND pane = panes().at(0);
    // With attributes of its own a layered window takes no pixels, until its layer is renewed.
    ::SetLayeredWindowAttributes(pane, 0, 200, LWA_ALPHA);
    deaf.keeps_layers = true;
    overlay.present(pets_at({{302, 400}}), usual, second);
    CHECK(overlay.counters().failures > 0);
    const Frame later = pets_at({{320, 400}});
    overlay.present(later, usual, 2 * second);
    deaf.keeps_layers = false;
    REQUIRE(overlay.due() == 6 * second);
    CHECK_FALSE(overlay.present_again(usual, 6 * second));
    CHECK(overlay.due() == never);  // It is the frame's turn.
    overlay.present(later, usual, 6 * second);
    CHECK(seen_panes() == 1);
    CHECK(overlay.has_pixel_at(panes().at(0), {415, 450}));
    CHECK_FALSE(overlay.has_pixel_at(panes().at(0), {310, 450}));
    CHECK(overlay.due() == never);
    const std::uint64_t failures = overlay.counters().failures;
    overlay.present(pets_at({{330, 400}}), usual, 7 * second);
    CHECK(overlay.counters().failures == failures);
}

TEST_CASE("pets apart have windows of their own; what is no longer needed is hidden, at last gone"
) {
    Deaf deaf;
    Overlay overlay(deaf);
    overlay.present(pets_at({{300, 400}, {1500, 400}}), usual, 0);
    CHECK(seen_panes() == 2);
    overlay.present(pets_at({{300, 400}, {450, 400}}), usual, 1);
    CHECK(seen_panes() == 1);
    CHECK(panes().size() == 2);
    overlay.present(pets_at({{300, 400}, {1500, 700}}), usual, 2);
    CHECK(seen_panes() == 2);
    CHECK(panes().size() == 2);
    overlay.present({}, usual, 3);
    CHECK(panes().empty());
}

TEST_CASE("the window under a drag stays, empty, until it is let go") {
    Deaf deaf;
    Overlay overlay(deaf);
    overlay.present(pets_at({{300, 400}}), usual, 0);
    const HWND held = panes().at(0);
    overlay.hold(held);
    overlay.present({}, usual, 1);
    CHECK(::IsWindowVisible(held) != 0);
    CHECK_FALSE(overlay.has_pixel_at(held, {340, 440}));
    overlay.release();
    CHECK(overlay.due() == 0);
    CHECK(overlay.present_again(usual, 2));
    CHECK(panes().empty());
}
