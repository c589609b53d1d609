// SPDX-License-Identifier: MIT
// The verbs about the daemon itself.
#include "daemon/control/verb.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

using json = nlohmann::ordered_json;

// Each takes one of the few places that the channel has for clients.
constexpr std::size_t most_watchers = 2;

double rounded(double value) {
    return std::round(value * 1000.0) / 1000.0;
}

Outcome status(VerbContext& context, const json&) {
    const Daemon& daemon = context.daemon;
    const Status now = daemon.status();
    const Figures figures = daemon.figures();
    const EngineReport engine = daemon.engine().report();
    const auto contacts = static_cast<double>(engine.contacts);
    return json{
        {"pets", now.pets},
        {"awake", engine.awake},
        {"asleep", engine.asleep},
        {"paused", now.paused},
        {"hidden", now.hidden},
        {"quiet", now.quiet},
        {"click_through", now.click_through},
        {"problem", now.problem},
        {"note", now.note},
        {"integrator", name_of(daemon.engine().integrator())},
        {"seconds", rounded(figures.seconds)},
        {"frames", figures.frames},
        {"ns_per_frame", std::round(figures.frame_ns)},
        {"contacts_per_second", figures.seconds > 0.0 ? rounded(contacts / figures.seconds) : 0.0},
        {"energy", rounded(engine.energy)},
    };
}

Outcome set_paused(VerbContext& context, bool paused) {
    context.daemon.handle(Request{request::SetPaused{paused}});
    return json{{"paused", paused}};
}

Outcome pause(VerbContext& context, const json&) {
    return set_paused(context, true);
}

Outcome resume(VerbContext& context, const json&) {
    return set_paused(context, false);
}

Outcome gather(VerbContext& context, const json&) {
    context.daemon.handle(Request{request::Gather{}});
    return json::object();
}

Outcome hide(VerbContext& context, const json& arguments) {
    request::Hide wish;
    if (arguments.contains("minutes")) {
        wish.seconds = std::llround(arguments["minutes"].get<double>() * 60.0);
    }
    context.daemon.handle(Request{wish});
    return json{{"hidden", true}};
}

Outcome show(VerbContext& context, const json&) {
    context.daemon.handle(Request{request::Show{}});
    return json{{"hidden", false}};
}

Outcome reload(VerbContext& context, const json&) {
    context.daemon.handle(Request{request::Reload{}});
    if (const std::string problem = context.daemon.status().problem; !problem.empty()) {
        return std::unexpected(Refusal{"problem", problem});
    }
    return json::object();
}

Outcome events(VerbContext& context, const json& arguments) {
    if (context.watchers >= most_watchers) {
        return std::unexpected(Refusal{
            "busy",
            fmt::format("{} clients hear of events already, and more cannot", context.watchers)
        });
    }
    const std::span<const std::string_view> names = event_names();
    json heard = json::array();
    EventMask mask;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const bool wanted =
            !arguments.contains("only") || std::ranges::count(arguments["only"], names[i]) > 0;
        if (wanted) {
            mask.add(static_cast<EventKind>(i));
            heard.push_back(names[i]);
        }
    }
    context.watch = mask;
    return json{{"events", std::move(heard)}};
}

Outcome quit(VerbContext& context, const json&) {
    context.daemon.handle(Request{request::Quit{}});
    return json::object();
}

constexpr std::array events_parameters{
    Parameter{
        .name = "only",
        .type = ParameterType::events,
        .help = "These alone, a list of names; all if left out.",
        .positional = true,
    },
};

constexpr std::array hide_parameters{
    Parameter{
        .name = "minutes",
        .type = ParameterType::number,
        .help = "Show them again after this time; without it, until show.",
        .range = {0.0, 1e6},
        .unit = "min",
        .positional = true,
    },
};

constexpr std::array table{
    Verb{"status", "Tells how the daemon is doing.", {}, "status", status},
    Verb{"pause", "Freezes pets and scripts.", {}, "pause", pause},
    Verb{"resume", "Lets them go on.", {}, "resume", resume},
    Verb{
        "gather",
        "Brings every pet to the monitor under the pointer, else to the primary one.",
        {},
        "gather",
        gather
    },
    Verb{"hide", "Hides all pets; their time stands still.", hide_parameters, "hide 30", hide},
    Verb{"show", "Shows them again.", {}, "show", show},
    Verb{
        "reload",
        "Reads config, sprite sets and scripts again; refused with what is wrong with them.",
        {},
        "reload",
        reload
    },
    Verb{
        "events",
        "Tells what happens to pets, a line each, until the client leaves. Two clients at most; "
        "one that does not read is dropped. Pets that fly already tell of bounces after their next "
        "launch.",
        events_parameters,
        "events bounce land",
        events
    },
    Verb{"quit", "Ends the daemon.", {}, "quit", quit},
};

}  // namespace

std::span<const Verb> daemon_verbs() {
    return table;
}

}  // namespace hyrax
