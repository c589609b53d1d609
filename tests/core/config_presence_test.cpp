// SPDX-License-Identifier: MIT
// The keys of config.json by which pets keep out of the way.
#include "daemon/core/config.h"

#include <doctest/doctest.h>

using namespace hyrax;

TEST_CASE("config: how pets keep out of the way") {
    const Result<LoadedConfig> loaded = parse_config(
        R"({"overlay": {
            "fullscreen": "pause",
            "fullscreen_rules": [{"exe": "Game.exe", "do": "hide_everywhere"}, {"exe": "b"}],
            "fps_on_battery": 20, "fps_saving": 10, "on_resume": "catch_up",
            "reduced_motion": "on", "hide_from_capture": true}})",
        "config.json"
    );
    REQUIRE(loaded);
    CHECK(loaded->warnings.empty());
    CHECK(
        loaded->config.presence ==
        PresenceSettings{
            .full_screen = FullScreenAct::pause,
            .rules = {{"Game.exe", FullScreenAct::hide_everywhere}, {"b", FullScreenAct::hide}},
            .fps_on_battery = 20,
            .fps_saving = 10,
            .on_resume = OnResume::catch_up,
            .reduced_motion = ReducedMotion::on,
            .hide_from_capture = true,
        }
    );
}

TEST_CASE("config: where pets stand among all windows") {
    const auto layer = [](const std::string& overlay) {
        const auto loaded = parse_config("{\"overlay\": {" + overlay + "}}", "config.json");
        REQUIRE(loaded);
        return loaded->config.layer;
    };
    CHECK(layer("") == Layer::above_taskbar);
    CHECK(layer(R"("z": "above_taskbar")") == Layer::above_taskbar);
    CHECK(layer(R"("z": "top")") == Layer::top);
    CHECK(layer(R"("z": "bottom")") == Layer::bottom);
}

TEST_CASE("config: a rule names its program, and hide_everywhere is for rules alone") {
    const auto complaint = [](std::string_view overlay) {
        const Result<LoadedConfig> loaded =
            parse_config("{\"overlay\": " + std::string(overlay) + "}", "config.json");
        return loaded ? "no error" : loaded.error().message;
    };
    CHECK(
        complaint(R"({"fullscreen_rules": [{"do": "stay"}]})") ==
        "config.json:1:35: /overlay/fullscreen_rules/0: \"exe\" is missing"
    );
    CHECK(complaint(R"({"fullscreen_rules": [{"exe": "a/b.exe"}]})").contains("/0/exe: must be "));
    CHECK(
        complaint(R"({"fullscreen": "hide_everywhere"})") ==
        "config.json:1:28: /overlay/fullscreen: must be \"hide\", \"pause\" or \"stay\", got "
        "\"hide_everywhere\""
    );
}
