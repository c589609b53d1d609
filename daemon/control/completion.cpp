// SPDX-License-Identifier: MIT
// Completion for shells, from the table of verbs.
#include "daemon/control/config_key.h"
#include "daemon/control/ctl_command_line.h"
#include "daemon/control/verb.h"

#include <fmt/format.h>

#include <map>
#include <vector>

namespace hyrax {
namespace {

// By the words that stand in front, "" or "config get": what may follow.
using Followers = std::map<std::string, std::vector<std::string>>;

void add_words_of(const Verb& verb, std::vector<std::string>& words) {
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
    all["completion"] = {"bash", "powershell"};
    for (const char* word : {"completion", "--json", "--profile", "--help", "--version"}) {
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
                config) before="config $word" ;;
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
        elseif ($before -eq 'config') {{ $before = "config $word" }}
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
