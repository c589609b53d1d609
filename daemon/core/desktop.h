// SPDX-License-Identifier: MIT
// The seam between the daemon and the machine: everything outside comes in and goes out here.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/event.h"
#include "daemon/core/facts.h"
#include "daemon/core/frame.h"
#include "daemon/core/key_combination.h"
#include "daemon/core/ledges.h"
#include "daemon/core/menu.h"
#include "daemon/core/request.h"
#include "daemon/core/result.h"
#include "daemon/core/sprite_reading.h"
#include "daemon/core/topmost.h"
#include "daemon/core/wall_time.h"
#include "physics/ticks.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hyrax {

/// A client of the control channel, while it stays; no two have the same.
using ClientId = std::uint64_t;

/// A hotkey, while it is taken: from 1 to last_hotkey_id, as Windows lets programs count them.
using HotkeyId = std::uint16_t;
inline constexpr HotkeyId last_hotkey_id = 0xBFFF;

namespace input {
/// The pointer, in virtual desktop pixels. Pressed comes only for points on a pet's pixels.
struct Pressed {
    Point at;
    Button button = Button::left;
    Ticks time = 0;
};
struct Moved {
    Point at;
    Ticks time = 0;
};
struct Released {
    Point at;
    Button button = Button::left;
    Ticks time = 0;
};
/// The wheel was turned over a pet's pixels, with Ctrl held down.
struct Turned {
    Point at;
    int steps = 0;  ///< Notches, away from the user positive.
};
/// The user asks for the tray's menu: the answer is Desktop::show_menu() at the same place.
struct MenuWanted {
    Point anchor;
    std::optional<bool> autostart{};  ///< Whether the program starts with the session, if known.
};
/// The system took the pointer away: a held pet drops where it is.
struct PointerLost {};
/// Screens came, went or changed, or so did a taskbar.
struct MonitorsChanged {};
/// What was presented is not seen any more: the frame is to be presented once more, changed or not.
struct FrameLost {};
/// A file of the profile may have changed: config.json, a script, a sprite set.
struct FilesChanged {};
/// Sprite sets have been read: see Desktop::read_aside().
struct SpritesRead {};
/// Who is in front, or how the machine is, has changed.
/// `time`: when it was noticed, which may be before the machine slept.
struct FactsChanged {
    Facts facts;
    Ticks time = 0;
};
/// Scripts in a process of their own have said something, or have ended.
struct ScriptsHeard {};
/// Windows of other programs came, went, moved or changed their order.
struct WindowsChanged {};
/// A hotkey that was taken was pressed, whoever has the keyboard.
struct HotkeyPressed {
    HotkeyId id = 0;
};
/// A client of the control channel asks something, in a text that is not checked yet.
struct Asked {
    ClientId client = 0;
    std::string text;
};
/// A client that more answers were meant for is gone.
struct Left {
    ClientId client = 0;
};
}  // namespace input

using Input = std::variant<
    input::Pressed,
    input::Moved,
    input::Released,
    input::Turned,
    input::MenuWanted,
    input::PointerLost,
    input::MonitorsChanged,
    input::FrameLost,
    input::FilesChanged,
    input::SpritesRead,
    input::FactsChanged,
    input::ScriptsHeard,
    input::WindowsChanged,
    input::HotkeyPressed,
    input::Asked,
    input::Left,
    Request>;

/// What the daemon wants to hear of other programs' windows.
struct WindowInterest {
    bool any = false;  ///< Changes come as WindowsChanged.
    /// Pets stand on these, or will in a moment: their every move counts.
    std::vector<std::uint64_t> underfoot;
    bool operator==(const WindowInterest&) const = default;
};

/// What the user sees of the daemon's state without any window: the tray's tip and menu.
struct Status {
    std::size_t pets = 0;
    bool paused = false;
    bool hidden = false;
    bool quiet = false;
    bool click_through = false;
    std::string problem{};  ///< One line about what is wrong; empty when nothing is.
    std::string note{};     ///< One line on why pets are not as usual; else empty.
    bool operator==(const Status&) const = default;
};

/// What the daemon needs to be told of who is in front.
enum class Watch {
    off,
    events,   ///< What the system tells by itself: no timer.
    closely,  ///< And a look every now and then, for what it does not tell.
};

/// How the desktop has to behave, apart from what it shows.
struct Conduct {
    Watch front = Watch::off;
    bool name_programs = false;      ///< FrontWindow::program is wanted.
    bool hide_from_capture = false;  ///< Screenshots and recordings must not show the pets.
    bool let_go = false;             ///< A pressed button is to be forgotten: no pet may be held.
    bool click_through = false;      ///< The mouse reaches what lies below the pets.
    bool resting = true;             ///< Nothing moves: little of the processor is needed.
    bool dragging = false;           ///< The user holds a pet, and sees each delay.
    Layer layer = Layer::above_taskbar;
    bool operator==(const Conduct&) const = default;
};
/// Whether a client of the control channel hears more after an answer.
enum class Answer : std::uint8_t { last, more };

/// A machine with screens, a pointer and a clock. One thread.
class Desktop {
public:
    Desktop() = default;
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;
    virtual ~Desktop() = default;

    /// Monotonic.
    virtual Ticks now() = 0;
    /// Sleeps until there is input or the deadline has come; `never` waits for input alone.
    virtual std::vector<Input> wait(Ticks deadline) = 0;
    /// Shows the frame, or as much of it as differs from the one before. May get the same again, to
    /// show all of it that is not seen. Only this call may read the frame's images: they go with
    /// their edition.
    virtual void present(const Frame& frame) = 0;
    /// Who draws the frames from now on; the first one, too.
    virtual void use_renderer(Renderer renderer) = 0;
    /// May be empty for a moment while screens change.
    virtual std::vector<Monitor> monitors() = 0;
    /// The topmost first. A desktop without windows need not know of them.
    virtual std::vector<DesktopWindow> windows() { return {}; }
    /// Nothing is of interest at first.
    virtual void watch_windows(const WindowInterest&) {}
    /// Called when the status has changed.
    virtual void show_status(const Status& status) = 0;
    /// Called when the conduct has changed.
    virtual void follow(const Conduct&) {}

    /// Shows a menu there, some time later and never from inside this call. A chosen Request comes
    /// as input; the desktop carries out its own commands.
    virtual void show_menu(MenuItems, Point) {}
    /// A line of text, once, for somebody who has never seen the program.
    virtual void greet(const std::string&) {}
    /// A script tells the user something. The system may have reasons not to show it.
    virtual void notify(const std::string& /*title*/, const std::string& /*text*/) {}
    /// From now on the keys come as HotkeyPressed, and reach nobody else. `id` must be free. Fails
    /// where another program has them.
    [[nodiscard]] virtual Result<void> take_hotkey(HotkeyId /*id*/, const KeyCombination&) {
        return failure("there is no keyboard here");
    }
    virtual void give_back_hotkey(HotkeyId /*id*/) {}
    /// Runs it, on a thread of its own where frames must not wait. SpritesRead comes when it is
    /// done, and then sprites_read() gives it back, once. One at a time.
    virtual void read_aside(std::unique_ptr<SpriteReading> reading) = 0;
    virtual std::unique_ptr<SpriteReading> sprites_read() = 0;
    /// Where the pointer is now, if there is one [virtual desktop, physical px].
    virtual std::optional<Point> pointer() { return std::nullopt; }
    /// UTC where the desktop knows no other.
    virtual WallTime wall_time() {
        const auto now = std::chrono::system_clock::now().time_since_epoch();
        return {std::chrono::duration_cast<std::chrono::seconds>(now).count(), 0};
    }
    /// Sends a text to a client of the control channel, without waiting for it to be read. A client
    /// that has gone, or that reads too slowly, does not get it.
    virtual void answer(ClientId, std::string_view, Answer) {}
};

}  // namespace hyrax
