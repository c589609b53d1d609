// SPDX-License-Identifier: MIT
// How the daemon keeps out of the way: what presence.h decides, carried out.
#include "daemon/core/daemon.h"
#include "daemon/core/dirty.h"

#include <algorithm>

namespace hyrax {

void Daemon::on(const input::FactsChanged& changed) {
    presence_.set_facts(changed.facts);
    heed_presence(changed.time);
}

/// Only a trajectory can be read at a moment hours ahead; the others would have to step there.
void Daemon::use_presence_settings() {
    PresenceSettings settings = config_.presence;
    if (engine_.integrator() != Integrator::event_driven) {
        settings.on_resume = OnResume::go_on;
    }
    presence_.set_settings(std::move(settings));
}

/// Pauses take effect at the moment of their input: the frame after it may be hours away.
void Daemon::heed_presence(Ticks now) {
    const Decisions before = presence_.decisions();
    const Decisions& so = presence_.decide(now);
    clock_.set_paused(paused_ || remembered_.hidden || so.world_stands, now);
    if ((so.unseen && !before.unseen) || (so.windowless && !before.windowless)) {
        let_go(now, 0.0);
    }
    engine_.freeze(so.frozen, clock_.at(now));
    scripts_.set_calm(so.calm);
    pacer_.set_rate(frame_rate());
}

/// What the settings allow, and the monitors show on which pets are [frames/s].
double Daemon::frame_rate() const {
    const double most = std::min(config_.fps, presence_.decisions().fps);
    if (most <= presence_.least_refresh_rate()) {
        return most;
    }
    return std::min(most, presence_.refresh_rate_at(places_of(frame_)));
}

void Daemon::choose_conduct(bool moving, bool animated) {
    const Decisions& so = presence_.decisions();
    Conduct conduct{
        .front = Watch::events,
        .name_programs = presence_.asks_for_programs(),
        .hide_from_capture = config_.presence.hide_from_capture,
        .let_go = so.windowless || so.unseen || remembered_.hidden || click_through(),
        .click_through = click_through(),
        .resting = !moving && !hand_.pet(),
        .dragging = hand_.pet().has_value(),
        .layer = config_.layer,
    };
    if (so.unseen || remembered_.hidden || engine_.size() == 0) {
        conduct.front = Watch::off;
    } else if (moving || animated || presence_.wary()) {
        conduct.front = Watch::closely;
    }
    if (conduct != conduct_) {
        conduct_ = conduct;
        desktop_.follow(conduct_);
    }
}

}  // namespace hyrax
