// SPDX-License-Identifier: MIT
#include "daemon/core/hotkey_desk.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace hyrax {
namespace {

// A script may ask for ever.
constexpr std::size_t most_told = 64;

}  // namespace

void HotkeyDesk::use(Desktop& desktop, const UserHotkeys& wishes) {
    give_back_if(desktop, [&wishes](const Taken& taken) {
        const UserHotkey* const own = taken.of_user();
        return own != nullptr && wishes[static_cast<std::size_t>(*own)] != taken.keys;
    });
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        const auto which = static_cast<UserHotkey>(i);
        const bool has = std::ranges::any_of(taken_, [which](const Taken& taken) {
            return taken.of_user() != nullptr && *taken.of_user() == which;
        });
        if (has || !wishes[i]) {
            continue;
        }
        give_back_if(desktop, [&](const Taken& taken) {
            const bool goes = taken.of_script() != nullptr && taken.keys == *wishes[i];
            if (goes) {
                spdlog::warn("{} loses {} to the user", taken.holder(), text_of(taken.keys));
            }
            return goes;
        });
        if (const Result<void> done = take(desktop, *wishes[i], which); !done) {
            spdlog::warn(
                "config.json: /hotkeys/{}: {}: {}",
                user_hotkey_names[i],
                text_of(*wishes[i]),
                done.error().message
            );
        }
    }
}

void HotkeyDesk::obey(Desktop& desktop, const command::Hotkey& wish) {
    if (wish.keys.empty()) {
        give_back_if(desktop, [&wish](const Taken& taken) {
            const PressedHotkey* const hotkey = taken.of_script();
            return hotkey != nullptr && hotkey->script == wish.script && hotkey->id == wish.id;
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
    std::size_t own = 0;
    std::size_t all = 0;
    for (const Taken& taken : taken_) {
        if (const PressedHotkey* const hotkey = taken.of_script()) {
            ++all;
            own += hotkey->script == wish.script ? 1U : 0U;
        }
    }
    if (own >= most_of_a_script) {
        return failure(fmt::format("a script can have {} at a time", most_of_a_script));
    }
    if (all >= most) {
        return failure(fmt::format("all scripts together can have {} at a time", most));
    }
    return take(desktop, *keys, PressedHotkey{wish.script, wish.id});
}

Result<void> HotkeyDesk::take(Desktop& desktop, const KeyCombination& keys, HotkeyTask task) {
    const auto other = std::ranges::find(taken_, keys, &Taken::keys);
    if (other != taken_.end()) {
        return failure(fmt::format("{} has it already", other->holder()));
    }
    const HotkeyId id = free_id();
    const Result<void> taken = desktop.take_hotkey(id, keys);
    if (taken) {
        taken_.push_back({id, std::move(task), keys});
    }
    return taken;
}

std::string HotkeyDesk::Taken::holder() const {
    if (const PressedHotkey* const hotkey = of_script()) {
        return hotkey->script;
    }
    return fmt::format("/hotkeys/{}", user_hotkey_names[static_cast<std::size_t>(*of_user())]);
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
    give_back_if(desktop, [&scripts](const Taken& taken) {
        const PressedHotkey* const hotkey = taken.of_script();
        return hotkey != nullptr &&
               std::ranges::find(scripts, hotkey->script, &ScriptSource::name) == scripts.end();
    });
    refused_.clear();
}

void HotkeyDesk::give_back_scripts(Desktop& desktop) {
    give_back_if(desktop, [](const Taken& taken) { return taken.of_script() != nullptr; });
}

void HotkeyDesk::give_back_all(Desktop& desktop) {
    give_back_if(desktop, [](const Taken&) { return true; });
}

std::optional<HotkeyTask> HotkeyDesk::task(HotkeyId id) const {
    const auto found = std::ranges::find(taken_, id, &Taken::id);
    return found != taken_.end() ? std::optional(found->task) : std::nullopt;
}

}  // namespace hyrax
