// SPDX-License-Identifier: MIT
#include "daemon/headless/real_time_desktop.h"

#include <poll.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>

namespace hyrax {
namespace {

sigset_t watched_signals() {
    sigset_t set;
    ::sigemptyset(&set);
    for (const int number : {SIGINT, SIGTERM, SIGUSR1}) {
        ::sigaddset(&set, number);
    }
    return set;
}

timespec to_timespec(Ticks span) {
    return {.tv_sec = span / ticks_per_second, .tv_nsec = span % ticks_per_second};
}

}  // namespace

SignalWatch::SignalWatch() {
    const sigset_t set = watched_signals();
    ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
    descriptor_ = ::signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
}

SignalWatch::~SignalWatch() {
    ::close(descriptor_);
    const sigset_t set = watched_signals();
    ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

int SignalWatch::next() const {
    signalfd_siginfo info{};
    const bool came = ::read(descriptor_, &info, sizeof info) == sizeof info;
    return came ? static_cast<int>(info.ssi_signo) : 0;
}

RealTimeDesktop::RealTimeDesktop(
    std::vector<Monitor> monitors, Ticks span, std::optional<ControlSocket> control
)
    : monitors_(std::move(monitors)),
      end_(span > never - now() ? never : now() + span),
      control_(std::move(control)),
      sprites_event_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
      worker_([this] {
          constexpr std::uint64_t one = 1;
          [[maybe_unused]] const auto sent = ::write(sprites_event_.raw(), &one, sizeof one);
      }) {}

Ticks RealTimeDesktop::now() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

std::vector<Input> RealTimeDesktop::wait(Ticks deadline) {
    std::vector<Input> inbox;
    while (true) {
        const Ticks time = now();
        if (control_) {
            control_->serve(time, inbox);
        }
        if (time >= end_ || told_to_quit()) {
            inbox.emplace_back(Request{request::Quit{}});
        }
        if (time >= overlay_.due()) {
            overlay_.present_again(monitors_, time);
        }
        if (worker_.done()) {
            inbox.emplace_back(input::SpritesRead{});
        }
        if (!inbox.empty() || time >= deadline) {
            return inbox;
        }
        const Ticks control_due = control_ ? control_->due() : never;
        sleep_until(std::min({deadline, end_, overlay_.due(), control_due}), inbox);
    }
}

bool RealTimeDesktop::told_to_quit() {
    bool quit = false;
    while (const int signal = signals_.next()) {
        if (signal != SIGUSR1) {
            quit = true;
        } else if (tell_) {
            tell_();
        }
    }
    return quit;
}

void RealTimeDesktop::sleep_until(Ticks due, std::vector<Input>& inbox) {
    const Ticks time = now();
    if (due <= time) {
        return;
    }
    const int scripts = script_wire_ ? script_wire_() : -1;
    std::vector<pollfd> watched{
        {.fd = signals_.descriptor(), .events = POLLIN, .revents = 0},
        {.fd = scripts, .events = POLLIN, .revents = 0},
        {.fd = sprites_event_.raw(), .events = POLLIN, .revents = 0},
    };
    if (control_) {
        control_->poll_for(watched);
    }
    const timespec span = to_timespec(due - time);
    const int ready =
        ::ppoll(watched.data(), watched.size(), due == never ? nullptr : &span, nullptr);
    ++counters_.wakeups;
    counters_.timer_wakeups += ready == 0 ? 1U : 0U;
    if (watched[1].revents != 0) {
        inbox.emplace_back(input::ScriptsHeard{});
    }
    if (watched[2].revents != 0) {
        std::uint64_t count = 0;
        [[maybe_unused]] const auto taken = ::read(sprites_event_.raw(), &count, sizeof count);
    }
}

void RealTimeDesktop::read_aside(std::unique_ptr<SpriteReading> reading) {
    worker_.begin(std::move(reading));
}

void RealTimeDesktop::answer(ClientId client, std::string_view text, Answer which) {
    if (control_) {
        control_->answer(client, text, which, now());
    }
}

void RealTimeDesktop::present(const Frame& frame) {
    overlay_.present(frame, monitors_, now());
    if (counters_.first_frame == never && !frame.sprites.empty()) {
        counters_.first_frame = now();
    }
}

DesktopCounters RealTimeDesktop::counters() const {
    DesktopCounters all = counters_;
    all.overlay = overlay_.counters();
    return all;
}

}  // namespace hyrax
