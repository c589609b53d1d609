// SPDX-License-Identifier: MIT
#include "daemon/headless/control_socket.h"

#include "daemon/headless/control_path.h"
#include "daemon/headless/socket_calls.h"
#include "daemon/headless/system_error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

// Whoever holds it may replace the socket: a crash frees it, and two starts cannot both have it.
Result<FileDescriptor> lock_for(const fs::path& path) {
    fs::path name = path;
    name.replace_extension(".lock");
    FileDescriptor file(
        ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR)
    );
    if (!file) {
        return system_failure(name.native() + ": cannot be opened");
    }
    if (::flock(file.raw(), LOCK_EX | LOCK_NB) != 0) {
        return errno == EWOULDBLOCK ? failure("a hyrax with this profile serves already")
                                    : system_failure(name.native() + ": cannot be locked");
    }
    return file;
}

Result<FileDescriptor> listener_at(const fs::path& path) {
    FileDescriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket) {
        return system_failure("cannot make a socket");
    }
    // Before it has a name, so that there is no moment in which others could connect.
    ::fchmod(socket.raw(), S_IRUSR | S_IWUSR);
    ::unlink(path.c_str());
    const sockaddr_un address = address_of(path);
    if (::bind(socket.raw(), as_address(address), sizeof address) != 0) {
        return system_failure(path.native() + ": cannot be made");
    }
    if (::listen(socket.raw(), static_cast<int>(ControlSocket::most_clients)) != 0) {
        return system_failure(path.native() + ": cannot be listened to");
    }
    return socket;
}

}  // namespace

Result<ControlSocket> ControlSocket::open(const fs::path& profile) {
    const Result<fs::path> path = control_path(profile);
    if (!path) {
        return std::unexpected(path.error());
    }
    if (const Result<void> folder = prepare_control_folder(path->parent_path()); !folder) {
        return std::unexpected(folder.error());
    }
    Result<FileDescriptor> lock = lock_for(*path);
    if (!lock) {
        return std::unexpected(lock.error());
    }
    Result<FileDescriptor> listener = listener_at(*path);
    if (!listener) {
        return std::unexpected(listener.error());
    }
    return ControlSocket(*std::move(lock), *std::move(listener), *path);
}

ControlSocket::ControlSocket(FileDescriptor lock, FileDescriptor listener, fs::path path)
    : lock_(std::move(lock)), listener_(std::move(listener)), path_(std::move(path)) {}

ControlSocket::~ControlSocket() {
    if (listener_) {
        ::unlink(path_.c_str());
    }
}

void ControlSocket::poll_for(std::vector<pollfd>& entries) const {
    if (clients_.size() < most_clients) {
        entries.push_back({listener_.raw(), POLLIN, 0});
    }
    for (const Client& client : clients_) {
        const int in = client.session.wanted() > 0 ? POLLIN : 0;
        const int out = client.session.unsent().empty() ? 0 : POLLOUT;
        entries.push_back({client.socket.raw(), static_cast<short>(in | out), 0});
    }
}

Ticks ControlSocket::due() const {
    Ticks earliest = never;
    for (const Client& client : clients_) {
        earliest = std::min(earliest, client.session.due());
    }
    return earliest;
}

void ControlSocket::serve(Ticks now, std::vector<Input>& inbox) {
    accept_clients(now);
    for (Client& client : clients_) {
        receive(client);
        if (std::optional<std::string> request = client.session.take_request()) {
            inbox.emplace_back(input::Asked{client.session.id(), *std::move(request)});
        }
        send(client, now);
        client.session.check_time(now);
        if (client.session.is_over() && client.session.is_watching()) {
            inbox.emplace_back(input::Left{client.session.id()});
        }
    }
    std::erase_if(clients_, [](const Client& client) { return client.session.is_over(); });
}

void ControlSocket::answer(ClientId id, std::string_view text, Answer which, Ticks now) {
    for (Client& client : clients_) {
        if (client.session.id() == id && client.session.answer(text, which, now)) {
            send(client, now);
        }
    }
}

void ControlSocket::accept_clients(Ticks now) {
    while (clients_.size() < most_clients) {
        FileDescriptor socket(
            ::accept4(listener_.raw(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)
        );
        if (!socket) {
            return;
        }
        if (is_of_this_user(socket.raw())) {
            clients_.push_back({std::move(socket), ClientSession(next_id_++, now)});
        }
    }
}

void ControlSocket::receive(Client& client) {
    std::array<char, 4096> buffer;
    while (const std::size_t wanted = std::min(client.session.wanted(), buffer.size())) {
        const ssize_t got = ::recv(client.socket.raw(), buffer.data(), wanted, 0);
        if (got < 0 && (errno == EAGAIN || errno == EINTR)) {
            return;
        }
        if (got <= 0) {
            client.session.left();
        } else {
            client.session.received({buffer.data(), static_cast<std::size_t>(got)});
        }
    }
}

void ControlSocket::send(Client& client, Ticks now) {
    while (!client.session.unsent().empty() && !client.session.is_over()) {
        const std::string_view bytes = client.session.unsent();
        const ssize_t sent = ::send(client.socket.raw(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0) {
            if (errno != EAGAIN && errno != EINTR) {
                client.session.left();
            }
            return;
        }
        client.session.sent(static_cast<std::size_t>(sent), now);
    }
}

}  // namespace hyrax
