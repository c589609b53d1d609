// SPDX-License-Identifier: MIT
#include "daemon/win32/host_process.h"

#include "daemon/win32/text.h"

#include <charconv>
#include <cstdint>
#include <optional>

namespace hyrax::win32 {
namespace {

HANDLE handle_of(const std::string& number) {
    std::uintptr_t value = 0;
    std::from_chars(number.data(), number.data() + number.size(), value);
    return reinterpret_cast<HANDLE>(value);
}

}  // namespace

Result<std::unique_ptr<HostProcess>> HostProcess::settle_in(
    const std::string& wire, const std::string& pulse
) {
    // Nobody is there to look at a box.
    ::SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
    void* const shared =
        ::MapViewOfFile(handle_of(pulse), FILE_MAP_WRITE, 0, 0, sizeof(ScriptPulse));
    if (shared == nullptr || ::GetFileType(handle_of(wire)) != FILE_TYPE_PIPE) {
        return failure("a script host is started by the daemon alone");
    }
    return std::unique_ptr<HostProcess>(
        new HostProcess(handle_of(wire), *static_cast<ScriptPulse*>(shared))
    );
}

std::size_t HostProcess::read(std::span<std::byte> into) {
    DWORD size = 0;
    const BOOL done =
        ::ReadFile(wire_.raw(), into.data(), static_cast<DWORD>(into.size()), &size, nullptr);
    return done != 0 ? size : 0;
}

bool HostProcess::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        DWORD size = 0;
        if (::WriteFile(
                wire_.raw(), bytes.data(), static_cast<DWORD>(bytes.size()), &size, nullptr
            ) == 0) {
            return false;
        }
        bytes = bytes.subspan(size);
    }
    return true;
}

}  // namespace hyrax::win32
