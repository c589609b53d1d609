// SPDX-License-Identifier: MIT
#include "daemon/win32/process_use.h"

#include <windows.h>

// After windows.h, whose types it uses.
#include <psapi.h>

namespace hyrax::win32 {

ProcessUse process_use() {
    const HANDLE self = ::GetCurrentProcess();
    DWORD handles = 0;
    ::GetProcessHandleCount(self, &handles);
    PROCESS_MEMORY_COUNTERS memory{};
    // kernel32 has it; psapi.dll would be one more library to load.
    ::K32GetProcessMemoryInfo(self, &memory, sizeof memory);
    return {
        .gdi_objects = ::GetGuiResources(self, GR_GDIOBJECTS),
        .user_objects = ::GetGuiResources(self, GR_USEROBJECTS),
        .handles = handles,
        .private_bytes = memory.PagefileUsage,
        .resident_bytes = memory.WorkingSetSize,
    };
}

}  // namespace hyrax::win32
