// SPDX-License-Identifier: MIT
#include "daemon/control/ctl_task.h"

#include "daemon/control/ctl_command_line.h"
#include "daemon/control/ctl_output.h"
#include "daemon/control/verb.h"
#include "daemon/core/files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace hyrax {
namespace {

using json = nlohmann::ordered_json;

// --- run -------------------------------------------------------------------------------------

int run_file(const task::RunFile& task, const TaskContext& context) {
    const Client client(context.system, context.profile);
    const Result<std::string> text = read_text_file(task.file, longest_script);
    if (!text) {
        return told(text.error(), exit_usage);
    }
    const auto requests = run_requests(utf8_from_path(task.file.filename()), *text);
    if (!requests) {
        return told({utf8_from_path(task.file) + requests.error().message}, exit_usage);
    }
    std::string shown;
    for (const std::string& request : *requests) {
        const Result<Talk> talk = client.ask(request);
        if (!talk) {
            return told(talk.error(), exit_no_daemon);
        }
        const ShownAnswer answer = shown_answer(talk->answer);
        const bool refused = !answer.refusal.empty();
        if (refused && !context.json) {
            return told({answer.text}, exit_refused);
        }
        shown = context.json ? talk->answer + "\n" : answer.text;
        if (refused) {
            fmt::print("{}", shown);
            return exit_refused;
        }
    }
    fmt::print("{}", shown);
    return exit_ok;
}

// --- repl ------------------------------------------------------------------------------------

std::string without_blanks(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    const std::size_t end = line.find_last_not_of(" \t\r");
    return begin == std::string_view::npos ? "" : std::string(line.substr(begin, end - begin + 1));
}

class Repl {
public:
    Repl(const TaskContext& context, std::string script)
        : system_(context.system),
          client_(context.system, context.profile),
          script_(std::move(script)) {}

    int run() {
        const bool own_script = script_.empty();
        if (own_script) {
            script_ = std::string(own_name);
            if (!ask(run_requests(own_name, "")->front())) {
                return code_;
            }
        }
        read_lines();
        if (own_script && code_ != exit_no_daemon) {
            ask(json{{"do", "run"}, {"name", own_name}, {"stop", true}}.dump());
        }
        return code_;
    }

private:
    static constexpr std::string_view own_name = "repl";

    void read_lines() {
        const bool interactive = system_.is_interactive();
        if (interactive) {
            fmt::print(
                "Lua in {}; names without local last from line to line. :quit ends.\n", script_
            );
        }
        while (code_ != exit_no_daemon) {
            if (interactive) {
                fmt::print("{}", text_.empty() ? "> " : ">> ");
                std::fflush(stdout);
            }
            const std::optional<std::string> line = system_.read_line();
            if (!line) {
                break;
            }
            const std::string words = without_blanks(*line);
            if (text_.empty() && (words == ":quit" || words == ":q")) {
                return;
            }
            if (text_.empty() && words.empty()) {
                continue;
            }
            text_ += *line + "\n";
            // An empty line lets go of what does not want to end.
            evaluate(!(interactive && words.empty()));
        }
        if (!text_.empty()) {
            evaluate(false);
        }
    }

    void evaluate(bool may_go_on) {
        const json request{{"do", "eval"}, {"script", script_}, {"code", text_}};
        if (ask(request.dump(-1, ' ', false, json::error_handler_t::replace), may_go_on)) {
            text_.clear();
        }
    }

    // False while the text is to go on, or if the daemon would not have it.
    bool ask(const std::string& request, bool may_go_on = false) {
        const Result<Talk> talk = client_.ask(request);
        if (!talk) {
            code_ = told(talk.error(), exit_no_daemon);
            return false;
        }
        const ShownAnswer answer = shown_answer(talk->answer);
        if (answer.refusal == script_error && may_go_on && is_unfinished(answer.text)) {
            return false;
        }
        if (!answer.refusal.empty()) {
            code_ = told({answer.text}, exit_refused);
            return answer.refusal == script_error;
        }
        if (!text_.empty()) {
            fmt::print("{}", answer.text);
            std::fflush(stdout);
        }
        return true;
    }

    ControlSystem& system_;
    const Client client_;
    std::string script_;
    std::string text_;  // As far as it has been typed.
    int code_ = exit_ok;
};

}  // namespace

Result<std::vector<std::string>> run_requests(std::string_view name, std::string_view text) {
    // A byte takes six when it is escaped.
    constexpr std::size_t longest_part = 10'000;
    std::vector<std::string> requests;
    std::size_t at = 0;
    try {
        do {
            std::size_t end = std::min(text.size(), at + longest_part);
            // Not between the bytes of a character, of which there are four at most.
            for (int i = 0; i < 3 && end < text.size(); ++i) {
                end -= (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U ? 1 : 0;
            }
            requests.push_back(json{
                {"do", "run"},
                {"name", name},
                {"text", text.substr(at, end - at)},
                {"at", at},
                {"more", end < text.size()},
            }
                                   .dump());
            at = end;
        } while (at < text.size());
    } catch (const json::exception&) {
        return failure(": must be UTF-8");
    }
    return requests;
}

bool is_unfinished(std::string_view error) {
    return error.ends_with("near <eof>");
}

int told(const Error& error, int exit_code) {
    fmt::print(stderr, "hyraxctl: {}\n", error.message);
    return exit_code;
}

int perform(const task::RunFile& task, const TaskContext& context) {
    return run_file(task, context);
}

int perform(const task::Repl& task, const TaskContext& context) {
    return Repl(context, task.script).run();
}

int perform(const CtlTask& task, const TaskContext& context) {
    return std::visit([&context](const auto& which) { return perform(which, context); }, task);
}

}  // namespace hyrax
