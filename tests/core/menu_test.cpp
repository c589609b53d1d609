// SPDX-License-Identifier: MIT
#include "daemon/core/menu.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

using namespace hyrax;

namespace {

MenuState busy() {
    return {
        .kinds = {"hyrax", "rock & roll", "round"},
        .pets = 3,
        .scripts =
            {
                {.name = "fountain.lua"},
                {.name = "juggling.lua", .on = false},
                {.name = "broken.lua", .error = "broken.lua:3: attempt to index a nil value"},
            },
        .plugins =
            {
                {.id = "catch", .name = "Catch", .on = true, .error = "catch/main.lua:3: no"},
                {.id = "weather", .name = "Weather", .on = true, .asks = {"cursor", "wind"}},
            },
        .monitors =
            {
                {.id = "left", .text = "1: 1920 x 1080, primary"},
                {.id = "right", .text = "2: 1280 x 1024", .allowed = false},
                {.id = "top", .text = "3: 800 x 600"},
            },
        .autostart = false,
        .problem = "config.json:3:20: /physics/gravity: must be a number",
    };
}

PetMenuState a_pet() {
    return {.pet = {.index = 3, .generation = 7}, .scale = 1.0, .others = 2};
}

template <typename Visit>
void for_each_level(const MenuItems& menu, Visit visit) {
    visit(menu);
    for (const MenuItem& item : menu) {
        if (!item.children.empty()) {
            for_each_level(item.children, visit);
        }
    }
}

std::vector<MenuItem> all_items(const MenuItems& menu) {
    std::vector<MenuItem> all;
    for_each_level(menu, [&all](const MenuItems& level) {
        all.insert(all.end(), level.begin(), level.end());
    });
    return all;
}

/// The character after a single &, lower case; 0 without one.
char mnemonic(const std::string& text) {
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        if (text[i] == '&') {
            if (text[i + 1] != '&') {
                return static_cast<char>(std::tolower(static_cast<unsigned char>(text[i + 1])));
            }
            ++i;
        }
    }
    return 0;
}

const MenuItem& item_named(const MenuItems& menu, std::string_view text) {
    const auto found = std::ranges::find(menu, text, &MenuItem::text);
    REQUIRE_MESSAGE(found != menu.end(), text);
    return *found;
}

template <typename R>
R request_of(const MenuItem& item) {
    const auto* const request = std::get_if<Request>(&item.action);
    REQUIRE(request != nullptr);
    REQUIRE(std::holds_alternative<R>(*request));
    return std::get<R>(*request);
}

}  // namespace

TEST_CASE("menu: every request and every command of the desktop can be reached") {
    std::set<std::size_t> requests;
    std::set<std::size_t> commands;
    MenuState hidden = busy();
    hidden.hidden = true;
    for (const MenuItems& menu : {tray_menu(busy()), tray_menu(hidden), pet_menu(a_pet())}) {
        for (const MenuItem& item : all_items(menu)) {
            if (const auto* const request = std::get_if<Request>(&item.action)) {
                requests.insert(request->index());
                CHECK(item.enabled);
            }
            if (const auto* const command = std::get_if<DesktopCommand>(&item.action)) {
                commands.insert(command->index());
            }
        }
    }
    // The menu knows whether pets are paused, so it never asks to toggle.
    CHECK(requests.size() == std::variant_size_v<Request> - 1);
    CHECK_FALSE(requests.contains(Request{request::TogglePause{}}.index()));
    CHECK(commands.size() == std::variant_size_v<DesktopCommand>);
}

TEST_CASE("menu: every item that can be chosen has a mnemonic of its own on its level") {
    MenuState many = busy();
    for (int i = 0; i < 3; ++i) {
        many.kinds.push_back("kind " + std::to_string(i));
        many.scripts.push_back({.name = "reload" + std::to_string(i) + ".lua"});
    }
    MenuState hidden = busy();
    hidden.hidden = true;
    hidden.hidden_until = "14:30";
    for (const MenuItems& menu :
         {tray_menu(busy()), tray_menu(many), tray_menu(hidden), pet_menu(a_pet())}) {
        for_each_level(menu, [](const MenuItems& level) {
            std::set<char> keys;
            for (const MenuItem& item : level) {
                if (item.is_line() || !item.enabled) {
                    continue;
                }
                CAPTURE(item.text);
                const char key = mnemonic(item.text);
                CHECK((key != 0 && keys.insert(key).second));
            }
        });
    }
}

TEST_CASE("menu: where letters run out, items have none rather than one twice") {
    MenuState state;
    state.kinds = {"aa", "a", "AA", "\xE5\xB2\xA9"};
    const MenuItems kinds = item_named(tray_menu(state), "&Spawn").children;
    CHECK(kinds.at(0).text == "&aa");
    CHECK(kinds.at(1).text == "a");
    CHECK(kinds.at(2).text == "AA");
    CHECK(kinds.at(3).text == "\xE5\xB2\xA9");
}

TEST_CASE("menu: an ampersand of a name is shown, not taken for a mnemonic") {
    const MenuItems kinds = item_named(tray_menu(busy()), "&Spawn").children;
    CHECK(kinds.at(1).text == "&rock && roll");
    CHECK(request_of<request::Spawn>(kinds.at(1)).kind == "rock & roll");
    MenuState state;
    state.problem = "this & that";
    CHECK(tray_menu(state).at(0).text == "this && that");
    CHECK_FALSE(tray_menu(state).at(0).enabled);
    CHECK(tray_menu(state).at(1).is_line());
}

TEST_CASE("menu: long texts are shortened by characters, not by bytes") {
    CHECK(shortened_text("abc", 3) == "abc");
    CHECK(shortened_text("abcd", 3) == "ab\xE2\x80\xA6");
    CHECK(shortened_text("\xC3\xA4\xC3\xB6\xC3\xBC", 3) == "\xC3\xA4\xC3\xB6\xC3\xBC");
    CHECK(shortened_text("\xC3\xA4\xC3\xB6\xC3\xBC\xC3\x9F", 3) == "\xC3\xA4\xC3\xB6\xE2\x80\xA6");
    CHECK(shortened_text("", 3).empty());
    MenuState state;
    state.kinds = {std::string(300, 'x')};
    state.problem = std::string(300, 'y');
    CHECK(tray_menu(state).at(0).text.size() == 89 + 3);
    CHECK(item_named(tray_menu(state), "&Spawn").children.at(0).text.size() == 1 + 59 + 3);
}

TEST_CASE("menu: ticks show what is on, and choosing turns it round") {
    MenuState state = busy();
    const MenuItems menu = tray_menu(state);
    CHECK_FALSE(item_named(menu, "&Pause").checked);
    CHECK(request_of<request::SetPaused>(item_named(menu, "&Pause")).paused);
    CHECK(request_of<request::SetQuiet>(item_named(menu, "Qui&et")).quiet);
    CHECK(request_of<request::SetClickThrough>(item_named(menu, "Clic&ks go through")).on);
    const MenuItems scripts = item_named(menu, "S&cripts").children;
    CHECK(scripts.at(0).checked);
    CHECK_FALSE(request_of<request::SetScript>(scripts.at(0)).on);
    CHECK_FALSE(scripts.at(1).checked);
    CHECK(request_of<request::SetScript>(scripts.at(1)).on);
    CHECK(scripts.at(3).text == "    broken.lua:3: attempt to index a nil value");
    CHECK_FALSE(scripts.at(3).enabled);
    const MenuItems monitors = item_named(menu, "Mo&nitors").children;
    CHECK(monitors.at(0).text == "&1: 1920 x 1080, primary");
    CHECK_FALSE(request_of<request::SetMonitor>(monitors.at(0)).allowed);
    CHECK(request_of<request::SetMonitor>(monitors.at(1)).allowed);
    CHECK(request_of<request::SetMonitor>(monitors.at(1)).monitor == "right");

    state.paused = state.quiet = state.click_through = true;
    state.autostart = true;
    const MenuItems turned = tray_menu(state);
    CHECK(item_named(turned, "&Pause").checked);
    CHECK_FALSE(request_of<request::SetPaused>(item_named(turned, "&Pause")).paused);
    CHECK_FALSE(request_of<request::SetQuiet>(item_named(turned, "Qui&et")).quiet);
    CHECK(item_named(turned, "Clic&ks go through").checked);
    CHECK_FALSE(request_of<request::SetClickThrough>(item_named(turned, "Clic&ks go through")).on);
    const DesktopCommand off = desktop_command::SetAutostart{false};
    CHECK(std::get<DesktopCommand>(item_named(turned, "Start with &Windows").action) == off);
}

TEST_CASE("menu: hiding is offered with three ends, showing while hidden") {
    MenuState state;
    state.seconds_until_tomorrow = 4711;
    const MenuItems hide = item_named(tray_menu(state), "&Hide").children;
    CHECK(request_of<request::Hide>(hide.at(0)).seconds == 1800);
    CHECK(request_of<request::Hide>(hide.at(1)).seconds == 4711);
    CHECK_FALSE(request_of<request::Hide>(hide.at(2)).seconds.has_value());
    state.hidden = true;
    CHECK(item_named(tray_menu(state), "S&how").children.empty());
    state.hidden_until = "14:30";
    request_of<request::Show>(item_named(tray_menu(state), "S&how (hidden until 14:30)"));
}

TEST_CASE("menu: what would do nothing cannot be chosen") {
    const MenuItems menu = tray_menu(MenuState{});
    for (const char* text : {"&Gather", "&Fling all", "&Reset all", "Re&move all", "&Spawn"}) {
        CHECK_FALSE(item_named(menu, text).enabled);
    }
    // The only monitor left cannot be taken from the pets.
    MenuState one;
    one.monitors = {
        {.id = "a", .text = "1", .allowed = true}, {.id = "b", .text = "2", .allowed = false}
    };
    const MenuItems monitors = item_named(tray_menu(one), "Mo&nitors").children;
    CHECK_FALSE(monitors.at(0).enabled);
    CHECK(monitors.at(1).enabled);
    CHECK_FALSE(item_named(pet_menu({.pet = {}, .others = 0}), "Remove &others").enabled);
    // A desktop without such a thing has no item for it.
    CHECK(std::ranges::none_of(menu, [](const MenuItem& item) {
        return item.text == "Start with &Windows";
    }));
}

TEST_CASE("menu: plugins with what they ask for and what is wrong with them") {
    const MenuItems plugins = item_named(tray_menu(busy()), "P&lugins").children;
    REQUIRE(plugins.size() == 4);
    CHECK(plugins[0].checked);
    CHECK_FALSE(request_of<request::SetPlugin>(plugins[0]).on);
    CHECK(plugins[1].text == "    catch/main.lua:3: no");
    CHECK_FALSE(plugins[1].enabled);
    CHECK(plugins[3].text.ends_with("llow Weather: cursor, wind"));
    CHECK(request_of<request::AllowPlugin>(plugins[3]).plugin == "weather");
    CHECK(request_of<request::AllowPlugin>(plugins[3]).allowed);
    for (const MenuItem& item : tray_menu({})) {
        CHECK(item.text != "P&lugins");
    }
}

TEST_CASE("menu: a pet's sizes, with the present one ticked") {
    const MenuItems sizes = item_named(pet_menu(a_pet()), "S&cale").children;
    REQUIRE(sizes.size() == std::size(menu_scales));
    CHECK(sizes.at(0).text == "&50 %");
    CHECK(sizes.at(2).checked);
    CHECK_FALSE(sizes.at(3).checked);
    CHECK(request_of<request::SetScale>(sizes.at(3)).scale == 1.5);
    CHECK(request_of<request::SetScale>(sizes.at(3)).pet == a_pet().pet);
}

TEST_CASE("menu: the wheel goes through the sizes and stops at both ends") {
    CHECK(scale_after(1.0, 1) == 1.5);
    CHECK(scale_after(1.0, -1) == 0.75);
    CHECK(scale_after(1.1, 1) == 1.5);
    CHECK(scale_after(2.0, 1) == 2.0);
    CHECK(scale_after(0.5, -1) == 0.5);
    CHECK(scale_after(1.0, 2'000'000'000) == 2.0);
    CHECK(scale_after(1.0, -2'000'000'000) == 0.5);
}

TEST_CASE("menu: monitors as people tell them apart") {
    const Monitor primary{.bounds = {0, 0, 1920, 1080}, .work = {}, .primary = true, .name = "x"};
    CHECK(monitor_text(1, primary) == "1: 1920 x 1080, primary");
    const Monitor other{.bounds = {-800, 0, 800, 600}, .work = {}, .primary = false, .name = "y"};
    CHECK(monitor_text(2, other) == "2: 800 x 600");
}
