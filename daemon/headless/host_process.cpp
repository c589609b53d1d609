// SPDX-License-Identifier: MIT
#include "daemon/headless/host_process.h"

#include "daemon/headless/confinement.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>

namespace hyrax {

Result<std::unique_ptr<HostProcess>> HostProcess::settle_in(const std::string& parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    // The parent may have died before that.
    if (std::to_string(::getppid()) != parent) {
        return failure("a script host is started by the daemon alone");
    }
    void* const shared = ::mmap(
        nullptr, sizeof(ScriptPulse), PROT_READ | PROT_WRITE, MAP_SHARED, pulse_descriptor, 0
    );
    if (shared == MAP_FAILED) {
        return failure("a script host needs a pulse");
    }
    ::close(pulse_descriptor);
    if (const Result<void> confined = confine({.wire = wire_descriptor}); !confined) {
        return std::unexpected(confined.error());
    }
    return std::unique_ptr<HostProcess>(new HostProcess(*static_cast<ScriptPulse*>(shared)));
}

std::size_t HostProcess::read(std::span<std::byte> into) {
    ssize_t size = 0;
    do {
        size = ::read(wire_descriptor, into.data(), into.size());
    } while (size < 0 && errno == EINTR);
    return size < 0 ? 0 : static_cast<std::size_t>(size);
}

bool HostProcess::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t size = ::write(wire_descriptor, bytes.data(), bytes.size());
        if (size < 0 && errno != EINTR) {
            return false;
        }
        bytes = bytes.subspan(size < 0 ? 0 : static_cast<std::size_t>(size));
    }
    return true;
}

}  // namespace hyrax
