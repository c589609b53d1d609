// SPDX-License-Identifier: MIT
// The verbs about pets.
#include "daemon/control/verb.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

using json = nlohmann::ordered_json;

constexpr Range places{-1e6, 1e6};
constexpr Range speeds{-1e7, 1e7};

constexpr Parameter one_pet{
    .name = "pet", .type = ParameterType::pet, .help = "Only this one.", .positional = true
};
constexpr Parameter of_kind{.name = "kind", .help = "Only pets of this kind."};
constexpr Parameter with_tag{.name = "tag", .help = "Only pets with this tag."};

constexpr Parameter velocity_x{
    .name = "vx",
    .type = ParameterType::number,
    .help = "Velocity to the right.",
    .range = speeds,
    .unit = "px/s",
};
constexpr Parameter velocity_y{
    .name = "vy",
    .type = ParameterType::number,
    .help = "Velocity downwards; a negative one throws up.",
    .range = speeds,
    .unit = "px/s",
};

std::string text_or(const json& arguments, const char* name, const char* otherwise) {
    return arguments.value(name, std::string(otherwise));
}

double number_or_0(const json& arguments, const char* name) {
    return arguments.value(name, 0.0);
}

Vec2 velocity_of(const json& arguments) {
    return {number_or_0(arguments, "vx"), number_or_0(arguments, "vy")};
}

bool chooses(const json& arguments) {
    return arguments.contains("pet") || arguments.contains("kind") || arguments.contains("tag");
}

using Chosen = std::expected<std::vector<PetId>, Refusal>;

// Without a choice: all of them.
Chosen chosen(const Engine& engine, const json& arguments) {
    const std::string kind = text_or(arguments, "kind", "");
    const std::string tag = text_or(arguments, "tag", "");
    std::optional<PetId> only;
    if (arguments.contains("pet")) {
        only = pet_from_text(arguments["pet"].get<std::string>());
        if (!only || engine.find(*only) == nullptr) {
            return std::unexpected(
                Refusal{"no_such_pet", fmt::format("there is no pet {}", arguments["pet"].dump())}
            );
        }
    }
    std::vector<PetId> ids;
    engine.for_each([&](PetId id, const Pet& pet) {
        const bool fits = (!only || id == *only) &&
                          (kind.empty() || engine.kinds()[pet.kind].name == kind) &&
                          (tag.empty() || pet.tag == tag);
        if (fits) {
            ids.push_back(id);
        }
    });
    return ids;
}

template <typename Act>
Outcome with_chosen(VerbContext& context, const json& arguments, Act act) {
    Engine& engine = context.daemon.engine();
    const Chosen ids = chosen(engine, arguments);
    if (!ids) {
        return std::unexpected(ids.error());
    }
    for (const PetId id : *ids) {
        if (const Result<void> done = act(engine, id); !done) {
            return std::unexpected(Refusal{"refused", done.error().message});
        }
    }
    return json{{"pets", ids->size()}};
}

// All or none.
Outcome spawn(VerbContext& context, const json& arguments) {
    if (arguments.contains("x") != arguments.contains("y")) {
        return std::unexpected(Refusal{"bad_request", "x and y are only allowed together"});
    }
    SpawnOptions options{
        .kind = text_or(arguments, "kind", "hyrax"),
        .velocity = velocity_of(arguments),
        .tag = text_or(arguments, "tag", ""),
    };
    if (arguments.contains("x")) {
        options.at = Vec2{number_or_0(arguments, "x"), number_or_0(arguments, "y")};
    }
    Engine& engine = context.daemon.engine();
    std::vector<PetId> spawned;
    for (int i = arguments.value("count", 1); i > 0; --i) {
        const Result<PetId> id = engine.spawn(options);
        if (!id) {
            for (const PetId pet : spawned) {
                static_cast<void>(engine.remove(pet));
            }
            return std::unexpected(Refusal{"refused", id.error().message});
        }
        spawned.push_back(*id);
    }
    json pets = json::array();
    for (const PetId pet : spawned) {
        pets.push_back(pet_text(pet));
    }
    return json{{"pets", std::move(pets)}};
}

Outcome fling(VerbContext& context, const json& arguments) {
    Engine& engine = context.daemon.engine();
    if (!arguments.contains("vx") && !arguments.contains("vy")) {
        if (chooses(arguments)) {
            return std::unexpected(
                Refusal{"bad_request", "vx or vy must tell how fast the chosen pets are to fly"}
            );
        }
        engine.fling_all();
        return json{{"pets", engine.size()}};
    }
    const Vec2 velocity = velocity_of(arguments);
    return with_chosen(context, arguments, [velocity](Engine& e, PetId id) {
        return e.fling(id, velocity);
    });
}

Outcome reset(VerbContext& context, const json& arguments) {
    return with_chosen(context, arguments, [](Engine& e, PetId id) { return e.reset(id); });
}

Outcome stop(VerbContext& context, const json& arguments) {
    return with_chosen(context, arguments, [](Engine& e, PetId id) { return e.stop(id); });
}

Outcome remove(VerbContext& context, const json& arguments) {
    return with_chosen(context, arguments, [](Engine& e, PetId id) { return e.remove(id); });
}

const char* state_of(const Pet& pet) {
    switch (pet.motion) {
        case Motion::airborne:
            return "airborne";
        case Motion::settled:
            return pet.awake ? "sliding" : "at rest";
        case Motion::held:
            return "held";
        case Motion::walking:
            return "walking";
    }
    std::unreachable();
}

// Hundredths of a pixel are enough for people and for scripts.
double rounded(double value) {
    return std::round(value * 100.0) / 100.0;
}

json description_of(const Engine& engine, PetId id) {
    const Pet& pet = *engine.find(id);
    return {
        {"id", pet_text(id)},
        {"kind", engine.kinds()[pet.kind].name},
        {"state", state_of(pet)},
        {"x", rounded(pet.position().x)},
        {"y", rounded(pet.position().y)},
        {"vx", rounded(pet.velocity().x)},
        {"vy", rounded(pet.velocity().y)},
        {"owner", pet.owner},
        {"tag", pet.tag},
    };
}

Outcome list(VerbContext& context, const json& arguments) {
    const Engine& engine = context.daemon.engine();
    const Chosen ids = chosen(engine, arguments);
    if (!ids) {
        return std::unexpected(ids.error());
    }
    const std::size_t first = std::min(arguments.value("first", std::size_t{0}), ids->size());
    const std::size_t most = arguments.value("most", std::size_t{100});
    json pets = json::array();
    for (std::size_t i = first; i < ids->size() && i - first < most; ++i) {
        pets.push_back(description_of(engine, (*ids)[i]));
    }
    return json{{"total", ids->size()}, {"pets", std::move(pets)}};
}

constexpr std::array spawn_parameters{
    Parameter{.name = "kind", .help = "Which pet; a hyrax if left out.", .positional = true},
    Parameter{
        .name = "count",
        .type = ParameterType::whole_number,
        .help = "How many; one if left out. All of them come, or none.",
        .range = {1, 1000},
        .unit = "pets",
    },
    Parameter{
        .name = "x",
        .type = ParameterType::number,
        .help = "Left edge on the virtual desktop. Without x and y: somewhere at the top.",
        .range = places,
        .unit = "px",
    },
    Parameter{
        .name = "y",
        .type = ParameterType::number,
        .help = "Top edge, downwards. Only together with x.",
        .range = places,
        .unit = "px",
    },
    velocity_x,
    velocity_y,
    Parameter{.name = "tag", .help = "A word by which to choose them later."},
};

constexpr std::array fling_parameters{one_pet, of_kind, with_tag, velocity_x, velocity_y};
constexpr std::array choosing{one_pet, of_kind, with_tag};
constexpr std::array list_parameters{
    one_pet,
    of_kind,
    with_tag,
    Parameter{
        .name = "first",
        .type = ParameterType::whole_number,
        .help = "Leave out so many.",
        .range = {0, 10000},
        .unit = "pets",
    },
    Parameter{
        .name = "most",
        .type = ParameterType::whole_number,
        .help = "No more than this; 100 if left out.",
        .range = {0, 200},
        .unit = "pets",
    },
};

constexpr std::array table{
    Verb{"spawn", "Lets pets appear.", spawn_parameters, "spawn --count 3 --vy -600", spawn},
    Verb{
        "fling",
        "Sets the velocity of pets. Without vx and vy: throws every pet upwards in a direction of "
        "its own. A pet in the user's hand stays there.",
        fling_parameters,
        "fling 0.1 --vx 500 --vy -800",
        fling
    },
    Verb{"reset", "Puts pets back where they were spawned, at rest.", choosing, "reset", reset},
    Verb{"stop", "Takes the velocity from pets.", choosing, "stop --kind hyrax", stop},
    Verb{
        "remove", "Takes pets away; without a choice, all.", choosing, "remove --tag party", remove
    },
    Verb{
        "list", "Shows the pets, the one on top last.", list_parameters, "list --kind hyrax", list
    },
};

}  // namespace

std::span<const Verb> pet_verbs() {
    return table;
}

}  // namespace hyrax
