// SPDX-License-Identifier: MIT
// How large and how opaque a pet is. Of the size: its own scale, its kind's, the settings' and that
// of its screen. Whatever changes them, the feet stay where they are.
#include "daemon/core/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hyrax {

Result<void> require_scale(double scale, std::string_view verb) {
    if (scale >= least_scale && scale <= most_scale) {
        return {};
    }
    return failure(fmt::format(
        "{}: expected a scale from {} to {}, got {}", verb, least_scale, most_scale, scale
    ));
}

Result<void> require_opacity(double opacity, std::string_view verb) {
    if (opacity >= least_opacity && opacity <= 1.0) {
        return {};
    }
    return failure(
        fmt::format("{}: expected an opacity from {} to 1, got {}", verb, least_opacity, opacity)
    );
}

Size scaled(Size size, double scale) {
    const auto side = [scale](int length) {
        return std::max(1, static_cast<int>(std::lround(length * scale)));
    };
    return {side(size.width), side(size.height)};
}

Result<void> Engine::set_scale(PetId id, double scale) {
    Pet* const pet = pets_.find(id);
    if (pet == nullptr) {
        return failure("set_scale: this pet is gone");
    }
    if (auto checked = require_scale(scale, "set_scale"); !checked) {
        return checked;
    }
    pet->scale = scale;
    if (refit(id, *pet) && pet->motion != Motion::held) {
        set_in_motion(id, *pet, pet->velocity());
    }
    return {};
}

Result<void> Engine::set_opacity(PetId id, double opacity) {
    Pet* const pet = pets_.find(id);
    if (pet == nullptr) {
        return failure("set_opacity: this pet is gone");
    }
    if (auto checked = require_opacity(opacity, "set_opacity"); !checked) {
        return checked;
    }
    pet->opacity = opacity;
    return {};
}

Size Engine::usual_box(const Kind& kind) const {
    return scaled(kind.box, drawn_scale(kind, 1.0));
}

double Engine::drawn_scale(const Kind& kind, double more) const {
    const double all =
        std::clamp(settings_.scale * kind.scale * more, least_drawn_scale, kind.largest_scale);
    return kind.whole_scale ? std::max(1.0, std::round(all)) : all;
}

double Engine::drawn_scale(const Pet& pet) const {
    const bool with_screen = settings_.scale_with_dpi && pet.screen < arena_.boxes().size();
    const double screen = with_screen ? arena_.scale(pet.screen) : 1.0;
    return drawn_scale(kinds_[pet.kind], pet.scale * screen);
}

Vec2 Engine::feet(const Pet& pet) const {
    const Size box = box_of(pet);
    return pet.position() + Vec2{box.width / 2.0, static_cast<double>(box.height)};
}

// The first size of a pet that is put at this place.
void Engine::size_up(Pet& pet, Vec2 position) {
    pet.screen = arena_.index_near(position);
    pet.drawn_scale = drawn_scale(pet);
    pet.space = spaces_.acquire(scaled(kinds_[pet.kind].box, pet.drawn_scale));
}

// Gives the pet the size that is due. True if that is another one: the corner has moved off.
bool Engine::fit(PetId id, Pet& pet) {
    pet.drawn_scale = drawn_scale(pet);
    const Size before = box_of(pet);
    const Size box = scaled(kinds_[pet.kind].box, pet.drawn_scale);
    if (box == before) {
        return false;
    }
    const std::size_t space = spaces_.acquire(box);
    spaces_.release(pet.space);
    pet.space = space;
    const Vec2 grown{
        (before.width - box.width) / 2.0, static_cast<double>(before.height - box.height)
    };
    pet.shown.position = pet.shown.position + grown;
    if (Held* const hand = held(id)) {
        hand->grown = hand->grown + grown;
    }
    return true;
}

// The same, within the arena.
bool Engine::refit(PetId id, Pet& pet) {
    if (!fit(id, pet)) {
        return false;
    }
    if (!arena_.empty() && pet.motion != Motion::held) {
        place(pet, pet.position());
    }
    return true;
}

// Puts the corner there, in the size that is due there.
void Engine::put(PetId id, Pet& pet, Vec2 position) {
    if (screens_differ_) {
        pet.shown.position = position;
        pet.screen = arena_.screen_of(feet(pet), pet.screen);
        fit(id, pet);
    }
    place(pet, position);
}

// After a frame. Between frames the feet's path is the same in either size, so that only a wall
// met in this very frame depends on when it begins.
// Within a frame, whose list of pets must stay as it is.
void Engine::follow_screen(PetId id, Pet& pet, Ticks own) {
    const std::size_t screen = arena_.screen_of(feet(pet), pet.screen);
    if (screen == pet.screen) {
        return;
    }
    pet.screen = screen;
    if (refit(id, pet) && pet.motion != Motion::held) {
        relaunch(pet, pet.velocity());
        pet.body.start(own);
        pet.started = true;
        pet.shown.mode = Mode::air;
    }
}

void Engine::mind_screens() {
    screens_differ_ = settings_.scale_with_dpi && arena_.has_mixed_scales();
}

}  // namespace hyrax
