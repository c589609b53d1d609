// SPDX-License-Identifier: MIT
#include "daemon/win32/clock.h"

#include <algorithm>
#include <cstdint>

namespace hyrax::win32 {

namespace {

// Missing in the headers of mingw-w64 10.
constexpr DWORD high_resolution = 0x00000002;  // CREATE_WAITABLE_TIMER_HIGH_RESOLUTION

constexpr DWORD timer_access = TIMER_ALL_ACCESS;

/// Ordinary timers are up to 15.6 ms late. The precise kind needs Windows 10 1803; raising the
/// resolution of the whole system instead (timeBeginPeriod) costs power in every other program.
KernelObject make_timer() {
    KernelObject timer(::CreateWaitableTimerExW(nullptr, nullptr, high_resolution, timer_access));
    if (!timer) {
        timer = KernelObject(::CreateWaitableTimerExW(nullptr, nullptr, 0, timer_access));
    }
    return timer;
}

}  // namespace

Ticks clock_now() {
    LARGE_INTEGER frequency;
    LARGE_INTEGER count;
    ::QueryPerformanceFrequency(&frequency);
    ::QueryPerformanceCounter(&count);
    // In two parts: count * 1e9 would overflow after 15 minutes of a 10 MHz counter.
    const Ticks seconds = count.QuadPart / frequency.QuadPart;
    const Ticks rest = count.QuadPart % frequency.QuadPart;
    return seconds * ticks_per_second + rest * ticks_per_second / frequency.QuadPart;
}

WallTime wall_clock() {
    constexpr std::int64_t per_second = 10'000'000;
    constexpr std::int64_t from_1601_to_1970 = 11'644'473'600;
    FILETIME utc{};
    FILETIME local{};
    ::GetSystemTimeAsFileTime(&utc);
    ::FileTimeToLocalFileTime(&utc, &local);
    const auto seconds = [](const FILETIME& time) {
        const std::uint64_t high = time.dwHighDateTime;
        return static_cast<std::int64_t>((high << 32U) | time.dwLowDateTime) / per_second;
    };
    return {seconds(utc) - from_1601_to_1970, static_cast<int>(seconds(local) - seconds(utc))};
}

std::chrono::nanoseconds thread_processor_time() {
    FILETIME created;
    FILETIME exited;
    FILETIME kernel{};
    FILETIME user{};
    ::GetThreadTimes(::GetCurrentThread(), &created, &exited, &kernel, &user);
    return std::chrono::nanoseconds(span_of(kernel) + span_of(user));
}

Ticks span_of(const FILETIME& time) {
    return 100 * ((Ticks{time.dwHighDateTime} << 32U) | time.dwLowDateTime);
}

Alarm::Alarm() : timer_(make_timer()) {}

void Alarm::set(Ticks span) {
    // Negative: relative, in units of 100 ns, rounded up so that it never fires too early.
    LARGE_INTEGER due;
    due.QuadPart = -std::max<Ticks>(1, (std::max<Ticks>(0, span) + 99) / 100);
    armed_ = ::SetWaitableTimer(timer_.raw(), &due, 0, nullptr, nullptr, FALSE) != 0;
}

void Alarm::cancel() {
    if (armed_) {
        ::CancelWaitableTimer(timer_.raw());
        armed_ = false;
    }
}

}  // namespace hyrax::win32
