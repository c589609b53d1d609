// SPDX-License-Identifier: MIT
#include "daemon/script/journal.h"

#include "daemon/script/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hyrax::script {
namespace {

constexpr std::size_t longest_message = 1'024;
// A script with more different messages than this starts to be counted anew.
constexpr std::size_t most_messages = 64;
constexpr std::size_t errors_to_pause = 20;
constexpr Ticks pause_span = 10 * ticks_per_second;

// 10, 100, 1000, ...
bool is_round(std::uint64_t count) {
    while (count >= 10 && count % 10 == 0) {
        count /= 10;
    }
    return count == 1;
}

}  // namespace

Journal::Journal(std::string script, const ScriptLimits& limits)
    : script_(std::move(script)), limits_(limits), credit_(static_cast<double>(limits.log_burst)) {}

void Journal::begin_run(Ticks now, std::vector<ScriptLog>& log) {
    const double earned =
        to_seconds(now - now_) * static_cast<double>(limits_.log_lines_per_second);
    log_ = &log;
    now_ = now;
    credit_ = std::min(credit_ + std::max(earned, 0.0), static_cast<double>(limits_.log_burst));
    if (dropped_ > 0 && credit_ >= 1.0) {
        credit_ -= 1.0;
        tell(
            LogLevel::warning,
            fmt::format(
                "{} log lines dropped (limit of {} a second)",
                std::exchange(dropped_, 0),
                limits_.log_lines_per_second
            )
        );
    }
}

void Journal::say(LogLevel level, std::string_view text) {
    if (credit_ < 1.0) {
        ++dropped_;
        return;
    }
    credit_ -= 1.0;
    tell(level, clean_text(text, limits_.log_line));
}

void Journal::tell(LogLevel level, std::string text) {
    log_->push_back({level, script_, std::move(text)});
}

bool Journal::error(std::string_view message, const CallTrace& trace) {
    ++errors_;
    const std::string text = located(message, trace);
    if (times_.size() >= most_messages && !times_.contains(text)) {
        times_.clear();
    }
    const std::uint64_t times = ++times_[text];
    if (times == 1) {
        tell(LogLevel::error, text);
        tell_frames(trace);
    } else if (is_round(times)) {
        tell(LogLevel::error, fmt::format("{} ({} times)", text, times));
    }

    recent_errors_.push_back(now_);
    while (now_ - recent_errors_.front() > pause_span) {
        recent_errors_.pop_front();
    }
    if (recent_errors_.size() < errors_to_pause) {
        return false;
    }
    tell(
        LogLevel::error,
        fmt::format(
            "{}: paused after {} errors in {:g} s until it is loaded again",
            script_,
            errors_to_pause,
            to_seconds(pause_span)
        )
    );
    return true;
}

void Journal::ended(const std::string& reason, const CallTrace& trace) {
    ++errors_;
    tell(LogLevel::error, located(reason + "; stopped until it is loaded again", trace));
    tell_frames(trace);
}

// Most messages of Lua begin with the place; the others get it. Texts that load() or a developer
// brought have names of their own.
std::string Journal::located(std::string_view message, const CallTrace& trace) const {
    std::string text = clean_text(message, longest_message);
    const auto has_place = [&] { return ScriptLog{LogLevel::error, script_, text}.has_place(); };
    if (has_place()) {
        return text;
    }
    if (!trace.where.empty() && !text.starts_with(trace.where + ":")) {
        text = trace.where + ": " + text;
    }
    return has_place() ? text : script_ + ": " + text;
}

void Journal::tell_frames(const CallTrace& trace) {
    for (const std::string& frame : trace.frames) {
        tell(LogLevel::error, "    " + clean_text(frame, limits_.log_line));
    }
}

}  // namespace hyrax::script
