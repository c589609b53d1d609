// SPDX-License-Identifier: MIT
// DLLs that a program must not import: the loader takes only those of the KnownDLLs list from the
// system's folder whatever lies beside the executable.
#pragma once

#include "daemon/win32/handle.h"

namespace hyrax::win32 {

/// Loaded from the system's folder; may be missing.
class SystemLibrary {
public:
    explicit SystemLibrary(const wchar_t* name)
        : library_(::LoadLibraryExW(name, nullptr, LOAD_LIBRARY_SEARCH_SYSTEM32)) {}

    /// Null where the library or the function is missing.
    template <typename Function>
    Function* function(const char* name) const {
        if (!library_) {
            return nullptr;
        }
        return reinterpret_cast<Function*>(
            reinterpret_cast<void*>(::GetProcAddress(library_.raw(), name))
        );
    }

private:
    Library library_;
};

}  // namespace hyrax::win32
