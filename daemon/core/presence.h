// SPDX-License-Identifier: MIT
// Where and how lively pets may be just now, so that they are in nobody's way. Pure: facts and
// settings come in, decisions come out.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/facts.h"
#include "physics/ticks.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hyrax {

/// What happens to pets on a screen that a program fills.
enum class FullScreenAct {
    hide,             ///< They stand still and no window of ours is on that screen.
    pause,            ///< They stand still.
    stay,             ///< Nothing.
    hide_everywhere,  ///< No window of ours exists anywhere. In rules alone.
};

/// For one program. All but hide_everywhere count only while it fills a screen.
struct FullScreenRule {
    std::string program;  ///< File name such as "game.exe"; case does not matter.
    FullScreenAct act = FullScreenAct::hide;
    bool operator==(const FullScreenRule&) const = default;
};

enum class OnResume { go_on, catch_up };
enum class ReducedMotion { automatic, on, off };

struct PresenceSettings {
    FullScreenAct full_screen = FullScreenAct::hide;
    std::vector<FullScreenRule> rules{};
    double fps_on_battery = 30.0;  ///< [frames/s]
    double fps_saving = 15.0;      ///< With the battery saver, or over a remote session [frames/s].
    OnResume on_resume = OnResume::go_on;
    ReducedMotion reduced_motion = ReducedMotion::automatic;
    bool hide_from_capture = false;
    bool operator==(const PresenceSettings&) const = default;
};

struct Decisions {
    std::vector<Rect> kept_free;  ///< Bounds of the monitors on which no window may be.
    std::vector<Rect> frozen;     ///< Bounds of those on which pets stand still.
    bool windowless = false;      ///< No window may exist.
    bool unseen = false;          ///< Nobody sees the session: draw nothing, wake for nothing.
    bool world_stands = false;    ///< The time of pets and scripts stands still.
    double fps = infinity;        ///< Upper bound, whatever the monitors show [frames/s].
    bool calm = false;            ///< Reduced motion: nothing moves unless somebody moves it.
    std::string note{};           ///< One line on why pets are not as usual; else empty.
    bool operator==(const Decisions&) const = default;
};

/// Whether the window fills the monitor, so that whoever looks at it wants to see nothing else.
bool fills(const FrontWindow& window, const Monitor& monitor);

class Presence {
public:
    void set_settings(PresenceSettings settings) { settings_ = std::move(settings); }
    void set_monitors(std::span<const Monitor> monitors);
    void set_facts(Facts facts) { facts_ = std::move(facts); }

    /// What holds from `now` on. A screen is taken to be filled after 300 ms of it, and free after
    /// a second: programs that switch modes, and users that switch windows, flicker.
    const Decisions& decide(Ticks now);
    const Decisions& decisions() const { return decisions_; }
    /// When decide() may say something else though nothing new is told; else `never`.
    Ticks due() const;
    /// Something is in the way, or just was: the system may not tell when it ends.
    bool wary() const;
    /// Of the fastest of those monitors that have one of these places on them; infinite where one
    /// of them does not tell, or where there is none [frames/s].
    double refresh_rate_at(std::span<const Rect> places) const;
    /// Of the slowest monitor that tells; infinite where none does [frames/s].
    double least_refresh_rate() const;
    /// Whether the user may be shown a notice now: nobody fills a screen, somebody looks.
    bool may_disturb() const;

    const Facts& facts() const { return facts_; }
    /// Whether some rule needs the name of the program in front.
    bool asks_for_programs() const { return !settings_.rules.empty(); }

private:
    /// What holds on a place, and what will if it lasts.
    struct Watched {
        Monitor monitor;
        FullScreenAct act = FullScreenAct::stay;
        FullScreenAct wanted = FullScreenAct::stay;
        Ticks since = 0;  ///< Of `wanted`.
    };

    FullScreenAct wanted_on(const Monitor& monitor) const;
    FullScreenAct act_for(const FrontWindow& window) const;
    const FullScreenRule* rule_for(const FrontWindow& window) const;
    const FrontWindow* front() const;
    bool works_on(const Monitor& monitor) const;
    static Ticks switches_at(const Watched& place);
    static void settle(Watched& place, FullScreenAct wanted, Ticks now);
    std::string note_on(const Decisions& decisions) const;

    PresenceSettings settings_;
    Facts facts_;
    std::vector<Watched> monitors_;
    Watched everywhere_;  ///< hide_everywhere or stay.
    Decisions decisions_;
};

}  // namespace hyrax
