// SPDX-License-Identifier: MIT
// A desktop without a screen on the real clock, for a daemon that is spoken to by the control
// channel alone.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/core/result.h"
#include "daemon/headless/control_socket.h"
#include "daemon/headless/file_descriptor.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace hyrax {

/// Ends on SIGINT and SIGTERM, which the process gets in no other way any more.
class RealTimeDesktop final : public Desktop {
public:
    /// Quits when `span` is over; `never` is allowed.
    [[nodiscard]] static Result<std::unique_ptr<RealTimeDesktop>> create(
        std::vector<Monitor> monitors, Ticks span, ControlSocket control
    );

    Ticks now() override;
    std::vector<Input> wait(Ticks deadline) override;
    void present(const Frame& frame) override;
    std::vector<Monitor> monitors() override { return monitors_; }
    void show_status(const Status&) override {}
    void answer(ClientId client, std::string_view text, Answer which) override;

    const Frame& last_frame() const { return frame_; }
    std::uint64_t presents() const { return presents_; }

private:
    RealTimeDesktop(std::vector<Monitor> monitors, FileDescriptor signals, ControlSocket control);
    void sleep_until(Ticks deadline);
    bool was_signalled() const;

    std::vector<Monitor> monitors_;
    FileDescriptor signals_;
    ControlSocket control_;
    Ticks end_ = never;
    Frame frame_;
    std::uint64_t presents_ = 0;
};

}  // namespace hyrax
