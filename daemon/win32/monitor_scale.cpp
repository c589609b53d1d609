// SPDX-License-Identifier: MIT
#include "daemon/win32/monitor_scale.h"

#include "daemon/win32/handle.h"

namespace hyrax::win32 {

namespace {

using GetDpiForMonitorFunction = HRESULT(WINAPI*)(HMONITOR, int, UINT*, UINT*);

constexpr int effective_dpi = 0;  // MDT_EFFECTIVE_DPI
constexpr double usual_dpi = 96.0;

/// shcore.dll is none of the KnownDLLs: it is taken from the system's folder alone.
struct ShellScaling {
    Library library{::LoadLibraryExW(L"shcore.dll", nullptr, LOAD_LIBRARY_SEARCH_SYSTEM32)};
    GetDpiForMonitorFunction get_dpi = nullptr;

    ShellScaling() {
        if (library) {
            FARPROC const found = ::GetProcAddress(library.raw(), "GetDpiForMonitor");
            get_dpi = reinterpret_cast<GetDpiForMonitorFunction>(reinterpret_cast<void*>(found));
        }
    }
};

}  // namespace

double monitor_scale(HMONITOR monitor) {
    static const ShellScaling scaling;
    UINT across = 0;
    UINT down = 0;
    if (scaling.get_dpi == nullptr ||
        FAILED(scaling.get_dpi(monitor, effective_dpi, &across, &down)) || across == 0) {
        return 1.0;
    }
    return across / usual_dpi;
}

}  // namespace hyrax::win32
