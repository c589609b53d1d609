// SPDX-License-Identifier: MIT
#include "daemon/win32/child_process.h"

#include "daemon/core/script_link.h"
#include "daemon/win32/clock.h"
#include "daemon/win32/confined_process.h"
#include "daemon/win32/process.h"
#include "daemon/win32/text.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>

namespace hyrax::win32 {
namespace {

constexpr DWORD pipe_bytes = DWORD{1} << 20U;
constexpr std::size_t read_bytes = std::size_t{64} << 10U;
// What one look takes at most; the rest waits for the next one.
constexpr std::size_t most_at_once = std::size_t{1} << 20U;
// Of exceptions that nobody caught.
constexpr DWORD first_crash_code = 0xC0000000;

std::unexpected<Error> failed(const char* what) {
    return std::unexpected(system_error(std::string("cannot start the script host: ") + what));
}

struct Wire {
    KernelObject ours;    // Overlapped.
    KernelObject theirs;  // Inheritable.
};

Result<Wire> make_wire() {
    SECURITY_ATTRIBUTES inheritable{sizeof inheritable, nullptr, TRUE};
    const std::wstring name =
        wide(fmt::format(R"(\\.\pipe\hyrax-scripts-{}-{})", ::GetCurrentProcessId(), clock_now()));
    // One instance, and ours from the first: nobody else can be at the other end.
    Wire wire;
    wire.ours = owned_file(::CreateNamedPipeW(
        name.c_str(),
        PIPE_ACCESS_DUPLEX | FILE_FLAG_OVERLAPPED | FILE_FLAG_FIRST_PIPE_INSTANCE,
        PIPE_TYPE_BYTE | PIPE_WAIT | PIPE_REJECT_REMOTE_CLIENTS,
        1,
        pipe_bytes,
        pipe_bytes,
        0,
        nullptr
    ));
    if (!wire.ours) {
        return failed("CreateNamedPipe");
    }
    wire.theirs = owned_file(::CreateFileW(
        name.c_str(), GENERIC_READ | GENERIC_WRITE, 0, &inheritable, OPEN_EXISTING, 0, nullptr
    ));
    if (!wire.theirs) {
        return failed("CreateFile");
    }
    return wire;
}

std::uintptr_t number_of(HANDLE handle) {
    return reinterpret_cast<std::uintptr_t>(handle);
}

}  // namespace

ChildProcess::ChildProcess(std::filesystem::path program)
    : program_(std::move(program)),
      heard_(::CreateEventW(nullptr, TRUE, FALSE, nullptr)),
      written_(::CreateEventW(nullptr, TRUE, FALSE, nullptr)),
      read_buffer_(read_bytes) {}

ChildProcess::~ChildProcess() {
    kill();
}

Result<void> ChildProcess::start() {
    kill();
    Result<Wire> wire = make_wire();
    if (!wire) {
        return std::unexpected(wire.error());
    }
    SECURITY_ATTRIBUTES inheritable{sizeof inheritable, nullptr, TRUE};
    const KernelObject memory(::CreateFileMappingW(
        INVALID_HANDLE_VALUE, &inheritable, PAGE_READWRITE, 0, sizeof(ScriptPulse), nullptr
    ));
    void* const shared =
        memory ? ::MapViewOfFile(memory.raw(), FILE_MAP_WRITE, 0, 0, sizeof(ScriptPulse)) : nullptr;
    if (shared == nullptr) {
        return failed("shared memory");
    }
    pulse_.reset(static_cast<ScriptPulse*>(shared));
    std::array<HANDLE, 2> inherited{wire->theirs.raw(), memory.raw()};
    Result<ConfinedProcess> started = start_confined({
        .program = program_,
        .arguments = wide(fmt::format(
            "{} {} {}", script_host_switch, number_of(inherited[0]), number_of(inherited[1])
        )),
        .inherited = inherited,
        .most_memory = most_memory,
    });
    if (!started) {
        return std::unexpected(started.error());
    }
    job_ = std::move(started->job);
    process_ = std::move(started->process);
    wire_ = std::move(wire->ours);
    broken_ = false;
    // The first read is under way from the beginning: its event tells of the first answer.
    std::vector<std::byte> nothing_yet;
    receive(nothing_yet);
    return {};
}

void ChildProcess::send(std::span<const std::byte> bytes) {
    unsent_.insert(unsent_.end(), bytes.begin(), bytes.end());
    flush();
}

// One write at a time; it goes on by itself while the process reads.
void ChildProcess::flush() {
    if (writing_) {
        DWORD size = 0;
        if (::GetOverlappedResult(wire_.raw(), &write_, &size, FALSE) == 0 &&
            ::GetLastError() == ERROR_IO_INCOMPLETE) {
            return;
        }
        writing_ = false;
    }
    if (!wire_ || broken_ || unsent_.empty()) {
        return;
    }
    write_buffer_ = std::exchange(unsent_, {});
    write_ = {};
    write_.hEvent = written_.raw();
    const BOOL written = ::WriteFile(
        wire_.raw(),
        write_buffer_.data(),
        static_cast<DWORD>(write_buffer_.size()),
        nullptr,
        &write_
    );
    writing_ = written != 0 || ::GetLastError() == ERROR_IO_PENDING;
}

void ChildProcess::receive(std::vector<std::byte>& bytes) {
    flush();
    for (std::size_t taken = 0; wire_ && !broken_;) {
        if (!reading_) {
            read_ = {};
            read_.hEvent = heard_.raw();
            const DWORD most = static_cast<DWORD>(read_buffer_.size());
            const BOOL read = ::ReadFile(wire_.raw(), read_buffer_.data(), most, nullptr, &read_);
            reading_ = read != 0 || ::GetLastError() == ERROR_IO_PENDING;
        }
        DWORD size = 0;
        if (reading_ && taken >= most_at_once) {
            return;  // the event tells of the rest
        }
        if (reading_ && ::GetOverlappedResult(wire_.raw(), &read_, &size, FALSE) != 0) {
            bytes.insert(bytes.end(), read_buffer_.begin(), read_buffer_.begin() + size);
            taken += size;
            reading_ = false;
        } else if (!reading_ || ::GetLastError() != ERROR_IO_INCOMPLETE) {
            reading_ = false;
            broken_ = true;
            ::ResetEvent(heard_.raw());
        } else {
            return;
        }
    }
}

std::optional<ScriptChannel::End> ChildProcess::ended() {
    DWORD code = 0;
    if (!process_ || ::WaitForSingleObject(process_.raw(), 0) != WAIT_OBJECT_0 ||
        ::GetExitCodeProcess(process_.raw(), &code) == 0) {
        return std::nullopt;
    }
    const bool crashed = code >= first_crash_code || code == DWORD{host_exit_out_of_memory};
    return End{crashed, fmt::format("exit code {:#x}", code)};
}

bool ChildProcess::wait(std::chrono::milliseconds patience) {
    if (!process_) {
        return false;
    }
    flush();
    // The write only as long as one is under way: else its event says nothing.
    const std::array<HANDLE, 3> events{heard_.raw(), process_.raw(), written_.raw()};
    const DWORD count = writing_ ? 3 : 2;
    const auto milliseconds = static_cast<DWORD>(patience.count());
    ::WaitForMultipleObjects(count, events.data(), FALSE, milliseconds);
    flush();
    return true;
}

void ChildProcess::kill() {
    if (job_) {
        ::TerminateJobObject(job_.raw(), 1);
    }
    forget_transfers();
    wire_.reset();
    process_.reset();
    job_.reset();
    unsent_.clear();
}

// Transfers that are cancelled are over at once: nobody at the other end is waited for.
void ChildProcess::forget_transfers() {
    DWORD size = 0;
    for (auto [transfer, active] : {std::pair{&read_, &reading_}, std::pair{&write_, &writing_}}) {
        if (std::exchange(*active, false)) {
            ::CancelIoEx(wire_.raw(), transfer);
            ::GetOverlappedResult(wire_.raw(), transfer, &size, TRUE);
        }
    }
    ::ResetEvent(heard_.raw());
}

const ScriptPulse& ChildProcess::pulse() const {
    static constexpr ScriptPulse none{};
    return pulse_ ? *pulse_ : none;
}

std::optional<Ticks> ChildProcess::processor_time() {
    FILETIME created;
    FILETIME exited;
    FILETIME kernel{};
    FILETIME user{};
    if (runs_under_wine() ||
        ::GetProcessTimes(process_.raw(), &created, &exited, &kernel, &user) == 0) {
        return std::nullopt;
    }
    return span_of(kernel) + span_of(user);
}

}  // namespace hyrax::win32
