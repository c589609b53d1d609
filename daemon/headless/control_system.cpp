// SPDX-License-Identifier: MIT
// A client's end of the control channel on POSIX.
#include "daemon/control/connection.h"
#include "daemon/headless/control_path.h"
#include "daemon/headless/file_descriptor.h"
#include "daemon/headless/png_file.h"
#include "daemon/headless/socket_calls.h"
#include "daemon/headless/system_error.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <utility>

namespace hyrax {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

// The daemon takes a request at once, unless it is overrun with clients.
constexpr milliseconds sending_patience{5000};

// False when nothing has happened in time.
bool wait_for(int socket, short what, std::optional<milliseconds> patience) {
    pollfd entry{socket, what, 0};
    const int timeout = patience ? static_cast<int>(patience->count()) : -1;
    return ::poll(&entry, 1, timeout) > 0;
}

class SocketConnection final : public Connection {
public:
    explicit SocketConnection(FileDescriptor socket) : socket_(std::move(socket)) {}

    Result<void> write(std::string_view bytes) override {
        while (!bytes.empty()) {
            if (!wait_for(socket_.raw(), POLLOUT, sending_patience)) {
                return failure("hyrax does not listen");
            }
            const ssize_t sent = ::send(socket_.raw(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (sent < 0) {
                return system_failure("cannot send to hyrax");
            }
            bytes.remove_prefix(static_cast<std::size_t>(sent));
        }
        return {};
    }

    Result<std::string> read(std::size_t most, std::optional<milliseconds> patience) override {
        if (!wait_for(socket_.raw(), POLLIN, patience)) {
            return failure("hyrax does not answer");
        }
        std::string bytes(most, '\0');
        const ssize_t got = ::recv(socket_.raw(), bytes.data(), bytes.size(), 0);
        if (got < 0) {
            return system_failure("cannot hear hyrax");
        }
        bytes.resize(static_cast<std::size_t>(got));
        return bytes;
    }

private:
    FileDescriptor socket_;
};

class PosixSystem final : public ControlSystem {
public:
    PosixSystem(int argc, char** argv) : arguments_(argv + std::min(argc, 1), argv + argc) {}

    std::vector<std::string> arguments() override { return arguments_; }

    fs::path shipped() override { return program_folder(); }

    ImageDecoder decoder() override { return decode_png; }

    bool is_interactive() override { return ::isatty(STDIN_FILENO) != 0; }

    std::optional<std::string> read_line() override {
        std::string line;
        return std::getline(std::cin, line) ? std::optional(line) : std::nullopt;
    }

    Result<fs::path> usual_profile() override { return program_folder() / "config"; }

    Result<std::unique_ptr<Connection>> connect(const fs::path& profile) override {
        const Result<fs::path> path = control_path(profile);
        if (!path) {
            return std::unexpected(path.error());
        }
        FileDescriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
        const sockaddr_un address = address_of(*path);
        if (!socket || ::connect(socket.raw(), as_address(address), sizeof address) != 0) {
            return system_failure("no hyrax runs with the profile " + profile.native());
        }
        if (!is_of_this_user(socket.raw())) {
            return failure(path->native() + ": belongs to another user");
        }
        return std::make_unique<SocketConnection>(std::move(socket));
    }

private:
    std::vector<std::string> arguments_;
};

}  // namespace

std::unique_ptr<ControlSystem> make_control_system(int argc, char** argv) {
    return std::make_unique<PosixSystem>(argc, argv);
}

}  // namespace hyrax
