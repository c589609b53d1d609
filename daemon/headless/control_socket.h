// SPDX-License-Identifier: MIT
// The daemon's end of the control channel on POSIX: a Unix socket that only its user can reach.
#pragma once

#include "daemon/core/client_session.h"
#include "daemon/core/desktop.h"
#include "daemon/core/result.h"
#include "daemon/headless/file_descriptor.h"
#include "physics/ticks.h"

#include <poll.h>

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace hyrax {

/// Never blocks. Its owner waits for what poll_for() names and then calls serve().
class ControlSocket {
public:
    static constexpr std::size_t most_clients = 4;  ///< Others wait until one has gone.

    /// For the profile's folder. Fails while another daemon serves it; takes the place of one that
    /// has crashed.
    [[nodiscard]] static Result<ControlSocket> open(const std::filesystem::path& profile);
    ControlSocket(ControlSocket&&) = default;
    ControlSocket& operator=(ControlSocket&&) = delete;
    /// Removes the socket.
    ~ControlSocket();

    void poll_for(std::vector<pollfd>& entries) const;
    /// When serve() is worth calling though nothing has happened.
    Ticks due() const;
    /// Takes what clients have sent and sends what they take; what they ask goes into the inbox.
    void serve(Ticks now, std::vector<Input>& inbox);
    void answer(ClientId client, std::string_view text, Answer which, Ticks now);

private:
    struct Client {
        FileDescriptor socket;
        ClientSession session;
    };

    ControlSocket(FileDescriptor lock, FileDescriptor listener, std::filesystem::path path);
    void accept_clients(Ticks now);
    static void receive(Client& client);
    static void send(Client& client, Ticks now);

    FileDescriptor lock_;
    FileDescriptor listener_;
    std::filesystem::path path_;
    std::vector<Client> clients_;
    ClientId next_id_ = 1;
};

}  // namespace hyrax
