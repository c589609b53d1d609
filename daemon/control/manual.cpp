// SPDX-License-Identifier: MIT
// docs/control.md, from the table of verbs.
#include "daemon/control/ctl_command_line.h"
#include "daemon/control/request_check.h"
#include "daemon/control/verb.h"

#include <fmt/format.h>

#include <algorithm>

namespace hyrax {
namespace {

constexpr std::string_view introduction = R"text(# The control channel

Made by `hyraxctl manual`; a test compares.

`hyraxctl VERB` speaks to the hyrax that runs: `hyrax.exe` on Windows, `hyrax-headless --serve` on Linux. It finds
the one of your own profile, or of `--profile FOLDER`. Answers are for people; `--json` prints them as they come.

| Exit code | Means |
|---|---|
| 0 | done |
| 1 | the daemon refused; the reason is on standard error |
| 2 | wrong usage; nothing was sent |
| 3 | no daemon answers |

`eval "$(hyraxctl completion bash)"` completes commands in bash; in PowerShell,
`hyraxctl completion powershell | Out-String | Invoke-Expression` does.

## Without hyraxctl

| System | Where |
|---|---|
| Linux | the Unix socket `$XDG_RUNTIME_DIR/hyrax/<hash of the profile's folder>.socket`, mode 0600 in a folder of mode 0700; the peer must be the same user |
| Windows | the pipe `\\.\pipe\hyrax-<hash of user and profile>-s<session>`, which only its user may open, from this machine |

This keeps other users out. It is no wall against other programs of the same user, who may do all that the user may.

A message is its length in bytes, four bytes, the lowest first, and then that many bytes of UTF-8 JSON: 2 to 65536,
nested at most 16 deep. A connection carries one request and one answer; only `events` has more, until the client
leaves. Who needs more than two seconds to send a request or to read an answer is dropped, and so is who reads events
so slowly that 256 KiB wait for it. Four clients are served at a time.

```
{"do": "spawn", "count": 2}
{"ok": true, "result": {"pets": ["3.1", "4.1"]}}
{"do": "spwan"}
{"ok": false, "error": {"code": "unknown_verb", "message": "do: there is no \"spwan\"; did you mean \"spawn\"?"}}
```

| Code | Means |
|---|---|
| `bad_json` | the request is no JSON, or nested too deep |
| `unknown_verb` | there is no such verb |
| `bad_request` | an argument is missing, unknown, of the wrong type or out of its range |
| `no_such_pet` | the pet is gone |
| `bad_value` | `config.json` would have a mistake; it stays as it is |
| `not_saved` | `config.json` could not be written; hyraxctl tries for two seconds |
| `problem` | what was read again has a mistake; the last good settings stay |
| `no_such_script` | there is no script of this name |
| `script_error` | the script has an error, which the message is; or it has not answered within four seconds |
| `busy` | too many clients hear of events, or wait for scripts |
| `too_long` | the answer would be longer than a message can be |
| `refused` | the daemon cannot do it now; the message says why |

A pet's id, such as `3.1`, is never used again for another pet.

## Commands that are no verbs

| Command | Does |
|---|---|
| `hyraxctl repl [script]` | runs Lua line by line in a script, by `eval`; without a name in one of its own, which ends with it. `:quit` or the end of input ends it. Reads pipes as well, and then ends with 1 if anything failed. Only if `scripts.developer` is true. |
| `hyraxctl plugin new ID [--into FOLDER]` | makes a folder with a plugin that works |
| `hyraxctl plugin check FOLDER` | reads a plugin and runs it for a minute of its own time, and the cases that it makes with `hyrax.test`; tells errors as compilers do. Needs no daemon, and runs in hyraxctl's own process. |
| `hyraxctl plugin install FROM [--replace]` | puts a copy of a folder or of a zip file into `plugins` of the profile. It is read and checked before it takes its place; nothing of it runs. Refused: links, what is encrypted, names that are not safe on every system, more than 200 files or 32 MiB. |
| `hyraxctl plugin remove ID [--yes]` | removes that folder; asks before |
| `hyraxctl completion bash`, `powershell` | prints what completes command lines |
| `hyraxctl manual` | prints this |

## Verbs
)text";

std::string usage_of(const Verb& verb) {
    if (!verb.usage.empty()) {
        std::string lines;
        for (std::string_view rest = verb.usage; !rest.empty();) {
            const std::string_view one = rest.substr(0, rest.find(" | "));
            lines += fmt::format("{}hyraxctl {}", lines.empty() ? "" : "\n", one);
            rest.remove_prefix(std::min(rest.size(), one.size() + 3));
        }
        return lines;
    }
    std::string usage = fmt::format("hyraxctl {}", verb.name);
    for (const Parameter& parameter : verb.parameters) {
        const std::string name = parameter.positional ? std::string(parameter.name)
                                                      : fmt::format("--{0} {0}", parameter.name);
        usage += parameter.required ? " " + name : " [" + name + "]";
    }
    return usage;
}

std::string row_of(const Parameter& parameter) {
    return fmt::format(
        "| `{}` | {}{}{} | {} |\n",
        parameter.name,
        expectation(parameter),
        parameter.unit.empty() ? "" : fmt::format(" [{}]", parameter.unit),
        parameter.required ? ", needed" : "",
        parameter.help
    );
}

}  // namespace

std::string control_manual() {
    std::string text(introduction);
    for (const Verb& verb : verbs()) {
        text += fmt::format("\n### {}\n\n{}\n\n", verb.name, verb.help);
        if (!verb.parameters.empty()) {
            text += "| Argument | Takes | |\n|---|---|---|\n";
            for (const Parameter& parameter : verb.parameters) {
                text += row_of(parameter);
            }
            text += "\n";
        }
        text += fmt::format("```\n{}\n", usage_of(verb));
        if (!verb.parameters.empty()) {
            text += fmt::format("hyraxctl {}\n", verb.example);
        }
        text += "```\n";
    }
    return text;
}

}  // namespace hyrax
