// SPDX-License-Identifier: MIT
// Completion for shells, from the table of verbs.
#include "daemon/control/config_key.h"
#include "daemon/control/ctl_command_line.h"
#include "daemon/control/verb.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace hyrax {
namespace {

// By the words that stand in front, "" or "config get": what may follow.
using Followers = std::map<std::string, std::vector<std::string>>;

// Commands that are no requests: those of ctl_task_command_line.cpp.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> other_commands{{
    {"completion", "bash powershell"},
    {"repl", "--help"},
    {"plugin", "new check install remove"},
    {"plugin new", "--into --help"},
    {"plugin check", "--help"},
    {"plugin install", "--replace --help"},
    {"plugin remove", "--yes --help"},
}};

std::vector<std::string> split(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        words.emplace_back(word);
        text.remove_prefix(std::min(text.size(), word.size() + 1));
    }
    return words;
}

void add_words_of(const Verb& verb, std::vector<std::string>& words) {
    if (!verb.usage.empty()) {
        std::ranges::copy_if(split(verb.usage), std::back_inserter(words), [](const auto& word) {
            return word.starts_with("--");
        });
        words.emplace_back("--help");
        return;
    }
    for (const Parameter& parameter : verb.parameters) {
        if (!parameter.positional) {
            words.push_back("--" + std::string(parameter.name));
        } else if (parameter.type == ParameterType::key) {
            const std::vector<std::string> keys = settable_keys();
            words.insert(words.end(), keys.begin(), keys.end());
        } else if (parameter.type == ParameterType::events) {
            words.insert(words.end(), event_names().begin(), event_names().end());
        }
    }
    words.emplace_back("--help");
}

Followers followers() {
    Followers all;
    for (const Verb& verb : verbs()) {
        const std::string name(verb.name);
        const std::size_t space = name.find(' ');
        const std::string first = name.substr(0, space);
        if (space == std::string::npos || !all.contains(first)) {
            all[""].push_back(first);
        }
        if (space != std::string::npos) {
            all[first].push_back(name.substr(space + 1));
        }
        add_words_of(verb, all[name]);
    }
    for (const auto& [name, words] : other_commands) {
        all[std::string(name)] = split(words);
    }
    for (const char* word :
         {"repl", "plugin", "completion", "--json", "--profile", "--help", "--version"}) {
        all[""].emplace_back(word);
    }
    return all;
}

std::string bash_script() {
    std::string cases;
    for (const auto& [before, words] : followers()) {
        cases += fmt::format("        \"{}\") words=\"{}\" ;;\n", before, fmt::join(words, " "));
    }
    return fmt::format(
        R"text(# Completes hyraxctl in bash: eval "$(hyraxctl completion bash)"
_hyraxctl() {{
    local before="" word i words
    for ((i = 1; i < COMP_CWORD; i++)); do
        word=${{COMP_WORDS[i]}}
        case $word in
            --profile) ((i++)) ;;
            -*) ;;
            *) case $before in
                "") before=$word ;;
                config | scripts | plugin) before="$before $word" ;;
            esac ;;
        esac
    done
    if [ "${{COMP_WORDS[COMP_CWORD - 1]}}" = --profile ]; then
        COMPREPLY=($(compgen -d -- "${{COMP_WORDS[COMP_CWORD]}}"))
        return
    fi
    case $before in
{}        *) words="" ;;
    esac
    COMPREPLY=($(compgen -W "$words" -- "${{COMP_WORDS[COMP_CWORD]}}"))
    case $before in
        run | "plugin check" | "plugin install")
            COMPREPLY+=($(compgen -f -- "${{COMP_WORDS[COMP_CWORD]}}")) ;;
    esac
}}
complete -F _hyraxctl hyraxctl
)text",
        cases
    );
}

std::string powershell_script() {
    std::string cases;
    for (const auto& [before, words] : followers()) {
        cases += fmt::format("        '{}' = '{}'\n", before, fmt::join(words, " "));
    }
    return fmt::format(
        R"text(# Completes hyraxctl in PowerShell: hyraxctl completion powershell | Out-String | Invoke-Expression
Register-ArgumentCompleter -Native -CommandName hyraxctl, hyraxctl.exe -ScriptBlock {{
    param($wordToComplete, $commandAst, $cursorPosition)
    $followers = @{{
{}    }}
    $before = ''
    $skip = $false
    foreach ($element in $commandAst.CommandElements | Select-Object -Skip 1) {{
        $word = $element.ToString()
        if ($element.Extent.EndOffset -ge $cursorPosition -and $word -eq $wordToComplete) {{ break }}
        if ($skip) {{ $skip = $false }}
        elseif ($word -eq '--profile') {{ $skip = $true }}
        elseif ($word.StartsWith('-')) {{ }}
        elseif ($before -eq '') {{ $before = $word }}
        elseif ($before -in 'config', 'scripts', 'plugin') {{ $before = "$before $word" }}
    }}
    "$($followers[$before])".Split(' ') | Where-Object {{ $_ -and $_.StartsWith($wordToComplete) }} | ForEach-Object {{
        [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_)
    }}
}}
)text",
        cases
    );
}

}  // namespace

std::string completion_script(std::string_view shell) {
    if (shell == "bash") {
        return bash_script();
    }
    return shell == "powershell" ? powershell_script() : std::string();
}

}  // namespace hyrax
