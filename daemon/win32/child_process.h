// SPDX-License-Identifier: MIT
// A script host's process on Windows, seen from the daemon. HostProcess is its other side.
#pragma once

#include "daemon/core/script_channel.h"
#include "daemon/win32/handle.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace hyrax::win32 {

/// The process has a restricted token of low integrity, no privileges, and two inherited handles:
/// the wire and the pulse. A job ends it together with the daemon, keeps it from starting others
/// and from the user interface, and caps its memory. It begins to run once all that holds.
class ChildProcess final : public ScriptChannel {
public:
    static constexpr std::size_t most_memory = std::size_t{1} << 30U;  ///< [bytes]

    /// `program` is started with script_host_switch.
    explicit ChildProcess(std::filesystem::path program);
    ~ChildProcess() override;

    Result<void> start() override;
    void send(std::span<const std::byte> bytes) override;
    void receive(std::vector<std::byte>& bytes) override;
    std::optional<End> ended() override;
    bool wait(std::chrono::milliseconds patience) override;
    void kill() override;
    const ScriptPulse& pulse() const override;
    /// Nothing under Wine, which tells zeros of other processes.
    std::optional<Ticks> processor_time() override;

    /// Signalled while there is something to receive; the same one for ever.
    HANDLE event() const { return heard_.raw(); }
    /// Null without a process.
    HANDLE process() const { return process_.raw(); }
    HANDLE job() const { return job_.raw(); }

private:
    struct Unmap {
        void operator()(ScriptPulse* pulse) const { ::UnmapViewOfFile(pulse); }
    };

    void flush();
    void forget_transfers();

    std::filesystem::path program_;
    KernelObject heard_;
    KernelObject written_;
    KernelObject wire_;
    KernelObject job_;
    KernelObject process_;
    std::unique_ptr<ScriptPulse, Unmap> pulse_;

    // Transfers under way own their buffers until they are done.
    OVERLAPPED read_{};
    bool reading_ = false;
    std::vector<std::byte> read_buffer_;
    OVERLAPPED write_{};
    bool writing_ = false;
    std::vector<std::byte> write_buffer_;
    std::vector<std::byte> unsent_;
    bool broken_ = false;
};

}  // namespace hyrax::win32
