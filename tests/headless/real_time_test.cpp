// SPDX-License-Identifier: MIT
#include "daemon/headless/headless_desktop.h"
#include "daemon/headless/process_use.h"
#include "daemon/headless/real_time_desktop.h"
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <random>

using namespace hyrax;

namespace {

/// The middle of a disc, the rest transparent: an image whose every pixel is told from the others.
Image disc(int side) {
    Image image(Size{side, side});
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const int dx = 2 * x - side;
            const int dy = 2 * y - side;
            const bool inside = dx * dx + dy * dy < side * side;
            const auto shade = static_cast<Pixel>(0x80 + (x + y) % 0x70);
            image.pixels[static_cast<std::size_t>(y * side + x)] =
                inside ? 0xff000000U | shade * 0x010101U : 0U;
        }
    }
    return image;
}

Sprite sprite_of(const Image& image, std::uint32_t index, Point at) {
    return {image, at, {index, 1}};
}

const std::vector<Monitor> two_screens{screen({0, 0, 800, 600}), screen({-640, -100, 640, 480})};

/// Pixels of both screens that are not as in a picture of the whole frame.
int differing_pixels(const MemoryOverlay& overlay, const Frame& frame) {
    const Image whole = picture(frame, two_screens);
    int different = 0;
    for (const Monitor& monitor : two_screens) {
        const Rect& area = monitor.bounds;
        for (int y = area.y; y < area.bottom(); ++y) {
            for (int x = area.x; x < area.right(); ++x) {
                different += overlay.at({x, y}) != whole.at(x + 640, y + 100) ? 1 : 0;
            }
        }
    }
    return different;
}

}  // namespace

TEST_CASE("panes in memory show what a picture of the whole frame shows") {
    const Image image = disc(48);
    MemoryOverlay overlay;
    std::mt19937 random(3);
    std::uniform_int_distribution<int> step(-30, 30);
    std::vector<Point> places(12, Point{100, 100});
    Ticks now = 0;
    for (int turn = 0; turn < 150; ++turn) {
        Frame frame;
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[i].x = std::clamp(places[i].x + step(random), -700, 820);
            places[i].y = std::clamp(places[i].y + step(random), -140, 620);
            // Pets come and go, too.
            if ((static_cast<int>(i) + turn / 20) % 5 != 0) {
                frame.sprites.push_back(sprite_of(image, static_cast<std::uint32_t>(i), places[i]));
            }
        }
        now += ticks_per_second / 10;
        if (turn % 3 == 0) {
            overlay.present_again(two_screens, now);
        }
        overlay.present(frame, two_screens, now);
        REQUIRE(differing_pixels(overlay, frame) == 0);
    }
    CHECK(overlay.counters().frames == 150);
    CHECK(overlay.counters().presents >= 150);
}

TEST_CASE("panes in memory hold bubbles, above the pets") {
    const Image pet = disc(48);
    const Image text = disc(30);
    MemoryOverlay overlay;
    Frame frame{.sprites = {sprite_of(pet, 1, {300, 300})}};
    overlay.present(frame, two_screens, 0);
    for (const Point at : {Point{310, 280}, Point{700, 20}, Point{-300, 0}}) {
        frame.bubbles = {sprite_of(text, 1, at)};
        overlay.present(frame, two_screens, 1);
        CHECK(overlay.at({at.x + 15, at.y + 15}) == text.at(15, 15));
        CHECK(differing_pixels(overlay, frame) == 0);
    }
    frame.bubbles.clear();
    overlay.present(frame, two_screens, 2);
    CHECK(overlay.at({-285, 15}) == 0);
    CHECK(differing_pixels(overlay, frame) == 0);
}

TEST_CASE("a pane that shrinks while nothing moves still shows its pets") {
    const Image image = disc(48);
    MemoryOverlay overlay;
    const Frame apart{{sprite_of(image, 1, {620, 420}), sprite_of(image, 2, {450, 420})}};
    const Frame together{{sprite_of(image, 1, {620, 420}), sprite_of(image, 2, {640, 400})}};
    overlay.present(apart, two_screens, 0);
    overlay.present(together, two_screens, ticks_per_ms);
    const std::uint64_t resizes = overlay.counters().resizes;
    while (overlay.due() != never) {
        overlay.present_again(two_screens, overlay.due());
        CHECK(differing_pixels(overlay, together) == 0);
    }
    CHECK(overlay.counters().resizes == resizes + 1);
}

TEST_CASE("an overlay may outlive the pictures of the frame that it shows") {
    MemoryOverlay overlay;
    const Image image = disc(48);
    {
        const Image brief = disc(48);
        overlay.present({{sprite_of(brief, 1, {100, 100})}}, two_screens, 0);
    }
    const Frame next{{sprite_of(image, 1, {120, 100})}};
    overlay.present(next, two_screens, 1);
    CHECK(differing_pixels(overlay, next) == 0);
}

TEST_CASE("equal frames present nothing") {
    const Image image = disc(48);
    MemoryOverlay overlay;
    const Frame frame{{sprite_of(image, 1, {100, 100})}};
    for (Ticks now = 0; now < 10 * ticks_per_second; now += ticks_per_second / 60) {
        overlay.present(frame, two_screens, now);
    }
    CHECK(overlay.counters().frames == 1);
    CHECK(overlay.counters().presents == 1);
    CHECK(overlay.counters().bytes == 128U * 128U * sizeof(Pixel));
}

TEST_CASE("the real clock wakes for the deadline, for signals, and for the end") {
    RealTimeDesktop desktop(two_screens, ticks_per_second / 5);
    const Ticks begin = desktop.now();
    CHECK(desktop.wait(begin + 20 * ticks_per_ms).empty());
    CHECK(desktop.now() >= begin + 20 * ticks_per_ms);
    CHECK(desktop.counters().timer_wakeups == 1);

    int told = 0;
    desktop.on_statistics_request([&told] { ++told; });
    ::raise(SIGUSR1);
    CHECK(desktop.wait(desktop.now() + 5 * ticks_per_ms).empty());
    CHECK(told == 1);

    const std::vector<Input> end = desktop.wait(never);
    REQUIRE(end.size() == 1);
    CHECK(std::holds_alternative<Request>(end[0]));
    CHECK(desktop.now() >= begin + ticks_per_second / 5);
}

TEST_CASE("a request of the system to end quits") {
    RealTimeDesktop desktop(two_screens, 3600 * ticks_per_second);
    ::raise(SIGTERM);
    const std::vector<Input> end = desktop.wait(never);
    REQUIRE(end.size() == 1);
    CHECK(std::holds_alternative<request::Quit>(std::get<Request>(end[0])));
}

TEST_CASE("the process knows its memory and its descriptors") {
    const ProcessUse use = process_use();
    CHECK(use.resident_bytes > 1'000'000);
    CHECK(use.private_bytes > 100'000);
    CHECK(use.private_bytes < use.resident_bytes);
    CHECK(use.handles >= 3);
}

TEST_CASE("frames go on while pictures that have changed are decoded, and scripts wait for them") {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    folder.write("config.json", R"({"physics": {"gravity": 0, "air_drag": 1, "restitution": 1},
        "pets": {"start": [{"x": 100, "y": 100, "vx": 500}]}})");
    std::atomic<bool> slow = false;
    std::atomic<int> decoded = 0;
    RealTimeDesktop desktop({screen({0, 0, 1920, 1080})}, never);
    DaemonOptions options{
        .profile = profile_in(folder),
        .decode =
            [&](std::span<const std::byte> file) {
                ++decoded;
                slow.wait(true);
                return decode_png(file);
            },
        .scripts = make_script_host({}),
        .trace = {},
        .requests = {},
        .fps = {},
    };
    Daemon daemon(desktop, std::move(options));
    const auto run_until = [&](const auto& done) {
        const Ticks patience = desktop.now() + 20 * ticks_per_second;
        while (!done() && desktop.now() < patience) {
            daemon.run_due();
            for (const Input& input : desktop.wait(desktop.now() + 5 * ticks_per_ms)) {
                daemon.handle(input);
            }
        }
        return done();
    };
    const auto frames = [&] { return daemon.figures().frames; };
    CHECK(run_until([&] { return frames() > 2; }));
    const int at_first = decoded;
    slow = true;
    fs::create_directories(folder.path() / "sprites");
    fs::copy(
        fs::path(HYRAX_SOURCE_DIR) / "config" / "sprites" / "hyrax",
        folder.path() / "sprites" / "marmot"
    );
    folder.write("scripts/late.lua", "hyrax.spawn{ kind = 'marmot' }");
    daemon.handle(input::FilesChanged{});
    const std::uint64_t before = frames();
    CHECK(run_until([&] { return frames() > before + 20; }));
    CHECK(daemon.script_states().empty());
    CHECK(decoded == at_first + 1);
    slow = false;
    slow.notify_all();
    CHECK(run_until([&] { return daemon.engine().size() == 2; }));
    CHECK(daemon.status().problem.empty());
    CHECK(decoded == at_first + 2);
}
