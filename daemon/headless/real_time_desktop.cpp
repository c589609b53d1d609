// SPDX-License-Identifier: MIT
#include "daemon/headless/real_time_desktop.h"

#include "daemon/headless/system_error.h"

#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace hyrax {
namespace {

Result<FileDescriptor> end_signals() {
    sigset_t set;
    ::sigemptyset(&set);
    ::sigaddset(&set, SIGINT);
    ::sigaddset(&set, SIGTERM);
    if (::sigprocmask(SIG_BLOCK, &set, nullptr) != 0) {
        return system_failure("cannot hold back signals");
    }
    FileDescriptor signals(::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK));
    if (!signals) {
        return system_failure("cannot wait for signals");
    }
    return signals;
}

}  // namespace

Result<std::unique_ptr<RealTimeDesktop>> RealTimeDesktop::create(
    std::vector<Monitor> monitors, Ticks span, ControlSocket control
) {
    Result<FileDescriptor> signals = end_signals();
    if (!signals) {
        return std::unexpected(signals.error());
    }
    std::unique_ptr<RealTimeDesktop> desktop(
        new RealTimeDesktop(std::move(monitors), *std::move(signals), std::move(control))
    );
    const Ticks begin = desktop->now();
    desktop->end_ = span > never - begin ? never : begin + span;
    return desktop;
}

RealTimeDesktop::RealTimeDesktop(
    std::vector<Monitor> monitors, FileDescriptor signals, ControlSocket control
)
    : monitors_(std::move(monitors)), signals_(std::move(signals)), control_(std::move(control)) {}

Ticks RealTimeDesktop::now() {
    const auto since_boot = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(since_boot).count();
}

std::vector<Input> RealTimeDesktop::wait(Ticks deadline) {
    std::vector<Input> inbox;
    while (true) {
        const Ticks time = now();
        control_.serve(time, inbox);
        if (time >= end_ || was_signalled()) {
            inbox.emplace_back(Request{request::Quit{}});
        }
        if (!inbox.empty() || time >= deadline) {
            return inbox;
        }
        sleep_until(std::min({deadline, end_, control_.due()}));
    }
}

void RealTimeDesktop::present(const Frame& frame) {
    frame_ = frame;
    ++presents_;
}

void RealTimeDesktop::answer(ClientId client, std::string_view text, Answer which) {
    control_.answer(client, text, which, now());
}

void RealTimeDesktop::sleep_until(Ticks deadline) {
    std::vector<pollfd> entries{{signals_.raw(), POLLIN, 0}};
    control_.poll_for(entries);
    const Ticks span = std::max<Ticks>(0, deadline - now());
    const timespec timeout{span / ticks_per_second, span % ticks_per_second};
    ::ppoll(entries.data(), entries.size(), deadline == never ? nullptr : &timeout, nullptr);
}

bool RealTimeDesktop::was_signalled() const {
    signalfd_siginfo signal{};
    return ::read(signals_.raw(), &signal, sizeof signal) > 0;
}

}  // namespace hyrax
