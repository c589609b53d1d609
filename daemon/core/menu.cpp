// SPDX-License-Identifier: MIT
#include "daemon/core/menu.h"

#include "daemon/core/ascii.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace hyrax {
namespace {

/// A longer line would make the menu wider than a small screen.
constexpr std::size_t longest_text = 60;
constexpr std::size_t longest_problem = 90;

MenuItem item(std::string text, MenuAction action) {
    return {.text = std::move(text), .action = std::move(action)};
}

MenuItem ticked(std::string text, bool checked, MenuAction action) {
    return {.text = std::move(text), .action = std::move(action), .checked = checked};
}

MenuItem heading(std::string_view text) {
    return {.text = shortened_text(text, longest_problem), .enabled = false};
}

MenuItem line() {
    return {.text = {}, .enabled = false};
}

MenuItem submenu(std::string text, MenuItems children) {
    const bool enabled = !children.empty();
    return {.text = std::move(text), .enabled = enabled, .children = std::move(children)};
}

// --- mnemonics -------------------------------------------------------------------------------

bool is_ascii_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// Doubles every & and puts one before the character at `at`, if there is such.
std::string marked(std::string_view text, std::size_t at) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i == at || text[i] == '&') {
            result += '&';
        }
        result += text[i];
    }
    return result;
}

/// Hands out the first letter or digit of each text that is still free.
class Mnemonics {
public:
    void reserve(char key) { taken_ += lower_ascii(key); }
    std::string give(std::string_view text) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (is_ascii_letter_or_digit(text[i]) && !taken_.contains(lower_ascii(text[i]))) {
                reserve(text[i]);
                return marked(text, i);
            }
        }
        return marked(text, std::string::npos);
    }

private:
    std::string taken_;
};

/// Shortens and marks items whose texts are plain so far: names of kinds, scripts, monitors.
MenuItems with_mnemonics(MenuItems plain, Mnemonics mnemonics = {}) {
    for (MenuItem& each : plain) {
        if (!each.is_line()) {
            each.text = each.enabled ? mnemonics.give(shortened_text(each.text, longest_text))
                                     : marked(each.text, std::string::npos);
        }
    }
    return plain;
}

// --- the tray's submenus ---------------------------------------------------------------------

MenuItems kinds_menu(const MenuState& state) {
    MenuItems menu;
    for (const std::string& kind : state.kinds) {
        menu.push_back(item(kind, Request{request::Spawn{.kind = kind}}));
    }
    return with_mnemonics(std::move(menu));
}

MenuItems hide_menu(const MenuState& state) {
    return {
        item("For &30 minutes", Request{request::Hide{.seconds = 30 * 60}}),
        item("Until &tomorrow", Request{request::Hide{.seconds = state.seconds_until_tomorrow}}),
        item("Until &shown", Request{request::Hide{}}),
    };
}

MenuItems scripts_menu(const MenuState& state) {
    MenuItems scripts;
    for (const ScriptState& script : state.scripts) {
        scripts.push_back(
            ticked(script.name, script.on, Request{request::SetScript{script.name, !script.on}})
        );
        if (!script.error.empty()) {
            scripts.push_back(heading("    " + script.error));
        }
    }
    Mnemonics mnemonics;
    mnemonics.reserve('r');
    MenuItems menu = with_mnemonics(std::move(scripts), mnemonics);
    if (!menu.empty()) {
        menu.push_back(line());
    }
    menu.push_back(item("&Reload", Request{request::Reload{}}));
    return menu;
}

MenuItems plugins_menu(const MenuState& state) {
    MenuItems menu;
    for (const PluginMenuState& plugin : state.plugins) {
        menu.push_back(
            ticked(plugin.name, plugin.on, Request{request::SetPlugin{plugin.id, !plugin.on}})
        );
        if (!plugin.asks.empty()) {
            menu.push_back(item(
                fmt::format("    Allow {}: {}", plugin.name, fmt::join(plugin.asks, ", ")),
                Request{request::AllowPlugin{plugin.id, true}}
            ));
        }
        if (!plugin.error.empty()) {
            menu.push_back(heading("    " + plugin.error));
        }
    }
    return with_mnemonics(std::move(menu));
}

MenuItems monitors_menu(const MenuState& state) {
    const auto allowed = std::ranges::count(state.monitors, true, &MonitorState::allowed);
    MenuItems menu;
    for (const MonitorState& monitor : state.monitors) {
        menu.push_back(ticked(
            monitor.text,
            monitor.allowed,
            Request{request::SetMonitor{monitor.id, !monitor.allowed}}
        ));
        // Pets must be somewhere.
        menu.back().enabled = !(monitor.allowed && allowed == 1);
    }
    return with_mnemonics(std::move(menu));
}

MenuItems open_menu() {
    return {
        item("&Config", DesktopCommand{desktop_command::OpenConfig{}}),
        item("&Scripts folder", DesktopCommand{desktop_command::OpenScripts{}}),
        item("&Log", DesktopCommand{desktop_command::OpenLog{}}),
    };
}

MenuItem hide_or_show(const MenuState& state) {
    if (!state.hidden) {
        return submenu("&Hide", hide_menu(state));
    }
    const std::string until =
        state.hidden_until.empty() ? "" : fmt::format(" (hidden until {})", state.hidden_until);
    return item("S&how" + until, Request{request::Show{}});
}

bool is_near(double a, double b) {
    return a > b * 0.99 && a < b * 1.01;
}

}  // namespace

MenuItems tray_menu(const MenuState& state) {
    MenuItems menu;
    if (!state.problem.empty()) {
        menu = with_mnemonics({heading(state.problem)});
        menu.push_back(line());
    }
    menu.push_back(submenu("&Spawn", kinds_menu(state)));
    for (MenuItem& verb : MenuItems{
             item("&Gather", Request{request::Gather{}}),
             item("&Fling all", Request{request::FlingAll{}}),
             item("&Reset all", Request{request::ResetAll{}}),
             item("Re&move all", Request{request::RemoveAll{}}),
         }) {
        verb.enabled = state.pets != 0;
        menu.push_back(std::move(verb));
    }
    menu.push_back(line());
    menu.push_back(ticked("&Pause", state.paused, Request{request::SetPaused{!state.paused}}));
    menu.push_back(hide_or_show(state));
    menu.push_back(ticked("Qui&et", state.quiet, Request{request::SetQuiet{!state.quiet}}));
    menu.push_back(ticked(
        "Clic&ks go through",
        state.click_through,
        Request{request::SetClickThrough{!state.click_through}}
    ));
    menu.push_back(line());
    menu.push_back(submenu("S&cripts", scripts_menu(state)));
    if (!state.plugins.empty()) {
        menu.push_back(submenu("P&lugins", plugins_menu(state)));
    }
    menu.push_back(submenu("Mo&nitors", monitors_menu(state)));
    menu.push_back(submenu("&Open", open_menu()));
    menu.push_back(line());
    if (state.autostart) {
        menu.push_back(ticked(
            "Start with &Windows",
            *state.autostart,
            DesktopCommand{desktop_command::SetAutostart{!*state.autostart}}
        ));
    }
    menu.push_back(item("&About hyrax", DesktopCommand{desktop_command::ShowAbout{}}));
    menu.push_back(item("&Quit", Request{request::Quit{}}));
    return menu;
}

MenuItems pet_menu(const PetMenuState& state) {
    MenuItems menu;
    menu.push_back(item("&Stop", Request{request::StopPet{state.pet}}));
    menu.push_back(item("&Reset", Request{request::ResetPet{state.pet}}));
    MenuItems scales;
    for (const double scale : menu_scales) {
        scales.push_back(ticked(
            fmt::format("{} %", std::lround(scale * 100.0)),
            is_near(state.scale, scale),
            Request{request::SetScale{state.pet, scale}}
        ));
    }
    menu.push_back(submenu("S&cale", with_mnemonics(std::move(scales))));
    menu.push_back(line());
    menu.push_back(item("Re&move", Request{request::RemovePet{state.pet}}));
    menu.push_back(item("Remove &others", Request{request::RemoveOthers{state.pet}}));
    menu.back().enabled = state.others != 0;
    return menu;
}

double scale_after(double scale, int steps) {
    constexpr int count = static_cast<int>(std::size(menu_scales));
    int nearest = 0;
    for (int i = 1; i < count; ++i) {
        if (std::fabs(menu_scales[i] - scale) < std::fabs(menu_scales[nearest] - scale)) {
            nearest = i;
        }
    }
    return menu_scales[std::clamp(nearest + std::clamp(steps, -count, count), 0, count - 1)];
}

std::string shortened_text(std::string_view utf8, std::size_t most) {
    const auto begins = [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
    };
    std::size_t characters = 0;
    std::size_t last = 0;  // Where the last character that may stay begins.
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        if (begins(utf8[i]) && ++characters == most) {
            last = i;
        }
    }
    return characters <= most ? std::string(utf8)
                              : std::string(utf8.substr(0, last)) + "\xE2\x80\xA6";
}

std::string monitor_text(std::size_t number, const Monitor& monitor) {
    return fmt::format(
        "{}: {} x {}{}",
        number,
        monitor.bounds.width,
        monitor.bounds.height,
        monitor.primary ? ", primary" : ""
    );
}

}  // namespace hyrax
