// SPDX-License-Identifier: MIT
// The seam between the daemon and the machine: everything outside comes in and goes out here.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/event.h"
#include "daemon/core/frame.h"
#include "daemon/core/request.h"
#include "physics/ticks.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hyrax {

/// A client of the control channel, while it stays; no two have the same.
using ClientId = std::uint64_t;

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
/// The system took the pointer away: a held pet drops where it is.
struct PointerLost {};
/// Screens came, went or changed, or so did a taskbar.
struct MonitorsChanged {};
/// A file of the profile may have changed: config.json, a script, a sprite set.
struct FilesChanged {};
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
    input::PointerLost,
    input::MonitorsChanged,
    input::FilesChanged,
    input::Asked,
    input::Left,
    Request>;

/// What the user sees of the daemon's state without any window: the tray's tip and menu.
struct Status {
    std::size_t pets = 0;
    bool paused = false;
    std::string problem;  ///< One line about what is wrong; empty when nothing is.
    bool operator==(const Status&) const = default;
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
    /// Shows the frame, or as much of it as differs from the one before. Its images stay as they
    /// are until the next call.
    virtual void present(const Frame& frame) = 0;
    /// May be empty for a moment while screens change.
    virtual std::vector<Monitor> monitors() = 0;
    /// Called when the status has changed.
    virtual void show_status(const Status& status) = 0;
    /// Sends a text to a client of the control channel, without waiting for it to be read. A client
    /// that has gone, or that reads too slowly, does not get it.
    virtual void answer(ClientId, std::string_view, Answer) {}
};

}  // namespace hyrax
