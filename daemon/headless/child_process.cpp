// SPDX-License-Identifier: MIT
#include "daemon/headless/child_process.h"

#include "daemon/core/script_link.h"
#include "daemon/headless/host_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace hyrax {
namespace {

// Above those that the child gets, so that moving them there overwrites none.
constexpr int first_free_descriptor = 16;
// What one look takes at most; the rest waits for the next one.
constexpr std::size_t most_at_once = std::size_t{1} << 20U;

std::unexpected<Error> failed(const char* what, int error) {
    return failure(fmt::format("cannot start the script host: {}: {}", what, strerror(error)));
}

FileDescriptor moved_up(FileDescriptor from) {
    return FileDescriptor(::fcntl(from.raw(), F_DUPFD_CLOEXEC, first_free_descriptor));
}

/// What posix_spawn does between fork and exec.
class SpawnPlan {
public:
    SpawnPlan(int wire, int pulse) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawnattr_init(&attributes_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, wire, wire_descriptor);
        posix_spawn_file_actions_adddup2(&actions_, pulse, pulse_descriptor);
        posix_spawn_file_actions_addclosefrom_np(&actions_, pulse_descriptor + 1);
        sigset_t all;
        sigset_t none;
        sigfillset(&all);
        sigemptyset(&none);
        posix_spawnattr_setsigdefault(&attributes_, &all);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;
    ~SpawnPlan() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }

    /// Without an environment.
    int spawn(pid_t& pid, const std::filesystem::path& program) const {
        std::string name = "hyrax-scripts";
        std::string role(script_host_switch);
        std::string parent = std::to_string(::getpid());
        const std::array<char*, 4> arguments{name.data(), role.data(), parent.data(), nullptr};
        const std::array<char*, 1> environment{nullptr};
        return ::posix_spawn(
            &pid, program.c_str(), &actions_, &attributes_, arguments.data(), environment.data()
        );
    }

private:
    posix_spawn_file_actions_t actions_;
    posix_spawnattr_t attributes_;
};

ScriptChannel::End end_of(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        const bool from_outside = signal == SIGKILL || signal == SIGTERM || signal == SIGINT;
        return {!from_outside, fmt::format("signal {}", signal)};
    }
    const int code = WEXITSTATUS(status);
    return {code == host_exit_out_of_memory, fmt::format("exit code {}", code)};
}

}  // namespace

void ChildProcess::Unmap::operator()(ScriptPulse* pulse) const {
    ::munmap(pulse, sizeof *pulse);
}

ChildProcess::ChildProcess(std::filesystem::path program) : program_(std::move(program)) {}

ChildProcess::~ChildProcess() {
    kill();
    for (const pid_t pid : dying_) {
        ::waitpid(pid, nullptr, 0);
    }
}

Result<void> ChildProcess::start() {
    kill();
    std::array<int, 2> ends{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        return failed("socketpair", errno);
    }
    FileDescriptor wire(ends[0]);
    const FileDescriptor theirs = moved_up(FileDescriptor(ends[1]));
    const FileDescriptor memory =
        moved_up(FileDescriptor(::memfd_create("hyrax-pulse", MFD_CLOEXEC)));
    if (!theirs || !memory || ::ftruncate(memory.raw(), sizeof(ScriptPulse)) != 0) {
        return failed("shared memory", errno);
    }
    void* const shared =
        ::mmap(nullptr, sizeof(ScriptPulse), PROT_READ | PROT_WRITE, MAP_SHARED, memory.raw(), 0);
    if (shared == MAP_FAILED) {
        return failed("mmap", errno);
    }
    pulse_.reset(static_cast<ScriptPulse*>(shared));
    const SpawnPlan plan(theirs.raw(), memory.raw());
    pid_t pid = 0;
    if (const int error = plan.spawn(pid, program_); error != 0) {
        return failed(program_.c_str(), error);
    }
    pid_ = pid;
    wire_ = std::move(wire);
    used_ = 0;
    return {};
}

void ChildProcess::send(std::span<const std::byte> bytes) {
    unsent_.insert(unsent_.end(), bytes.begin(), bytes.end());
    flush();
}

void ChildProcess::flush() {
    while (wire_ && sent_ < unsent_.size()) {
        const ssize_t size = ::send(
            wire_.raw(), unsent_.data() + sent_, unsent_.size() - sent_, MSG_DONTWAIT | MSG_NOSIGNAL
        );
        if (size < 0) {
            return;  // it is full, or nobody reads it any more
        }
        sent_ += static_cast<std::size_t>(size);
    }
    unsent_.clear();
    sent_ = 0;
}

void ChildProcess::receive(std::vector<std::byte>& bytes) {
    flush();
    std::array<std::byte, std::size_t{64} << 10U> buffer;
    for (std::size_t taken = 0; wire_ && taken < most_at_once;) {
        const ssize_t size = ::recv(wire_.raw(), buffer.data(), buffer.size(), MSG_DONTWAIT);
        if (size <= 0) {
            return;
        }
        bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + size);
        taken += static_cast<std::size_t>(size);
    }
}

std::optional<ScriptChannel::End> ChildProcess::ended() {
    reap();
    int status = 0;
    if (pid_ == 0 || ::waitpid(pid_, &status, WNOHANG) != pid_) {
        return std::nullopt;
    }
    pid_ = 0;
    return end_of(status);
}

void ChildProcess::kill() {
    if (pid_ != 0) {
        ::kill(pid_, SIGKILL);
        dying_.push_back(std::exchange(pid_, 0));
    }
    wire_.reset();
    unsent_.clear();
    sent_ = 0;
    reap();
}

void ChildProcess::reap() {
    std::erase_if(dying_, [](pid_t pid) { return ::waitpid(pid, nullptr, WNOHANG) == pid; });
}

const ScriptPulse& ChildProcess::pulse() const {
    static constexpr ScriptPulse none{};
    return pulse_ ? *pulse_ : none;
}

std::optional<Ticks> ChildProcess::processor_time() {
    clockid_t clock = 0;
    timespec time{};
    if (pid_ != 0 && ::clock_getcpuclockid(pid_, &clock) == 0 &&
        ::clock_gettime(clock, &time) == 0) {
        used_ = time.tv_sec * ticks_per_second + time.tv_nsec;
    }
    return used_;
}

bool ChildProcess::wait(std::chrono::milliseconds patience) {
    if (!wire_) {
        return false;
    }
    flush();
    const auto wanted = static_cast<short>(unsent_.empty() ? POLLIN : POLLIN | POLLOUT);
    pollfd wire{.fd = wire_.raw(), .events = wanted, .revents = 0};
    ::poll(&wire, 1, static_cast<int>(patience.count()));
    flush();
    return true;
}

}  // namespace hyrax
