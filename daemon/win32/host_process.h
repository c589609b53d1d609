// SPDX-License-Identifier: MIT
// What a process finds when ChildProcess has started it to be a script host.
#pragma once

#include "daemon/core/result.h"
#include "daemon/core/script_link.h"
#include "daemon/core/script_pulse.h"
#include "daemon/win32/handle.h"

#include <memory>
#include <string>

namespace hyrax::win32 {

class HostProcess final : public ScriptLink {
public:
    /// The handles' numbers as they stand on the command line. What confines the process was done
    /// by the daemon before it ran.
    [[nodiscard]] static Result<std::unique_ptr<HostProcess>> settle_in(
        const std::string& wire, const std::string& pulse
    );

    std::size_t read(std::span<std::byte> into) override;
    bool write(std::span<const std::byte> bytes) override;

    /// In memory that the daemon sees, too.
    ScriptPulse& pulse() { return *pulse_; }

private:
    HostProcess(HANDLE wire, ScriptPulse& pulse) : wire_(wire), pulse_(&pulse) {}

    KernelObject wire_;
    ScriptPulse* pulse_;  // Mapped until the process ends.
};

}  // namespace hyrax::win32
