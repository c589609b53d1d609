// SPDX-License-Identifier: MIT
// Scripts in a process of their own, as the daemon sees them: sends what they need to know, takes
// what they answer, ends the process when it hangs and starts another one without the culprit.
#pragma once

#include "daemon/core/script_channel.h"
#include "daemon/core/script_port.h"
#include "daemon/core/script_wire.h"
#include "daemon/core/watchdog.h"

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace hyrax {

/// The process starts with the first run() after a load() and ends when nothing is left to run.
/// A text that hangs or crashes it, or fails, stays out until it changes or everything is loaded
/// anew (renew()); after three times in a session, only another text helps. Meanwhile the text that
/// the script ran with before stands in for it.
class RemoteScriptHost final : public ScriptHost {
public:
    static constexpr int most_kills = 3;

    explicit RemoteScriptHost(std::unique_ptr<ScriptChannel> channel);

    void set_limits(const ScriptLimits& limits) override { limits_ = limits; }
    void load(std::vector<ScriptSource> sources) override;
    void renew() override;
    ScriptOutput run(const ScriptWorld& world, std::span<const ScriptEvent> events) override;

    bool busy() const override { return waiting_ || now_ < retry_at_; }
    std::optional<ScriptOutput> take_output() override;
    void watch(Ticks now) override;
    Ticks watch_due() const override;
    bool wait(std::chrono::milliseconds patience) override {
        return waiting_ && channel_->wait(patience);
    }
    std::vector<std::string> ended() const override;

    /// True while there is a process.
    bool running() const { return running_; }

private:
    // What a script keeps and is set to makes it no other one.
    struct ByText {
        bool operator()(const ScriptSource& a, const ScriptSource& b) const {
            return std::tie(a.name, a.text, a.modules, a.turn) <
                   std::tie(b.name, b.text, b.modules, b.turn);
        }
    };

    void stop();
    void keep_up(const ScriptOutput& output);
    std::vector<ScriptSource> to_run() const;
    bool start(ScriptOutput& output);
    void hear();
    void accept(wire::Answer answer);
    void look_after(const ScriptChannel::End& end);
    void end_process(std::string_view reason, bool blame);
    void give_up_evaluations(ScriptOutput& output, const std::string& reason);
    bool put_out(const std::vector<std::uint32_t>& places);
    bool may_run(const ScriptSource& script) const;
    const ScriptSource* stand_in(const ScriptSource& script) const;

    std::unique_ptr<ScriptChannel> channel_;
    ScriptLimits limits_;
    std::vector<ScriptSource> sources_;         // As loaded.
    std::vector<ScriptSource> sent_;            // Those that the process knows, by their places.
    std::map<std::string, ScriptSource> good_;  // By name, the latest one that was loaded well.
    std::set<ScriptSource, ByText> out_;
    std::map<ScriptSource, int, ByText> kills_;

    bool running_ = false;
    bool fresh_ = false;    // The process has to be sent the sources.
    bool anew_ = false;     // It has to load all of them anew.
    bool untried_ = false;  // It has not answered since it was sent them.
    bool waiting_ = false;  // For an answer.
    std::uint64_t number_ = 0;
    ScriptOutput last_;                      // Its listening and next_wake alone.
    std::vector<std::uint64_t> evaluating_;  // That the process has been asked for.
    std::optional<ScriptOutput> output_;
    Watchdog watchdog_;
    Ticks now_ = 0;
    Ticks retry_at_ = 0;
    int failures_ = 0;  // Of processes in a row that never answered.
    wire::Bytes outgoing_;
    wire::Bytes incoming_;
    wire::MessageStream stream_{wire::longest_to_daemon};
};

}  // namespace hyrax
