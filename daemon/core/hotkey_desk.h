// SPDX-License-Identifier: MIT
// Who has which hotkey: the user or a script. Scripts name theirs by numbers of their own, the
// desktop by others.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/core/key_combination.h"
#include "daemon/core/script_port.h"
#include "daemon/core/user_hotkeys.h"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hyrax {

/// What is to be done when a hotkey is pressed.
using HotkeyTask = std::variant<UserHotkey, PressedHotkey>;

/// Whoever holds a hotkey here is loaded, and what nobody holds the desktop has been given back.
class HotkeyDesk {
public:
    static constexpr std::size_t most = 64;              ///< Of all scripts, at a time.
    static constexpr std::size_t most_of_a_script = 16;  ///< At a time.

    /// From now on the user has these and no others. A script that has one of them loses it. What
    /// cannot be had is told in the log, and tried again by the next call.
    void use(Desktop& desktop, const UserHotkeys& wishes);
    /// Takes a hotkey for a script that is loaded, or gives one back. What cannot be had is told in
    /// the log, once as long as the script stays loaded.
    void obey(Desktop& desktop, const command::Hotkey& wish);
    /// Only these are still loaded.
    void keep(Desktop& desktop, const std::vector<ScriptSource>& scripts);
    /// No script's state is left: what they had taken is given back.
    void give_back_scripts(Desktop& desktop);
    void give_back_all(Desktop& desktop);

    /// What the desktop's hotkey is for; nothing if it has just been given back.
    std::optional<HotkeyTask> task(HotkeyId id) const;

private:
    struct Taken {
        HotkeyId id = 0;
        HotkeyTask task;
        KeyCombination keys;

        const PressedHotkey* of_script() const { return std::get_if<PressedHotkey>(&task); }
        const UserHotkey* of_user() const { return std::get_if<UserHotkey>(&task); }
        std::string holder() const;  ///< For messages.
    };

    Result<void> take(Desktop& desktop, const command::Hotkey& wish);
    Result<void> take(Desktop& desktop, const KeyCombination& keys, HotkeyTask task);
    HotkeyId free_id();
    template <typename Condition>
    void give_back_if(Desktop& desktop, Condition condition);

    std::vector<Taken> taken_;
    std::set<std::pair<std::string, std::string>> refused_;  ///< Scripts and keys, as told.
    HotkeyId last_id_ = 0;
};

}  // namespace hyrax
