// SPDX-License-Identifier: MIT
// The verbs about scripts.
#include "daemon/control/verb.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace hyrax {
namespace {

using json = nlohmann::ordered_json;

std::unexpected<Refusal> refused(std::string message) {
    return std::unexpected(Refusal{"refused", std::move(message)});
}

std::expected<void, Refusal> for_developers(const Daemon& daemon) {
    if (!daemon.config().developer) {
        return refused("only for developers: set scripts.developer in config.json to true "
                       "(hyraxctl config set "
                       "scripts.developer true)");
    }
    if (std::string why = daemon.why_scripts_rest(); !why.empty()) {
        return refused(std::move(why));
    }
    return {};
}

const char* state_of(const ScriptStatus& script) {
    if (!script.on) {
        return "off";
    }
    return script.ended ? "ended" : "on";
}

Outcome scripts(VerbContext& context, const json&) {
    json list = json::array();
    for (const ScriptStatus& script : context.daemon.script_states()) {
        json item{{"name", script.name}, {"state", state_of(script)}, {"bytes", script.bytes}};
        add_use(item, script.pets, script.use);
        item["error"] = script.error;
        list.push_back(std::move(item));
    }
    return json{{"scripts", std::move(list)}};
}

// --- waiting for scripts ---------------------------------------------------------------------

Outcome wait_for(
    VerbContext& context, const std::string& script, const std::string& text, FinishVerb finish
) {
    const Result<std::uint64_t> evaluation = context.daemon.evaluate(script, text);
    if (!evaluation) {
        return std::unexpected(Refusal{"busy", evaluation.error().message});
    }
    context.waits = Waits{*evaluation, script, finish};
    return json::object();
}

// The script has been loaded by now, or has failed.
Outcome loaded(const Daemon& daemon, const std::string& script, const Evaluated& evaluated) {
    if (std::string error = daemon.error_of(script); !error.empty()) {
        return std::unexpected(Refusal{std::string(script_error), std::move(error)});
    }
    if (!evaluated.good) {
        return std::unexpected(Refusal{std::string(script_error), evaluated.text});
    }
    return json{{"script", script}};
}

Outcome values(const Daemon&, const std::string& script, const Evaluated& evaluated) {
    if (!evaluated.good) {
        return std::unexpected(
            Refusal{std::string(script_error), evaluated.printed + evaluated.text}
        );
    }
    return json{{"script", script}, {"printed", evaluated.printed}, {"value", evaluated.text}};
}

// --- switches --------------------------------------------------------------------------------

using Named = std::expected<std::string, Refusal>;

Named named_script(VerbContext& context, const json& arguments) {
    const Result<std::string> script =
        context.daemon.find_script(arguments["script"].get_ref<const std::string&>());
    if (!script) {
        return std::unexpected(Refusal{"no_such_script", script.error().message});
    }
    return *script;
}

Outcome switch_script(VerbContext& context, const json& arguments, bool on) {
    const Named script = named_script(context, arguments);
    if (!script) {
        return std::unexpected(script.error());
    }
    if (script->starts_with(SessionScripts::prefix)) {
        return refused(fmt::format("{} is no file: run --stop ends it", *script));
    }
    context.daemon.handle(Request{request::SetScript{*script, on}});
    return json{{"script", *script}, {"on", on}};
}

Outcome switch_on(VerbContext& context, const json& arguments) {
    return switch_script(context, arguments, true);
}

Outcome switch_off(VerbContext& context, const json& arguments) {
    return switch_script(context, arguments, false);
}

Outcome restart(VerbContext& context, const json& arguments) {
    const Named script = named_script(context, arguments);
    if (!script) {
        return std::unexpected(script.error());
    }
    context.daemon.restart_script(*script);
    if (!context.daemon.why_scripts_rest().empty()) {
        return json{{"script", *script}};  // It starts when it can.
    }
    return wait_for(context, *script, "", loaded);
}

// --- for developers --------------------------------------------------------------------------

// A message is shorter than a script may be: long ones come in parts.
Outcome run(VerbContext& context, const json& arguments) {
    if (const auto allowed = for_developers(context.daemon); !allowed) {
        return std::unexpected(allowed.error());
    }
    const auto& name = arguments["name"].get_ref<const std::string&>();
    if (arguments.value("stop", false)) {
        if (!context.daemon.stop_script(name)) {
            return std::unexpected(
                Refusal{"no_such_script", fmt::format("nobody has run a script \"{}\"", name)}
            );
        }
        return json::object();
    }
    Upload& upload = context.upload;
    const std::size_t at = arguments.value("at", std::size_t{0});
    if (at == 0) {
        upload = {name, ""};
    }
    if (upload.name != name || upload.text.size() != at) {
        upload = {};
        return std::unexpected(Refusal{
            "bad_request", "at: this part does not follow the one before; begin with at 0 again"
        });
    }
    upload.text += arguments.value("text", std::string());
    if (upload.text.size() > longest_script) {
        upload = {};
        return refused(fmt::format("a script has at most {} bytes", longest_script));
    }
    if (arguments.value("more", false)) {
        return json{{"bytes", upload.text.size()}};
    }
    const Result<std::string> script =
        context.daemon.run_script(name, std::exchange(upload, {}).text);
    if (!script) {
        return refused(script.error().message);
    }
    return wait_for(context, *script, "", loaded);
}

Outcome eval(VerbContext& context, const json& arguments) {
    if (const auto allowed = for_developers(context.daemon); !allowed) {
        return std::unexpected(allowed.error());
    }
    const Named script = named_script(context, arguments);
    if (!script) {
        return std::unexpected(script.error());
    }
    return wait_for(context, *script, arguments["code"].get<std::string>(), values);
}

constexpr std::array one_script{Parameter{
    .name = "script",
    .type = ParameterType::script,
    .help = "Which one.",
    .required = true,
    .positional = true,
}};

constexpr std::array run_parameters{
    Parameter{
        .name = "name",
        .help = "What it is called, with \"run:\" in front.",
        .required = true,
    },
    Parameter{.name = "text", .type = ParameterType::code, .help = "The script, or a part of it."},
    Parameter{
        .name = "at",
        .type = ParameterType::whole_number,
        .help = "Where this part begins; 0 if left out.",
        .range = {0, longest_script},
        .unit = "bytes",
    },
    Parameter{
        .name = "more", .type = ParameterType::flag, .help = "Parts follow: nothing runs yet."
    },
    Parameter{
        .name = "stop", .type = ParameterType::flag, .help = "Ends the script of this name instead."
    },
};

constexpr std::array eval_parameters{
    Parameter{
        .name = "script",
        .type = ParameterType::script,
        .help = "In which script, as scripts shows it.",
        .required = true,
        .positional = true,
    },
    Parameter{
        .name = "code",
        .type = ParameterType::code,
        .help = "An expression or statements.",
        .required = true,
        .positional = true,
    },
};

constexpr std::array table{
    Verb{
        "scripts",
        "Shows the scripts: the bytes of each one's text and of its memory, the work units and "
        "errors "
        "since it was loaded, its pets, the events that it hears of, and its latest error.",
        {},
        "scripts",
        scripts
    },
    Verb{"scripts on", "Lets a script run.", one_script, "scripts on fountain.lua", switch_on},
    Verb{
        "scripts off",
        "Ends a script and keeps it off, as the tray's menu does.",
        one_script,
        "scripts off fountain.lua",
        switch_off
    },
    Verb{
        "scripts reload",
        "Starts a script anew; refused with its error if it has one.",
        one_script,
        "scripts reload fountain.lua",
        restart
    },
    Verb{
        "run",
        "Runs a file as a script, until it is run again, stopped, or the daemon ends; refused with "
        "the error of its main chunk. Only if scripts.developer is true.",
        run_parameters,
        "run fountain.lua",
        run,
        "run FILE | run --stop NAME"
    },
    Verb{
        "eval",
        "Runs code in a script that runs, and shows what it returns: texts in quotes, tables one "
        "level deep. Globals are seen, locals of the script are not. Only if scripts.developer is "
        "true.",
        eval_parameters,
        "eval fountain.lua hyrax.pets()",
        eval
    },
};

}  // namespace

void add_use(json& item, std::size_t pets, const ScriptUse& use) {
    item["pets"] = pets;
    item["memory"] = use.memory;
    item["units"] = use.units;
    item["errors"] = use.errors;
    item["hears"] = json::array();
    for (std::size_t kind = 0; kind < event_names().size(); ++kind) {
        if (use.listening.has(static_cast<EventKind>(kind))) {
            item["hears"].push_back(event_names()[kind]);
        }
    }
}

std::span<const Verb> script_verbs() {
    return table;
}

}  // namespace hyrax
