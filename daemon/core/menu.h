// SPDX-License-Identifier: MIT
// The menus of the tray icon and of a pet, as data. Pure: a state comes in, items come out.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/request.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hyrax {

/// What the desktop does by itself when the user asks for it.
namespace desktop_command {
struct OpenConfig {
    bool operator==(const OpenConfig&) const = default;
};
struct OpenScripts {
    bool operator==(const OpenScripts&) const = default;
};
struct OpenLog {
    bool operator==(const OpenLog&) const = default;
};
struct ShowAbout {
    bool operator==(const ShowAbout&) const = default;
};
/// Whether the program starts with the user's session.
struct SetAutostart {
    bool on = false;
    bool operator==(const SetAutostart&) const = default;
};
}  // namespace desktop_command

using DesktopCommand = std::variant<
    desktop_command::OpenConfig,
    desktop_command::OpenScripts,
    desktop_command::OpenLog,
    desktop_command::ShowAbout,
    desktop_command::SetAutostart>;

/// What choosing an item does; the first for lines, headings and submenus.
using MenuAction = std::variant<std::monostate, Request, DesktopCommand>;

struct MenuItem {
    std::string text;  ///< UTF-8; & stands before the mnemonic, && is one &. Empty: a line.
    MenuAction action{};
    bool checked = false;
    bool enabled = true;
    std::vector<MenuItem> children{};

    bool is_line() const { return text.empty(); }
};

using MenuItems = std::vector<MenuItem>;

struct ScriptState {
    std::string name;
    bool on = true;
    std::string error{};  ///< The latest since it was loaded; empty: none.
};

struct PluginMenuState {
    std::string id;
    std::string name;
    bool on = false;
    std::vector<std::string> asks{};  ///< Permissions that it waits for.
    std::string error{};              ///< Empty: none.
};

struct MonitorState {
    std::string id;    ///< identity()
    std::string text;  ///< For people.
    bool allowed = true;
};

/// Everything that the tray's menu shows.
struct MenuState {
    std::vector<std::string> kinds{};
    std::size_t pets = 0;
    bool paused = false;
    bool hidden = false;
    std::string hidden_until{};               ///< For people; empty: until the user says so.
    std::int64_t seconds_until_tomorrow = 0;  ///< To six in the morning.
    bool quiet = false;
    bool click_through = false;
    std::vector<ScriptState> scripts{};
    std::vector<PluginMenuState> plugins{};
    std::vector<MonitorState> monitors{};
    std::optional<bool> autostart{};  ///< None: this desktop knows no such thing.
    std::string problem{};            ///< Empty: none.
};

struct PetMenuState {
    PetId pet;
    double scale = 1.0;
    std::size_t others = 0;  ///< Pets besides this one.
};

MenuItems tray_menu(const MenuState& state);
MenuItems pet_menu(const PetMenuState& state);

/// The sizes that the pet's menu and the wheel offer.
inline constexpr double menu_scales[] = {0.5, 0.75, 1.0, 1.5, 2.0};
/// The offered size that lies `steps` above the present one, at most the largest or smallest.
double scale_after(double scale, int steps);

/// At most `most` characters, the last one an ellipsis where something was cut.
std::string shortened_text(std::string_view utf8, std::size_t most);
/// "1: 1920 x 1080, primary"
std::string monitor_text(std::size_t number, const Monitor& monitor);

}  // namespace hyrax
