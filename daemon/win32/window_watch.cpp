// SPDX-License-Identifier: MIT
#include "daemon/win32/window_watch.h"

#include "daemon/win32/clock.h"

#include <algorithm>
#include <array>
#include <exception>
#include <utility>

namespace hyrax::win32 {
namespace {

// A dragged window raises an event for each move of the mouse.
constexpr Ticks quiet = 30 * ticks_per_ms;

// While the hooks have told nothing at all: Wine delivers some kinds of events and not others.
constexpr Ticks poll_period = 500 * ticks_per_ms;

struct Range {
    DWORD first;
    DWORD last;
};

constexpr std::array ranges{
    Range{EVENT_SYSTEM_FOREGROUND, EVENT_SYSTEM_FOREGROUND},
    Range{EVENT_SYSTEM_MOVESIZESTART, EVENT_SYSTEM_MOVESIZEEND},
    Range{EVENT_SYSTEM_MINIMIZESTART, EVENT_SYSTEM_MINIMIZEEND},
    Range{EVENT_OBJECT_DESTROY, EVENT_OBJECT_HIDE},
    Range{EVENT_OBJECT_CLOAKED, EVENT_OBJECT_UNCLOAKED},
};

// Events of a hook carry nothing of who has set it.
WindowWatch*& watch_of_this_thread() {
    thread_local WindowWatch* watch = nullptr;
    return watch;
}

HWINEVENTHOOK hook(const Range& range, WINEVENTPROC listener, DWORD thread) {
    return ::SetWinEventHook(
        range.first,
        range.last,
        nullptr,
        listener,
        0,
        thread,
        WINEVENT_OUTOFCONTEXT | WINEVENT_SKIPOWNPROCESS
    );
}

}  // namespace

WindowWatch::WindowWatch() : hints_(quiet, quiet) {
    watch_of_this_thread() = this;
}

WindowWatch::~WindowWatch() {
    watch_of_this_thread() = nullptr;
}

void WindowWatch::watch(const WindowInterest& interest, Ticks now) {
    interest_ = interest;
    if (!interest_.any) {
        hooks_.clear();
        move_hooks_.clear();
        moving_threads_.clear();
        dragged_ = nullptr;
        hints_ = Debounce(quiet, quiet);
        poll_at_ = never;
        return;
    }
    if (hooks_.empty()) {
        hook_all();
        poll_at_ = now + poll_period;
    }
    hook_moves();
}

void WindowWatch::hook_all() {
    for (const Range& range : ranges) {
        if (Hook made(hook(range, on_event, 0)); made) {
            hooks_.push_back(std::move(made));
        }
    }
}

void WindowWatch::hook_moves() {
    std::vector<DWORD> threads;
    for (const std::uint64_t id : interest_.underfoot) {
        threads.push_back(::GetWindowThreadProcessId(window_with(id), nullptr));
    }
    if (dragged_ != nullptr) {
        threads.push_back(::GetWindowThreadProcessId(dragged_, nullptr));
    }
    std::erase(threads, DWORD{0});
    std::ranges::sort(threads);
    threads.erase(std::ranges::unique(threads).begin(), threads.end());
    if (threads == moving_threads_) {
        return;
    }
    move_hooks_.clear();
    for (const DWORD thread : threads) {
        const Range moves{EVENT_OBJECT_LOCATIONCHANGE, EVENT_OBJECT_LOCATIONCHANGE};
        if (Hook made(hook(moves, on_event, thread)); made) {
            move_hooks_.push_back(std::move(made));
        }
    }
    moving_threads_ = std::move(threads);
}

Ticks WindowWatch::due() const {
    return std::min(hints_.due(), poll_at_);
}

bool WindowWatch::check(Ticks now) {
    if (hints_.take(now)) {
        return true;
    }
    if (now < poll_at_) {
        return false;
    }
    poll_at_ = now + poll_period;
    return reader_.read() != last_read_;
}

std::vector<DesktopWindow> WindowWatch::read() {
    last_read_ = reader_.read();
    return last_read_;
}

void CALLBACK WindowWatch::on_event(
    HWINEVENTHOOK, DWORD event, HWND window, LONG object, LONG child, DWORD, DWORD
) {
    WindowWatch* const watch = watch_of_this_thread();
    // A window that is being destroyed has no root any more.
    if (watch == nullptr || window == nullptr || object != OBJID_WINDOW || child != CHILDID_SELF) {
        return;
    }
    const HWND root = ::GetAncestor(window, GA_ROOT);
    if (root != nullptr && root != window) {
        return;
    }
    try {
        watch->hear(event, window);
    } catch (const std::exception&) {
        // No memory for a list of threads: the next event tries again.
        return;
    }
}

void WindowWatch::hear(DWORD event, HWND window) {
    // Events that were on their way when the hooks went.
    if (!interest_.any) {
        return;
    }
    poll_at_ = never;
    hints_.hint(clock_now());
    if (event == EVENT_SYSTEM_MOVESIZESTART || event == EVENT_SYSTEM_MOVESIZEEND) {
        dragged_ = event == EVENT_SYSTEM_MOVESIZESTART ? window : nullptr;
        hook_moves();
    }
}

}  // namespace hyrax::win32
