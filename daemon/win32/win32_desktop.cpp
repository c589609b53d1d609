// SPDX-License-Identifier: MIT
// The seam itself: waiting and presenting. What messages mean is in win32_desktop_messages.cpp.
#include "daemon/win32/win32_desktop.h"

#include "daemon/core/check.h"
#include "daemon/win32/messages.h"
#include "daemon/win32/single_instance.h"
#include "daemon/win32/text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hyrax::win32 {

Win32Desktop::Win32Desktop(Win32DesktopOptions options)
    : options_(std::move(options)),
      autostart_(options_.executable),
      files_(options_.profile, options_.unwatched, clock_now()),
      screens_(options_.monitors(), clock_now()),
      worker_([this] { ::PostMessageW(daemon_.raw(), sprites_message, 0, 0); }),
      overlay_(*this),
      bubbles_(*this, PaneClicks::pass_through),
      pointer_(overlay_, inbox_) {}

Result<std::unique_ptr<Win32Desktop>> Win32Desktop::create(Win32DesktopOptions options) {
    std::unique_ptr<Win32Desktop> desktop(new Win32Desktop(std::move(options)));
    if (const Result<void> started = desktop->start(); !started) {
        return std::unexpected(started.error());
    }
    return desktop;
}

Result<void> Win32Desktop::start() {
    if (alarm_.event() == nullptr || files_.event() == nullptr) {
        return std::unexpected(system_error("cannot make a timer"));
    }
    // Top-level though never shown: message-only windows do not hear of new taskbars and screens.
    const WindowPlan plan{
        .class_name = daemon_window_class,
        .title = options_.instance_name,
        .extended_style = WS_EX_TOOLWINDOW,
    };
    Result<Window> window = create_window(plan, *this);
    if (!window) {
        return std::unexpected(window.error());
    }
    daemon_ = std::move(*window);
    taskbar_created_ = ::RegisterWindowMessageW(L"TaskbarCreated");
    statistics_message_ = ::RegisterWindowMessageW(L"hyrax.statistics");
    // Explorer has fewer rights than a daemon that was started as administrator.
    ::ChangeWindowMessageFilterEx(daemon_.raw(), taskbar_created_, MSGFLT_ALLOW, nullptr);
    about_.emplace(daemon_.raw(), modal_message);
    tray_.emplace(daemon_.raw(), tray_message, shell_notify, clock_now());
    hotkeys_.emplace(daemon_.raw());
    front_.emplace(daemon_.raw());
    machine_.emplace(daemon_.raw(), clock_now(), facts_);
    autostart_.offer_restart(options_.restart_arguments);
    return {};
}

/// Windows that are destroyed still get messages; by then their handler is half gone.
Win32Desktop::~Win32Desktop() {
    closing_ = true;
}

Ticks Win32Desktop::now() {
    return clock_now();
}

std::vector<Monitor> Win32Desktop::monitors() {
    return screens_.current();
}

std::vector<DesktopWindow> Win32Desktop::windows() {
    return windows_.read();
}

void Win32Desktop::watch_windows(const WindowInterest& interest) {
    windows_.watch(interest, clock_now());
}

void Win32Desktop::present(const Frame& frame) {
    overlay_.present(frame, screens_.current(), clock_now());
    // Windows of their own: what a layered window shows, it catches clicks with.
    if (bubbles_shown_ || !frame.bubbles.empty()) {
        bubbles_.present(
            Frame{.sprites = frame.bubbles, .kept_free = frame.kept_free},
            screens_.current(),
            clock_now()
        );
        bubbles_shown_ = !frame.bubbles.empty();
    }
    if (counters_.first_frame == never && !frame.sprites.empty()) {
        counters_.first_frame = clock_now();
    }
}

DesktopCounters Win32Desktop::counters() const {
    DesktopCounters all = counters_;
    all.overlay = overlay_.counters();
    // Frames are counted once.
    const OverlayCounters bubbles = bubbles_.counters();
    all.overlay.presents += bubbles.presents;
    all.overlay.bytes += bubbles.bytes;
    all.overlay.resizes += bubbles.resizes;
    all.overlay.failures += bubbles.failures;
    return all;
}

void Win32Desktop::show_status(const Status& status) {
    tray_->set_tip(tip_text(status));
}

void Win32Desktop::answer(ClientId client, std::string_view text, Answer which) {
    if (options_.control) {
        options_.control->answer(client, text, which, clock_now());
    }
}

std::optional<Point> Win32Desktop::pointer() {
    POINT at{};
    if (::GetCursorPos(&at) == 0) {
        return std::nullopt;
    }
    return Point{static_cast<int>(at.x), static_cast<int>(at.y)};
}

void Win32Desktop::read_aside(std::unique_ptr<SpriteReading> reading) {
    worker_.begin(std::move(reading));
}

std::vector<Input> Win32Desktop::wait(Ticks deadline) {
    HYRAX_CHECK(!waiting_);
    waiting_ = true;
    while (true) {
        drain_messages();
        do_chores();
        if (!inbox_.empty() || clock_now() >= deadline) {
            break;
        }
        sleep_until(std::min(deadline, chores_due()));
    }
    waiting_ = false;
    return std::exchange(inbox_, {});
}

/// The limits keep a flood of messages from starving the frames.
void Win32Desktop::drain_messages() {
    constexpr int most = 64;
    const Ticks until = clock_now() + 4 * ticks_per_ms;
    MSG message;
    for (int i = 0; i < most && clock_now() < until; ++i) {
        if (::PeekMessageW(&message, nullptr, 0, 0, PM_REMOVE) == 0) {
            return;
        }
        if (message.message == WM_QUIT) {
            ask(request::Quit{});
        } else if (!about_->takes(message)) {
            ::TranslateMessage(&message);
            ::DispatchMessageW(&message);
        }
    }
}

Ticks Win32Desktop::chores_due() const {
    const Ticks control = options_.control ? options_.control->due() : never;
    return std::min(
        {files_.due(),
         screens_.due(),
         windows_.due(),
         overlay_.due(),
         bubbles_.due(),
         tray_->due(),
         presence_due(),
         control}
    );
}

void Win32Desktop::do_chores() {
    const Ticks time = clock_now();
    if (files_.check(time)) {
        inbox_.emplace_back(input::FilesChanged{});
    }
    if (scripts_spoke()) {
        inbox_.emplace_back(input::ScriptsHeard{});
    }
    if (worker_.done()) {
        inbox_.emplace_back(input::SpritesRead{});
    }
    if (time >= screens_.due() && screens_.settle(read_screens(), time)) {
        overlay_.forget_pixels();
        bubbles_.forget_pixels();
        inbox_.emplace_back(input::MonitorsChanged{});
    }
    if (windows_.check(time)) {
        inbox_.emplace_back(input::WindowsChanged{});
    }
    if (options_.control) {
        options_.control->serve(time, inbox_);
    }
    tray_->retry(time);
    look_around(time);
    for (Overlay* overlay : {&overlay_, &bubbles_}) {
        if (time >= overlay->due() && !overlay->present_again(screens_.current(), time)) {
            inbox_.emplace_back(input::FrameLost{});
        }
    }
}

bool Win32Desktop::scripts_spoke() const {
    return options_.scripts_event != nullptr &&
           ::WaitForSingleObject(options_.scripts_event, 0) == WAIT_OBJECT_0;
}

void Win32Desktop::sleep_until(Ticks due) {
    if (due == never) {
        alarm_.cancel();
    } else {
        alarm_.set(due - clock_now());
    }
    std::array<HANDLE, 4> events{alarm_.event(), files_.event()};
    DWORD count = 2;
    if (options_.control) {
        events[count++] = options_.control->event();
    }
    if (options_.scripts_event != nullptr) {
        events[count++] = options_.scripts_event;
    }
    // MWMO_INPUTAVAILABLE: also for messages that an earlier look at the queue has seen.
    const DWORD cause = ::MsgWaitForMultipleObjectsEx(
        count, events.data(), INFINITE, QS_ALLINPUT, MWMO_INPUTAVAILABLE
    );
    ++counters_.wakeups;
    counters_.timer_wakeups += cause == WAIT_OBJECT_0 ? 1U : 0U;
}

}  // namespace hyrax::win32
