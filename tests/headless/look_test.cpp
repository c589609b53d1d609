// SPDX-License-Identifier: MIT
// What settings, sprite sets and screens make of the look of pets, through the whole daemon.
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>

using namespace hyrax;

namespace {

std::string config_with(const std::string& pets, const std::string& overlay) {
    return R"({"pets": {"start": [{"kind": "hyrax", "count": 1, "x": 900, "y": 400}])" + pets +
           R"(}, "overlay": {)" + overlay + "}}";
}

const Sprite& only_sprite(const HeadlessDesktop& desktop) {
    REQUIRE(desktop.last_frame().sprites.size() == 1);
    return desktop.last_frame().sprites[0];
}

Monitor scaled_screen(double scale) {
    Monitor made = screen({0, 0, 1920, 1080});
    made.scale = scale;
    return made;
}

// The picture of a pet that has fallen onto the floor, at 1080.
Rect fallen(const std::string& config, double screen_scale) {
    RecordedDaemon recorded(20.0, {scaled_screen(screen_scale)});
    recorded.config(config);
    recorded.run();
    return only_sprite(recorded.desktop).bounds();
}

}  // namespace

TEST_CASE("scale of settings and screen: the picture grows, the feet stay on the floor") {
    const Rect plain = fallen(config_with("", ""), 1.0);
    CHECK(plain.height > 40);
    CHECK(plain.height < 128);
    const auto check = [&](const Rect& picture, double scale) {
        // Soft edges may reach farther.
        CHECK(std::abs(picture.height - scale * plain.height) <= 2.0 * (1.0 + scale));
        CHECK(std::abs(picture.bottom() - 1080) <= 1 + scale);
    };
    check(plain, 1.0);
    check(fallen(config_with(R"(, "scale": 0.5)", ""), 1.0), 0.5);
    check(fallen(config_with(R"(, "scale": 2)", ""), 1.0), 2.0);
    check(fallen(config_with("", ""), 1.5), 1.5);
    check(fallen(config_with(R"(, "scale_with_dpi": false)", ""), 1.5), 1.0);
}

TEST_CASE("opacity and renderer of the settings reach the frame and the desktop, at once") {
    RecordedDaemon recorded(3.0);
    recorded.config(config_with("", R"("opacity": 0.5)"));
    recorded.look(1.0, [&](const Daemon&) {
        CHECK(only_sprite(recorded.desktop).opacity == 128);
        CHECK(recorded.desktop.renderer() == Renderer::blit);
    });
    recorded.change_file(2.0, "config.json", config_with("", R"("renderer": "gdiplus")"));
    recorded.run();
    CHECK(only_sprite(recorded.desktop).opacity == 255);
    CHECK(recorded.desktop.renderer() == Renderer::gdiplus);
}

TEST_CASE("a press finds a large pet where it is seen") {
    RecordedDaemon recorded(20.0, {scaled_screen(3.0)});
    recorded.config(config_with("", ""));
    bool held = false;
    recorded.look(10.0, [&](const Daemon&) {
        const Rect bounds = only_sprite(recorded.desktop).bounds();
        const Point at{bounds.x + bounds.width / 2, bounds.y + bounds.height / 2};
        recorded.at(10.1, input::Pressed{.at = at, .time = from_seconds(10.1)});
    });
    recorded.look(10.5, [&](const Daemon& daemon) {
        daemon.engine().for_each([&held](PetId, const Pet& pet) {
            held = pet.motion == Motion::held;
        });
    });
    recorded.run();
    CHECK(held);
}
