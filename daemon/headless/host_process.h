// SPDX-License-Identifier: MIT
// What a process finds when ChildProcess has started it to be a script host.
#pragma once

#include "daemon/core/result.h"
#include "daemon/core/script_link.h"
#include "daemon/core/script_pulse.h"

#include <memory>
#include <string>

namespace hyrax {

/// Fixed by the parent, which leaves no other open.
inline constexpr int wire_descriptor = 3;
inline constexpr int pulse_descriptor = 4;

class HostProcess final : public ScriptLink {
public:
    /// Takes over the descriptors, arranges to die with the parent, and confines the process for
    /// good. `parent` is its process id, as it stands on the command line.
    [[nodiscard]] static Result<std::unique_ptr<HostProcess>> settle_in(const std::string& parent);

    std::size_t read(std::span<std::byte> into) override;
    bool write(std::span<const std::byte> bytes) override;

    /// In memory that the parent sees, too.
    ScriptPulse& pulse() { return *pulse_; }

private:
    explicit HostProcess(ScriptPulse& pulse) : pulse_(&pulse) {}

    ScriptPulse* pulse_;  // Mapped until the process ends.
};

}  // namespace hyrax
