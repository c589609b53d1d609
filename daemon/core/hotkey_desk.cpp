// SPDX-License-Identifier: MIT
#include "daemon/core/hotkey_desk.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

namespace hyrax {
namespace {

// A script may ask for ever.
constexpr std::size_t most_told = 64;

}  // namespace

void HotkeyDesk::obey(Desktop& desktop, const command::Hotkey& wish) {
    if (wish.keys.empty()) {
        give_back_if(desktop, [&wish](const Taken& taken) {
            return taken.script == wish.script && taken.number == wish.id;
        });
        return;
    }
    const Result<void> done = take(desktop, wish);
    if (!done && refused_.size() < most_told && refused_.emplace(wish.script, wish.keys).second) {
        spdlog::warn("{}: hotkey {}: {}", wish.script, wish.keys, done.error().message);
    }
}

Result<void> HotkeyDesk::take(Desktop& desktop, const command::Hotkey& wish) {
    const Result<KeyCombination> keys = parse_keys(wish.keys);
    if (!keys) {
        return std::unexpected(keys.error());
    }
    const auto other = std::ranges::find(taken_, *keys, &Taken::keys);
    if (other != taken_.end()) {
        return failure(fmt::format("{} has it already", other->script));
    }
    const auto own = std::ranges::count(taken_, wish.script, &Taken::script);
    if (own >= static_cast<std::ptrdiff_t>(most_of_a_script)) {
        return failure(fmt::format("a script can have {} at a time", most_of_a_script));
    }
    if (taken_.size() >= most) {
        return failure(fmt::format("all scripts together can have {} at a time", most));
    }
    const HotkeyId id = free_id();
    const Result<void> taken = desktop.take_hotkey(id, *keys);
    if (taken) {
        taken_.push_back({id, wish.script, wish.id, *keys});
    }
    return taken;
}

// Not the one that was given back last: its last press may still be on the way.
HotkeyId HotkeyDesk::free_id() {
    do {
        last_id_ = last_id_ < last_hotkey_id ? static_cast<HotkeyId>(last_id_ + 1) : HotkeyId{1};
    } while (std::ranges::find(taken_, last_id_, &Taken::id) != taken_.end());
    return last_id_;
}

template <typename Condition>
void HotkeyDesk::give_back_if(Desktop& desktop, Condition condition) {
    std::erase_if(taken_, [&](const Taken& taken) {
        const bool goes = condition(taken);
        if (goes) {
            desktop.give_back_hotkey(taken.id);
        }
        return goes;
    });
}

void HotkeyDesk::keep(Desktop& desktop, const std::vector<ScriptSource>& scripts) {
    const auto is_gone = [&scripts](const std::string& name) {
        return std::ranges::find(scripts, name, &ScriptSource::name) == scripts.end();
    };
    give_back_if(desktop, [&](const Taken& taken) { return is_gone(taken.script); });
    refused_.clear();
}

void HotkeyDesk::clear(Desktop& desktop) {
    give_back_if(desktop, [](const Taken&) { return true; });
}

std::optional<PressedHotkey> HotkeyDesk::holder(HotkeyId id) const {
    const auto found = std::ranges::find(taken_, id, &Taken::id);
    if (found == taken_.end()) {
        return std::nullopt;
    }
    return PressedHotkey{found->script, found->number};
}

}  // namespace hyrax
