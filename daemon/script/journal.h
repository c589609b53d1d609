// SPDX-License-Identifier: MIT
// What one script tells the log: its own lines under a quota, its errors counted, not repeated.
#pragma once

#include "daemon/core/script_port.h"
#include "daemon/script/call_trace.h"
#include "daemon/script/script_host.h"

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace hyrax::script {

class Journal {
public:
    Journal(std::string script, const ScriptLimits& limits);

    /// Lines go to `log` until the next call.
    void begin_run(Ticks now, std::vector<ScriptLog>& log);
    /// A line of the script's own, cleaned; dropped when there are too many.
    void say(LogLevel level, std::string_view text);
    /// A line about the script.
    void tell(LogLevel level, std::string text);
    /// An error of the script. True once there are so many that it has to be paused.
    [[nodiscard]] bool error(std::string_view message, const CallTrace& trace);
    /// The error that ended the script.
    void ended(const std::string& reason, const CallTrace& trace);

    const std::string& script() const { return script_; }
    std::uint64_t errors() const { return errors_; }

private:
    std::string located(std::string_view message, const CallTrace& trace) const;
    void tell_frames(const CallTrace& trace);

    std::string script_;
    const ScriptLimits& limits_;
    std::vector<ScriptLog>* log_ = nullptr;
    Ticks now_ = 0;
    double credit_;  ///< Lines that may be said now.
    std::uint64_t dropped_ = 0;
    std::uint64_t errors_ = 0;
    std::unordered_map<std::string, std::uint64_t> times_;  ///< By message.
    std::deque<Ticks> recent_errors_;
};

}  // namespace hyrax::script
