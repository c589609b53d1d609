// SPDX-License-Identifier: MIT
// The daemon's ears: what inputs and requests ask of the engine.
#include "daemon/core/daemon.h"
#include "daemon/core/log_failure.h"

#include <spdlog/spdlog.h>

#include <utility>

namespace hyrax {

void Daemon::handle(const Input& input) {
    if (ended_) {
        return;
    }
    std::visit([this](const auto& which) { on(which); }, input);
    changed_ = true;
}

void Daemon::on(const input::Pressed& pressed) {
    const std::optional<PetId> id = pet_at(frame_, pressed.at);
    const Pet* pet = id ? engine_.find(*id) : nullptr;
    if (pet == nullptr) {
        return;
    }
    if (pressed.button != Button::left) {
        menu_pet_ = pressed.button == Button::right ? id : std::nullopt;
        engine_.click(*id, pressed.button);
        return;
    }
    let_go(desktop_.now(), 0.0);
    const Vec2 pointer{static_cast<double>(pressed.at.x), static_cast<double>(pressed.at.y)};
    hand_.take(*id, pet->position() - pointer, pressed.at, pressed.time);
    log_failure(engine_.grab(*id, pressed.time));
}

void Daemon::on(const input::Moved& moved) {
    const std::optional<PetId> held = hand_.pet();
    if (!held || !hand_.move(moved.at)) {
        return;
    }
    // A script may have removed the pet out of the hand.
    if (!engine_.carry(*held, hand_.carried_to(), moved.time)) {
        hand_.drop();
    }
}

void Daemon::on(const input::Released& released) {
    if (released.button == Button::right) {
        const std::optional<PetId> pet = std::exchange(menu_pet_, std::nullopt);
        if (pet && pet_at(frame_, released.at) == pet) {
            open_pet_menu(*pet, released.at);
        }
    }
    const std::optional<PetId> held = hand_.pet();
    if (!held || released.button != Button::left) {
        return;
    }
    on(input::Moved{released.at, released.time});
    const bool clicked = hand_.was_click(released.time);
    let_go(released.time, clicked ? 0.0 : config_.max_throw_speed);
    if (clicked) {
        engine_.click(*held, Button::left);
    }
}

void Daemon::on(const input::PointerLost&) {
    let_go(desktop_.now(), 0.0);
}

void Daemon::on(const input::MonitorsChanged&) {
    let_go(desktop_.now(), 0.0);
    use_monitors();
}

void Daemon::on(const input::FrameLost&) {
    frame_lost_ = true;
}

void Daemon::on(const input::FilesChanged&) {
    read_config();
    follow_files();
}

void Daemon::on(const input::ScriptsHeard&) {
    scripts_.watch(desktop_.now());
}

void Daemon::on(const input::Asked& asked) {
    control_.answer(*this, desktop_, asked);
}

void Daemon::on(const input::Left& left) {
    control_.forget(engine_, left.client);
}

void Daemon::on(const Request& request) {
    std::visit([this](const auto& which) { carry_out(which); }, request);
}

void Daemon::carry_out(const request::Spawn& spawn) {
    for (int i = 0; i < spawn.count; ++i) {
        if (const Result<PetId> id = engine_.spawn({.kind = spawn.kind}); !id) {
            spdlog::warn("{}", id.error().message);
            return;
        }
    }
}

void Daemon::carry_out(const request::FlingAll&) {
    engine_.fling_all();
}

void Daemon::carry_out(const request::ResetAll&) {
    engine_.reset_all();
}

void Daemon::carry_out(const request::RemoveAll&) {
    hand_.drop();
    engine_.clear();
}

void Daemon::carry_out(const request::Reload&) {
    if (!read_config()) {
        hotkeys_.use(desktop_, config_.hotkeys);  // Those that could not be had may be free now.
    }
    read_plugins();
    read_kinds();
    scripts_.renew();
    all_scripts_anew_ = true;
    load_wanted_scripts();
}

void Daemon::carry_out(const request::Quit&) {
    quitting_ = true;
}

void Daemon::let_go(Ticks time, double max_speed) {
    if (const std::optional<PetId> held = hand_.pet()) {
        hand_.drop();
        if (engine_.find(*held) != nullptr) {
            log_failure(engine_.let_go(*held, time, max_speed));
        }
    }
}

}  // namespace hyrax
