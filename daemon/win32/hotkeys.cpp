// SPDX-License-Identifier: MIT
#include "daemon/win32/hotkeys.h"

#include "daemon/win32/text.h"

#include <array>
#include <utility>

namespace hyrax::win32 {
namespace {

// From Key::space on.
constexpr std::array<UINT, 14> named_keys{
    VK_SPACE,
    VK_TAB,
    VK_RETURN,
    VK_ESCAPE,
    VK_INSERT,
    VK_DELETE,
    VK_HOME,
    VK_END,
    VK_PRIOR,
    VK_NEXT,
    VK_LEFT,
    VK_RIGHT,
    VK_UP,
    VK_DOWN
};

UINT modifiers_of(const KeyCombination& keys) {
    return MOD_NOREPEAT | (keys.ctrl ? MOD_CONTROL : 0U) | (keys.alt ? MOD_ALT : 0U) |
           (keys.shift ? MOD_SHIFT : 0U) | (keys.win ? MOD_WIN : 0U);
}

}  // namespace

UINT virtual_key(Key key) {
    const UINT code = std::to_underlying(key);
    if (key >= Key::space) {
        return named_keys.at(code - std::to_underlying(Key::space));
    }
    if (key >= Key::f1) {
        return VK_F1 + (code - std::to_underlying(Key::f1));
    }
    // Digits and capital letters are their own codes.
    return code >= 'a' && code <= 'z' ? code - 'a' + 'A' : code;
}

Hotkeys::~Hotkeys() {
    for (const HotkeyId id : taken_) {
        ::UnregisterHotKey(owner_, id);
    }
}

Result<void> Hotkeys::take(HotkeyId id, const KeyCombination& keys) {
    if (::RegisterHotKey(owner_, id, modifiers_of(keys), virtual_key(keys.key)) == 0) {
        const DWORD code = ::GetLastError();
        return code == ERROR_HOTKEY_ALREADY_REGISTERED
                   ? failure("another program, or Windows itself, has it")
                   : std::unexpected(system_error("cannot be had", code));
    }
    taken_.insert(id);
    return {};
}

void Hotkeys::give_back(HotkeyId id) {
    if (taken_.erase(id) != 0) {
        ::UnregisterHotKey(owner_, id);
    }
}

}  // namespace hyrax::win32
