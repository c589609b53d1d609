// SPDX-License-Identifier: MIT
// Which script has which hotkey. Scripts name theirs by numbers of their own, the desktop by
// others.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/core/key_combination.h"
#include "daemon/core/script_port.h"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hyrax {

/// Whoever holds a hotkey here is loaded, and what nobody holds the desktop has been given back.
class HotkeyDesk {
public:
    static constexpr std::size_t most = 64;              ///< At a time.
    static constexpr std::size_t most_of_a_script = 16;  ///< At a time.

    /// Takes a hotkey for a script that is loaded, or gives one back. What cannot be had is told in
    /// the log, once as long as the script stays loaded.
    void obey(Desktop& desktop, const command::Hotkey& wish);
    /// Only these are still loaded.
    void keep(Desktop& desktop, const std::vector<ScriptSource>& scripts);
    /// Nobody's state is left: what they had taken is given back.
    void clear(Desktop& desktop);

    /// What a script is to be told of the desktop's hotkey; nothing if it has just been given back.
    std::optional<PressedHotkey> holder(HotkeyId id) const;

private:
    struct Taken {
        HotkeyId id = 0;
        std::string script;
        std::uint64_t number = 0;  ///< As the script counts.
        KeyCombination keys;
    };

    Result<void> take(Desktop& desktop, const command::Hotkey& wish);
    HotkeyId free_id();
    template <typename Condition>
    void give_back_if(Desktop& desktop, Condition condition);

    std::vector<Taken> taken_;
    std::set<std::pair<std::string, std::string>> refused_;  ///< Scripts and keys, as told.
    HotkeyId last_id_ = 0;
};

}  // namespace hyrax
