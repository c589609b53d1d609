// SPDX-License-Identifier: MIT
#include "daemon/control/ctl_command_line.h"

#include "daemon/control/cli_parse.h"
#include "daemon/control/ctl_task_command_line.h"
#include "daemon/control/request_check.h"
#include "daemon/core/files.h"
#include "daemon/core/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hyrax {
namespace {

using json = nlohmann::ordered_json;

// A verb as CLI11 sees it. Values stay texts: the daemon's own check judges them.
struct Command {
    const Verb* verb = nullptr;
    CLI::App* app = nullptr;
    std::vector<std::vector<std::string>> texts;  // By parameter; CLI11 writes into them.
};

json number_or_text(const std::string& text) {
    json value = json::parse(text, nullptr, false);
    return value.is_number() ? value : json(text);
}

json value_of(const Parameter& parameter, const std::vector<std::string>& texts) {
    switch (parameter.type) {
        case ParameterType::number:
        case ParameterType::whole_number:
            return number_or_text(texts.front());
        case ParameterType::json: {
            json value = json::parse(texts.front(), nullptr, false);
            return value.is_discarded() ? json(texts.front()) : value;
        }
        case ParameterType::events:
            return texts;
        case ParameterType::flag:
            return true;
        case ParameterType::text:
        case ParameterType::pet:
        case ParameterType::key:
        case ParameterType::script:
        case ParameterType::code:
            return texts.front();
    }
    std::unreachable();
}

std::string help_of(const Parameter& parameter) {
    std::string help(parameter.help);
    if (!parameter.unit.empty()) {
        help += fmt::format(" [{}]", parameter.unit);
    }
    if (parameter.range.low < parameter.range.high) {
        help += fmt::format(
            " {} to {}", plain_number(parameter.range.low), plain_number(parameter.range.high)
        );
    }
    return help;
}

// "config get" is a command within "config".
CLI::App* app_for(CLI::App& root, const Verb& verb) {
    const std::size_t space = verb.name.find(' ');
    const std::string first(verb.name.substr(0, space));
    if (space == std::string_view::npos) {
        return root.add_subcommand(first, std::string(verb.help));
    }
    CLI::App* parent = subcommand_of(root, first);
    // "scripts" is a verb itself.
    if (parent == nullptr) {
        parent = root.add_subcommand(first, "Settings: get and set.");
        parent->require_subcommand(1);
    }
    return parent->add_subcommand(std::string(verb.name.substr(space + 1)), std::string(verb.help));
}

void add_parameters(Command& command) {
    const std::span<const Parameter> parameters = command.verb->parameters;
    command.texts.resize(parameters.size());
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const Parameter& parameter = parameters[i];
        const std::string name = (parameter.positional ? "" : "--") + std::string(parameter.name);
        CLI::Option* const option =
            command.app->add_option(name, command.texts[i], help_of(parameter));
        option->required(parameter.required)->type_name("");
        if (parameter.type != ParameterType::events) {
            option->expected(1)->allow_extra_args(false);
        }
    }
}

// CLI11 would say "The following argument was not expected" of a misspelt verb.
std::optional<Farewell> misspelt_verb(CLI::App& app, const std::vector<std::string>& words) {
    const auto first = std::ranges::find_if(words, [&words](const std::string& word) {
        const bool of_option = &word != words.data() && *(&word - 1) == "--profile";
        return !word.starts_with('-') && !of_option;
    });
    if (first == words.end() || subcommand_of(app, *first) != nullptr) {
        return std::nullopt;
    }
    std::vector<std::string> known;
    for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; })) {
        known.push_back(each->get_name());
    }
    const std::vector<std::string_view> views(known.begin(), known.end());
    return wrong_usage("", unknown_name(*first, views));
}

std::variant<CtlCommandLine, Farewell> request_of(const Command& command, CtlCommandLine line) {
    json arguments = json::object();
    for (std::size_t i = 0; i < command.texts.size(); ++i) {
        if (!command.texts[i].empty()) {
            const Parameter& parameter = command.verb->parameters[i];
            arguments[std::string(parameter.name)] = value_of(parameter, command.texts[i]);
        }
    }
    if (const auto checked = check_arguments(*command.verb, arguments); !checked) {
        return wrong_usage(command.verb->name, checked.error().message);
    }
    arguments["do"] = command.verb->name;
    line.request = arguments.dump(-1, ' ', false, json::error_handler_t::replace);
    if (line.request.size() > max_message) {
        return wrong_usage(
            command.verb->name,
            fmt::format(
                "the request has {} bytes, and {} is the most", line.request.size(), max_message
            )
        );
    }
    line.stays = command.verb->name == "events";
    return line;
}

std::variant<CtlCommandLine, Farewell> completion_for(const std::string& shell) {
    std::string script = completion_script(shell);
    return script.empty() ? wrong_usage("completion", "the shell must be bash or powershell")
                          : Farewell{std::move(script), exit_ok};
}

}  // namespace

std::variant<CtlCommandLine, Farewell> parse_ctl_arguments(const std::vector<std::string>& arguments
) {
    CLI::App app("hyraxctl: speaks to the hyrax that runs", "hyraxctl");
    app.set_version_flag("--version", std::string("hyraxctl ") + HYRAX_VERSION);
    app.require_subcommand(1);
    // Before the commands are added, which take it over: --json may stand behind them.
    app.fallthrough();
    app.footer(
        "hyraxctl VERB --help tells more. Exit codes: 0 done, 1 refused, 2 wrong usage, 3 no hyrax "
        "answers."
    );
    CtlCommandLine line;
    std::string profile;
    std::string shell;
    app.add_flag("--json", line.json, "Print answers as JSON, one on each line");
    app.add_option("--profile", profile, "Folder of the daemon's config.json")->type_name("FOLDER");
    std::vector<Command> commands(verbs().size());
    for (std::size_t i = 0; i < commands.size(); ++i) {
        commands[i].verb = &verbs()[i];
        commands[i].app = app_for(app, verbs()[i]);
        commands[i].app->footer(fmt::format("Example: hyraxctl {}", verbs()[i].example));
        if (verbs()[i].usage.empty()) {
            add_parameters(commands[i]);
        }
    }
    TaskCommands tasks(app, line);
    CLI::App* const completion =
        app.add_subcommand("completion", "Prints what completes command lines in a shell.");
    completion->add_option("shell", shell, "bash or powershell")->required()->type_name("");
    CLI::App* const manual = app.add_subcommand("manual", "Prints docs/control.md.");

    if (std::optional<Farewell> farewell = misspelt_verb(app, arguments)) {
        return *std::move(farewell);
    }
    if (std::optional<Farewell> farewell = parse(app, arguments)) {
        return *std::move(farewell);
    }
    if (completion->parsed()) {
        return completion_for(shell);
    }
    if (manual->parsed()) {
        return Farewell{control_manual(), exit_ok};
    }
    if (!profile.empty()) {
        line.profile = path_from_utf8(profile);
    }
    if (auto problem = tasks.finish()) {
        return *std::move(problem);
    }
    if (line.task || !line.request.empty()) {
        return line;
    }
    // The last one: "scripts on" comes after "scripts".
    const auto chosen = std::find_if(commands.rbegin(), commands.rend(), [](const Command& each) {
        return each.app->parsed();
    });
    return request_of(*chosen, std::move(line));
}

}  // namespace hyrax
