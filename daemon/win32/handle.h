// SPDX-License-Identifier: MIT
// Owners of what the system lends: one type for each way to give it back. No other file calls
// Close*, Destroy*, Delete*, Release* or Free*, except for pairs that have a class of their own.
#pragma once

#include <windows.h>
#include <objbase.h>

#include <memory>
#include <utility>

namespace hyrax::win32 {

/// Move-only; `close` is called once for every value but `none`.
template <typename T, auto close, T none = T{}>
class Handle {
public:
    Handle() = default;
    explicit Handle(T value) : value_(value) {}
    Handle(Handle&& other) noexcept : value_(std::exchange(other.value_, none)) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            reset();
            value_ = std::exchange(other.value_, none);
        }
        return *this;
    }
    ~Handle() { reset(); }

    void reset() {
        if (value_ != none) {
            close(std::exchange(value_, none));
        }
    }
    T raw() const { return value_; }
    /// The value, which somebody else closes from now on.
    T release() { return std::exchange(value_, none); }
    explicit operator bool() const { return value_ != none; }

private:
    T value_ = none;
};

/// For calls that fail with null. CreateFileW fails with another value: see owned_file().
using KernelObject = Handle<HANDLE, ::CloseHandle>;
using Window = Handle<HWND, ::DestroyWindow>;
using Menu = Handle<HMENU, ::DestroyMenu>;
using Icon = Handle<HICON, ::DestroyIcon>;
using MemoryDc = Handle<HDC, ::DeleteDC>;
using Bitmap = Handle<HBITMAP, ::DeleteObject>;
using LocalMemory = Handle<HLOCAL, ::LocalFree>;
using Library = Handle<HMODULE, ::FreeLibrary>;

inline KernelObject owned_file(HANDLE file) {
    return KernelObject(file == INVALID_HANDLE_VALUE ? nullptr : file);
}

struct ComRelease {
    void operator()(IUnknown* object) const { object->Release(); }
};
template <typename T>
using ComPointer = std::unique_ptr<T, ComRelease>;

struct TaskMemoryFree {
    void operator()(void* memory) const { ::CoTaskMemFree(memory); }
};
template <typename T>
using TaskMemory = std::unique_ptr<T, TaskMemoryFree>;

/// COM on this thread, single-threaded apartment.
class ComSession {
public:
    ComSession()
        : result_(::CoInitializeEx(nullptr, COINIT_APARTMENTTHREADED | COINIT_DISABLE_OLE1DDE)) {}
    ComSession(const ComSession&) = delete;
    ComSession& operator=(const ComSession&) = delete;
    ~ComSession() {
        if (SUCCEEDED(result_)) {
            ::CoUninitialize();
        }
    }

private:
    HRESULT result_;
};

}  // namespace hyrax::win32
