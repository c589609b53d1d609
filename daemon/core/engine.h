// SPDX-License-Identifier: MIT
// The pets and the arena. Knows no clock, file, window or script: verbs come in, pets move.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/collisions.h"
#include "daemon/core/event.h"
#include "daemon/core/ledges.h"
#include "daemon/core/pet.h"
#include "daemon/core/quota.h"
#include "daemon/core/result.h"
#include "daemon/core/slot_map.h"
#include "daemon/core/spaces.h"
#include "physics/body.h"
#include "physics/spring.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hyrax {

/// A sort of pet, as far as its motion depends on it.
struct Kind {
    std::string name;
    Size box;                    ///< What meets walls and floor at scale 1 [px], positive.
    double scale = 1.0;          ///< least_scale to most_scale.
    bool whole_scale = false;    ///< Pixel art: all scales together are rounded to 1, 2, 3 ...
    double largest_scale = 8.0;  ///< All scales together are held below: its pictures are large.
    std::vector<std::string> animations{};  ///< Names of what it can play.
};

/// Of a pet, of a kind, of the settings.
inline constexpr double least_scale = 0.25;
inline constexpr double most_scale = 4.0;
/// Fainter, a pet could be lost.
inline constexpr double least_opacity = 0.1;
/// Of an animation that is played at a rate of its own [frames/s].
inline constexpr double least_fps = 0.1;
inline constexpr double most_fps = 120.0;
inline constexpr double longest_speech = 3600.0;  ///< [s]
/// All scales together are held above this.
inline constexpr double least_drawn_scale = 0.125;

struct EngineSettings {
    PhysicsConstants physics{};
    Integrator integrator = Integrator::event_driven;
    double reference_rate = default_reference_rate;  ///< Frames a second of the multipliers.
    double fixed_rate = 240.0;   ///< Steps a second of semi_implicit_euler_fixed.
    ForceField forces{};         ///< Any but none makes rk45 the integrator.
    SpringConstants hand{};      ///< Holds a grabbed pet on the pointer.
    std::size_t max_pets = 100;  ///< Population cap on every path that spawns.
    /// New pets a second on every path, after max_pets and this many at once.
    double max_spawn_rate = 100.0;
    double max_speed = 20'000.0;  ///< Velocities set from outside are shortened to this [px/s].
    double scale = 1.0;           ///< Of all pets, least_scale to most_scale.
    bool scale_with_dpi = true;   ///< Pets grow with the scale of the monitor under their feet.
    bool operator==(const EngineSettings&) const = default;
};

/// How much there is to do, and what has been done.
struct EngineReport {
    std::size_t awake = 0;
    std::size_t asleep = 0;
    std::uint64_t contacts = 0;  ///< Impacts, edges and stops since the start.
    /// Kinetic and potential energy of all pets per unit of mass, above the lowest floor
    /// [px^2/s^2].
    double energy = 0.0;
};

struct SpawnOptions {
    std::string kind = "hyrax";
    std::optional<Vec2> at{};  ///< Top-left corner [px]; without it, somewhere along a top edge.
    Vec2 velocity{};           ///< [px/s]
    std::string owner = "user";
    std::string tag{};
    double scale = 1.0;    ///< least_scale to most_scale
    double opacity = 1.0;  ///< least_opacity to 1
};

/// Fails on a number that is not finite; the message names the verb.
[[nodiscard]] Result<void> require_finite(Vec2 v, std::string_view verb);

/// Fails on a scale that is not from least_scale to most_scale; the message names the verb.
[[nodiscard]] Result<void> require_scale(double scale, std::string_view verb);

/// The same for an opacity that is not from least_opacity to 1.
[[nodiscard]] Result<void> require_opacity(double opacity, std::string_view verb);

/// To whole pixels, at least one a side.
Size scaled(Size size, double scale);

/// Owned by one thread. Every verb that fails changes nothing; it fails on a stale id, on numbers
/// that are not finite, on an unknown kind, on a full population, too many new pets a second and
/// while no monitor is known. A held pet belongs to the hand: fling, push, stop, reset and move_to
/// leave it as it is.
class Engine {
public:
    /// `seed` decides where pets appear that are spawned without a position.
    Engine(std::vector<Kind> kinds, const EngineSettings& settings, std::uint32_t seed);

    [[nodiscard]] Result<PetId> spawn(const SpawnOptions& options);
    [[nodiscard]] Result<void> remove(PetId id);
    /// Sets the velocity [px/s], as if thrown by hand (the document's setVelocity).
    [[nodiscard]] Result<void> fling(PetId id, Vec2 velocity);
    /// Adds to the velocity [px/s].
    [[nodiscard]] Result<void> push(PetId id, Vec2 impulse);
    /// Both velocity components become zero (the document's resetVelocity).
    [[nodiscard]] Result<void> stop(PetId id);
    /// Back to where it was spawned, at rest.
    [[nodiscard]] Result<void> reset(PetId id);
    /// Puts the top-left corner there, or as near as the arena allows; keeps the velocity.
    [[nodiscard]] Result<void> move_to(PetId id, Vec2 position);
    [[nodiscard]] Result<void> set_tag(PetId id, std::string tag);
    /// least_scale to most_scale. The feet, which are the middle of the box's bottom edge, stay
    /// where they are, or as near as the arena allows; a held pet's in any case.
    [[nodiscard]] Result<void> set_scale(PetId id, double scale);
    /// least_opacity to 1, beside that of the settings.
    [[nodiscard]] Result<void> set_opacity(PetId id, double opacity);

    /// Walks along the floor, once it is on one, until the left edge of its box is at `x` [px], or
    /// until a wall, the edge of the floor, a hand or another verb ends it. `speed` > 0 [px/s].
    [[nodiscard]] Result<void> walk_to(PetId id, double x, double speed);
    /// Shows an animation of its kind: once, or, in a loop, until the pet is grabbed or set in
    /// motion, or plays another.
    [[nodiscard]] Result<void> play(PetId id, Playing playing);
    /// Shows the text above it for so long [s]; an empty text ends that.
    [[nodiscard]] Result<void> say(PetId id, std::string text, double seconds);
    /// While it moves, a pet faces where it goes.
    [[nodiscard]] Result<void> face(PetId id, bool left);

    /// Picks a pet up: a spring pulls it to where carry() says, until let_go(). Times are the
    /// hand's own: they go on while the pets' time is paused.
    [[nodiscard]] Result<void> grab(PetId id, Ticks time);
    [[nodiscard]] Result<void> carry(PetId id, Vec2 position, Ticks time);
    /// The pet flies on as the spring moved it, at most at `max_speed` [px/s].
    [[nodiscard]] Result<void> let_go(PetId id, Ticks time, double max_speed);
    void click(PetId id, Button button);

    void reset_all();
    void clear();
    /// Throws every pet upwards in a direction of its own.
    void fling_all();
    /// Puts every pet that no hand holds along the top of the place, or as near as the arena
    /// allows, at rest: they fall in.
    void gather(const Rect& place);

    /// Moves every pet that is awake to `now`. A pet's first frame shows it where it was put. A
    /// time before the last one changes nothing.
    void advance(Ticks now);
    /// True while a further advance() would change something.
    bool moving() const { return !awake_.empty(); }
    /// Moves the pets that a hand holds; `time` is the hand's. True while they swing.
    bool advance_held(Ticks time);

    /// Pets whose middle lies in one of these areas stand still, and later go on as if
    /// no time had passed. A held pet belongs to the hand; a pet that flies into an
    /// area stops there.
    void freeze(std::vector<Rect> areas, Ticks now);

    /// Pets outside the new arena move to the nearest place in it; nobody is lost.
    void set_arena(Arena arena);
    const Arena& arena() const { return arena_; }
    /// What else pets stand on. Who stands on a window that has moved gently moves with it; who has
    /// lost his footing falls; who flies flies on, to the bit where nothing changes that it meets.
    /// semi_implicit_euler knows no ledges.
    void set_ledges(std::vector<LedgeSegment> ledges);
    const std::vector<LedgeSegment>& ledges() const { return ledges_; }
    /// The windows that pets stand on, or will come down on within half a second, as far as that is
    /// known beforehand; sorted.
    std::vector<std::uint64_t> windows_underfoot() const;
    /// True if a pet may come onto a ledge before anything happens from outside.
    bool may_meet_ledges() const { return knows_ledges() && (moving() || !held_.empty()); }
    /// Takes effect with the next frame, for pets in flight as well. Fails, and changes nothing, on
    /// constants that no law can have.
    [[nodiscard]] Result<void> configure(const EngineSettings& settings);
    const EngineSettings& settings() const { return settings_; }
    /// Beside that of the settings [px/s]; nothing ends it. Drag, which there must be, acts on the
    /// velocity relative to it, in the air only. Who flies flies on from where he is.
    [[nodiscard]] Result<void> set_wind(Vec2 wind);
    Vec2 wind() const { return wind_; }
    /// The one that moves the pets: the settings', or rk45 where forces ask for it.
    Integrator integrator() const { return rules_.integrator; }

    const std::vector<Kind>& kinds() const { return kinds_; }
    /// Replaces the kinds, at least one; pets whose kind is gone become the first one.
    void set_kinds(std::vector<Kind> kinds);
    const Pet* find(PetId id) const { return pets_.find(id); }
    /// The pet's box at its scale [px].
    Size box_of(const Pet& pet) const { return spaces_.box(pet.space); }
    /// The box of a pet of this kind whose own scale is 1, on a screen whose scale is 1 [px].
    Size usual_box(const Kind& kind) const;
    std::size_t sizes_in_use() const { return spaces_.size(); }
    std::size_t size() const { return pets_.size(); }
    std::size_t awake_count() const { return awake_.size(); }
    /// Calls visit(id, pet) in drawing order, the topmost last.
    template <typename Visit>
    void for_each(Visit visit) const {
        pets_.for_each(visit);
    }

    EngineReport report() const;

    void listen(EventMask mask);
    bool has_events() const { return !events_.empty(); }
    /// The events since the last call, oldest first.
    std::vector<Event> take_events();
    /// The same for a second listener, with a list of its own.
    void watch(EventMask mask);
    std::vector<Event> take_watched() { return std::exchange(watched_, {}); }

private:
    struct Held {
        PetId pet;
        Spring spring;
        Vec2 grown{};  ///< By how much the corner has moved off as the pet changed its size [px].
    };

    template <typename Act>
    [[nodiscard]] Result<void> change(PetId id, std::string_view verb, Vec2 numbers, Act act);
    std::optional<std::size_t> kind_named(std::string_view name) const;
    Surroundings around(const Pet& pet) const {
        return {spaces_[pet.space], pet.home, spaces_.box(pet.space)};
    }
    Held* held(PetId id);
    // engine_size.cpp
    double drawn_scale(const Kind& kind, double more) const;
    double drawn_scale(const Pet& pet) const;
    Vec2 feet(const Pet& pet) const;
    void size_up(Pet& pet, Vec2 position);
    bool fit(PetId id, Pet& pet);
    bool refit(PetId id, Pet& pet);
    void put(PetId id, Pet& pet, Vec2 position);
    void follow_screen(PetId id, Pet& pet, Ticks own);
    void mind_screens();
    // engine_ledges.cpp
    struct Footing;
    bool knows_ledges() const;
    BodyState state_in_space(const Pet& pet) const;
    Contact next_contact_of(const Pet& pet) const;
    const LedgeSegment* ledge_at(const Pet& pet, Vec2 at) const;
    const LedgeSegment* ledge_under(const Pet& pet) const;
    const LedgeSegment* ledge_ahead(const Pet& pet) const;
    void lay_ledges();
    void find_footing(const Footing& before, Pet& pet);

    void place(Pet& pet, Vec2 position);
    void relaunch(Pet& pet, Vec2 velocity);
    void set_in_motion(PetId id, Pet& pet, Vec2 velocity);
    void launch(PetId id, Pet& pet, Vec2 velocity);
    void put_back(PetId id, Pet& pet);
    void move_into_arena(PetId id, Pet& pet, bool disturbed);
    void advance(PetId id, Pet& pet, Ticks now);
    bool in_frozen_area(const Pet& pet) const;
    Ticks own_time(const Pet& pet) const { return std::min(now_, pet.frozen_at) - pet.lost; }
    void refresh_frozen(PetId id, Pet& pet);
    void thaw(PetId id, Pet& pet);
    void meet(PetId id, Pet& pet, const TrajectoryEvent& event);
    Result<Pet*> pet_for(PetId id, std::string_view verb, Vec2 numbers);
    // engine_walk.cpp
    bool walks(PetId id, Pet& pet, Ticks now);
    void begin_walk(Pet& pet, Ticks time, Vec2 from);
    std::optional<Walk> way_to_target(const Pet& pet, Vec2 from) const;
    bool walk_is_outdated(const Pet& pet) const;
    void end_walk(Pet& pet);
    void find_collisions();
    bool is_heard(EventKind kind) const { return listening_.has(kind) || watching_.has(kind); }
    WallEvents wall_events() const {
        return is_heard(EventKind::bounce) ? WallEvents::wanted : WallEvents::not_wanted;
    }
    Vec2 capped(Vec2 velocity) const;
    // engine_spawn.cpp
    Vec2 random_entrance();
    double random_unit();
    void emit(const Event& event);

    std::vector<Kind> kinds_;
    EngineSettings settings_;
    Vec2 wind_{};
    MotionRules rules_;
    Arena arena_;
    std::vector<LedgeSegment> ledges_;  // The topmost window's first.
    Spaces spaces_;
    bool screens_differ_ = false;  // A pet may change its size as it moves.
    SlotMap<Pet> pets_;
    std::vector<PetId> awake_;
    std::vector<Held> held_;
    std::vector<Rect> frozen_areas_;
    std::vector<Event> events_;
    EventMask listening_;
    std::vector<Event> watched_;
    EventMask watching_;
    Collisions collisions_;
    std::uint64_t contacts_ = 0;
    Quota spawns_;
    std::minstd_rand random_;
    Ticks now_ = 0;
};

}  // namespace hyrax
