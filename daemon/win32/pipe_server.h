// SPDX-License-Identifier: MIT
// The daemon's end of the control channel on Windows: a named pipe that only its user can open.
#pragma once

#include "daemon/core/client_session.h"
#include "daemon/core/desktop.h"
#include "daemon/core/result.h"
#include "daemon/win32/handle.h"
#include "physics/ticks.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax::win32 {

/// Never blocks. Its owner waits for event() and then calls serve(). All instances are made at the
/// start and used again, so that the name is never free for another program to take.
class PipeServer {
public:
    static constexpr DWORD most_clients = 4;  ///< Others wait until one has gone.

    /// Fails where the pipe exists already, whoever made it, and where it cannot be protected.
    [[nodiscard]] static Result<std::unique_ptr<PipeServer>> open(const std::wstring& name);
    ~PipeServer();
    PipeServer(const PipeServer&) = delete;
    PipeServer& operator=(const PipeServer&) = delete;

    HANDLE event() const { return ready_.raw(); }
    /// When serve() is worth calling though nothing is signalled.
    Ticks due() const;
    /// Takes what clients have sent and sends what they take; what they ask goes into the inbox.
    void serve(Ticks now, std::vector<Input>& inbox);
    void answer(ClientId client, std::string_view text, Answer which, Ticks now);

private:
    struct Instance;  ///< One client at a time, and what the system writes to meanwhile.

    PipeServer();
    bool step(Instance& instance, Ticks now, std::vector<Input>& inbox);
    void listen(Instance& instance) const;
    void begin(Instance& instance, Ticks now);
    void end(Instance& instance, std::vector<Input>& inbox);

    KernelObject ready_;
    std::vector<std::unique_ptr<Instance>> instances_;
    ClientId next_id_ = 1;
};

}  // namespace hyrax::win32
