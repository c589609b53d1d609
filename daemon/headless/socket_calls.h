// SPDX-License-Identifier: MIT
// What both ends of a Unix socket need.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace hyrax {

/// The path must fit: see control_path().
inline sockaddr_un address_of(const std::filesystem::path& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::ranges::copy_n(
        path.c_str(),
        static_cast<std::ptrdiff_t>(std::min(path.native().size(), std::size(address.sun_path) - 1)
        ),
        std::begin(address.sun_path)
    );
    return address;
}

inline const sockaddr* as_address(const sockaddr_un& address) {
    return reinterpret_cast<const sockaddr*>(&address);
}

/// Whether the process at the other end belongs to the same user.
inline bool is_of_this_user(int socket) {
    ucred peer{};
    socklen_t size = sizeof peer;
    return ::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 &&
           peer.uid == ::geteuid();
}

}  // namespace hyrax
