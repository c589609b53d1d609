// SPDX-License-Identifier: MIT
// A client's end of the control channel on Windows.
#include "daemon/control/connection.h"
#include "daemon/core/files.h"
#include "daemon/win32/handle.h"
#include "daemon/win32/image_decoder.h"
#include "daemon/win32/pipe_name.h"
#include "daemon/win32/process.h"
#include "daemon/win32/single_instance.h"
#include "daemon/win32/text.h"

#include <array>
#include <iostream>
#include <optional>
#include <utility>

namespace hyrax::win32 {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr DWORD connect_patience_ms = 5000;
constexpr milliseconds sending_patience{5000};

class PipeConnection final : public Connection {
public:
    explicit PipeConnection(KernelObject pipe)
        : pipe_(std::move(pipe)), done_(::CreateEventW(nullptr, TRUE, FALSE, nullptr)) {}

    Result<void> write(std::string_view bytes) override {
        OVERLAPPED state{};
        state.hEvent = done_.raw();
        const bool begun =
            ::WriteFile(
                pipe_.raw(), bytes.data(), static_cast<DWORD>(bytes.size()), nullptr, &state
            ) != 0 ||
            ::GetLastError() == ERROR_IO_PENDING;
        const DWORD code = begun ? finish(state, sending_patience).code : ::GetLastError();
        if (code != ERROR_SUCCESS) {
            return std::unexpected(system_error("cannot send to hyrax", code));
        }
        return {};
    }

    Result<std::string> read(std::size_t most, std::optional<milliseconds> patience) override {
        std::string bytes(most, '\0');
        OVERLAPPED state{};
        state.hEvent = done_.raw();
        const bool begun =
            ::ReadFile(pipe_.raw(), bytes.data(), static_cast<DWORD>(most), nullptr, &state) != 0 ||
            ::GetLastError() == ERROR_IO_PENDING;
        const Outcome outcome = begun ? finish(state, patience) : Outcome{::GetLastError(), 0};
        if (outcome.code == ERROR_OPERATION_ABORTED) {
            return failure("hyrax does not answer");
        }
        const bool ended =
            outcome.code == ERROR_BROKEN_PIPE || outcome.code == ERROR_PIPE_NOT_CONNECTED;
        if (outcome.code != ERROR_SUCCESS && !ended) {
            return std::unexpected(system_error("cannot hear hyrax", outcome.code));
        }
        bytes.resize(outcome.bytes);
        return bytes;
    }

private:
    struct Outcome {
        DWORD code = ERROR_SUCCESS;
        DWORD bytes = 0;
    };

    // The call is over when this returns: it is cancelled when it takes too long.
    Outcome finish(OVERLAPPED& state, std::optional<milliseconds> patience) const {
        const DWORD timeout = patience ? static_cast<DWORD>(patience->count()) : INFINITE;
        if (::WaitForSingleObject(done_.raw(), timeout) != WAIT_OBJECT_0) {
            ::CancelIoEx(pipe_.raw(), &state);
        }
        Outcome outcome;
        if (::GetOverlappedResult(pipe_.raw(), &state, &outcome.bytes, TRUE) == 0) {
            outcome = {::GetLastError(), 0};
        }
        return outcome;
    }

    KernelObject pipe_;
    KernelObject done_;
};

KernelObject open_pipe(const std::wstring& name) {
    // The server may learn who its client is, and may not act as it.
    constexpr DWORD flags = FILE_FLAG_OVERLAPPED | SECURITY_SQOS_PRESENT | SECURITY_IDENTIFICATION;
    return owned_file(::CreateFileW(
        name.c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr, OPEN_EXISTING, flags, nullptr
    ));
}

class WindowsSystem final : public ControlSystem {
public:
    WindowsSystem() { ::SetConsoleOutputCP(CP_UTF8); }

    std::vector<std::string> arguments() override { return command_line_arguments(); }

    fs::path shipped() override {
        const Result<Folders> folders = find_folders();
        return folders ? folders->program : fs::path();
    }

    ImageDecoder decoder() override {
        if (!gdiplus_) {
            gdiplus_.emplace();
        }
        return make_gdiplus_decoder();
    }

    bool is_interactive() override {
        DWORD mode = 0;
        return ::GetConsoleMode(::GetStdHandle(STD_INPUT_HANDLE), &mode) != 0;
    }

    // The C library would read a console in the code page of the system.
    std::optional<std::string> read_line() override {
        std::string line;
        if (!is_interactive()) {
            return std::getline(std::cin, line) ? std::optional(line) : std::nullopt;
        }
        std::wstring wide;
        while (!wide.ends_with(L'\n')) {
            std::array<wchar_t, 512> part{};
            DWORD read = 0;
            const BOOL good = ::ReadConsoleW(
                ::GetStdHandle(STD_INPUT_HANDLE), part.data(), DWORD{part.size()}, &read, nullptr
            );
            constexpr wchar_t ctrl_z = 0x1A;
            if (good == 0 || read == 0 || (wide.empty() && part.front() == ctrl_z)) {
                return std::nullopt;
            }
            wide.append(part.data(), read);
        }
        while (wide.ends_with(L'\n') || wide.ends_with(L'\r')) {
            wide.pop_back();
        }
        return utf8(wide);
    }

    Result<fs::path> usual_profile() override {
        const Result<Folders> folders = find_folders();
        return folders ? Result<fs::path>(folders->profile) : std::unexpected(folders.error());
    }

    Result<std::unique_ptr<Connection>> connect(const fs::path& profile) override {
        const Result<std::wstring> instance = instance_name(profile);
        if (!instance) {
            return std::unexpected(instance.error());
        }
        const Result<std::wstring> name = pipe_name(*instance);
        if (!name) {
            return std::unexpected(name.error());
        }
        KernelObject pipe = open_pipe(*name);
        // Another client may be quicker when one has gone.
        while (!pipe && ::GetLastError() == ERROR_PIPE_BUSY &&
               ::WaitNamedPipeW(name->c_str(), connect_patience_ms) != 0) {
            pipe = open_pipe(*name);
        }
        if (!pipe) {
            return std::unexpected(
                system_error("no hyrax runs with the profile " + utf8_from_path(profile))
            );
        }
        if (const Result<void> owned = check_owner(pipe.raw()); !owned) {
            return std::unexpected(owned.error());
        }
        return std::make_unique<PipeConnection>(std::move(pipe));
    }

private:
    std::optional<GdiplusSession> gdiplus_;  // Nobody else needs it.
};

}  // namespace
}  // namespace hyrax::win32

namespace hyrax {

std::unique_ptr<ControlSystem> make_control_system(int, char**) {
    return std::make_unique<win32::WindowsSystem>();
}

}  // namespace hyrax
