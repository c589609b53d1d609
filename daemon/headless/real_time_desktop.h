// SPDX-License-Identifier: MIT
// A desktop without windows on the real clock: the daemon waits and draws as it would on a screen.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/core/sprite_worker.h"
#include "daemon/core/statistics.h"
#include "daemon/headless/control_socket.h"
#include "daemon/headless/file_descriptor.h"
#include "daemon/headless/memory_overlay.h"

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace hyrax {

/// SIGINT and SIGTERM, blocked for this thread and read from a descriptor; SIGUSR1, too.
class SignalWatch {
public:
    SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;
    ~SignalWatch();

    /// Becomes readable with a signal; -1 if the system gave none.
    int descriptor() const { return descriptor_; }
    /// The number of the next signal that has come, 0 without one.
    int next() const;

private:
    int descriptor_;
};

/// Quits after `span`, and on SIGINT or SIGTERM.
class RealTimeDesktop : public Desktop {
public:
    /// `span` may be `never`. Without a control channel nobody can ask it anything.
    RealTimeDesktop(
        std::vector<Monitor> monitors, Ticks span, std::optional<ControlSocket> control = {}
    );

    /// Called from wait() for each SIGUSR1.
    void on_statistics_request(std::function<void()> tell) { tell_ = std::move(tell); }

    /// Scripts in another process have something to say when this descriptor can be read; asked for
    /// before each sleep, negative: nobody has.
    void listen_to_scripts(std::function<int()> wire) { script_wire_ = std::move(wire); }

    Ticks now() override;
    std::vector<Input> wait(Ticks deadline) override;
    void present(const Frame& frame) override;
    /// There is one renderer here.
    void use_renderer(Renderer) override {}
    std::vector<Monitor> monitors() override { return monitors_; }
    void show_status(const Status&) override {}
    void answer(ClientId client, std::string_view text, Answer which) override;
    void read_aside(std::unique_ptr<SpriteReading> reading) override;
    std::unique_ptr<SpriteReading> sprites_read() override { return worker_.take(); }

    DesktopCounters counters() const;

private:
    void sleep_until(Ticks due, std::vector<Input>& inbox);
    bool told_to_quit();

    SignalWatch signals_;
    std::vector<Monitor> monitors_;
    Ticks end_;
    std::optional<ControlSocket> control_;
    std::function<void()> tell_;
    std::function<int()> script_wire_;
    MemoryOverlay overlay_;
    DesktopCounters counters_;
    FileDescriptor sprites_event_;  // Becomes readable when sprite sets have been read.
    SpriteWorker worker_;
};

}  // namespace hyrax
