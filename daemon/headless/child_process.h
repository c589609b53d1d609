// SPDX-License-Identifier: MIT
// A script host's process on Linux, seen from the daemon. HostProcess is its other side.
#pragma once

#include "daemon/core/script_channel.h"
#include "daemon/headless/file_descriptor.h"

#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace hyrax {

class ChildProcess final : public ScriptChannel {
public:
    /// `program` is started with script_host_switch; by default this program once more, even if
    /// its file has been replaced meanwhile.
    explicit ChildProcess(std::filesystem::path program = "/proc/self/exe");
    /// Ends the process and waits until it is gone.
    ~ChildProcess() override;

    Result<void> start() override;
    void send(std::span<const std::byte> bytes) override;
    void receive(std::vector<std::byte>& bytes) override;
    std::optional<End> ended() override;
    bool wait(std::chrono::milliseconds patience) override;
    void kill() override;
    const ScriptPulse& pulse() const override;
    std::optional<Ticks> processor_time() override;

    /// 0: no process.
    pid_t id() const { return pid_; }
    /// Becomes readable when there is something to hear; -1: no process.
    int wire() const { return wire_.raw(); }

private:
    struct Unmap {
        void operator()(ScriptPulse* pulse) const;
    };

    void flush();
    void reap();

    std::filesystem::path program_;
    FileDescriptor wire_;
    std::unique_ptr<ScriptPulse, Unmap> pulse_;
    pid_t pid_ = 0;
    std::vector<pid_t> dying_;  // Killed, and still to be reaped.
    std::vector<std::byte> unsent_;
    std::size_t sent_ = 0;  // Bytes at the front of unsent_ that are on their way.
    Ticks used_ = 0;
};

}  // namespace hyrax
