// SPDX-License-Identifier: MIT
#include "daemon/core/remote_script_host.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hyrax {
namespace {

constexpr Ticks first_delay = 100 * ticks_per_ms;
constexpr Ticks longest_delay = 10 * ticks_per_second;

// 0, then from 0.1 s doubling up to 10 s.
Ticks delay_after(int failures) {
    return failures == 0 ? 0 : std::min(longest_delay, first_delay << std::min(failures - 1, 10));
}

ScriptLog about_host(LogLevel level, std::string text) {
    return {level, "script host", std::move(text)};
}

}  // namespace

RemoteScriptHost::RemoteScriptHost(std::unique_ptr<ScriptChannel> channel)
    : channel_(std::move(channel)) {}

bool RemoteScriptHost::may_run(const ScriptSource& script) const {
    const auto kills = kills_.find(script);
    return !out_.contains(script) && (kills == kills_.end() || kills->second < most_kills);
}

void RemoteScriptHost::load(std::vector<ScriptSource> sources) {
    sources_ = std::move(sources);
    const auto named = [this](const std::string& name) {
        return std::ranges::find(sources_, name, &ScriptSource::name);
    };
    // Neither wanted nor a stand-in.
    const auto is_past = [&](const ScriptSource& text) {
        const auto wanted = named(text.name);
        const auto good = good_.find(text.name);
        return wanted != sources_.end() && !wanted->has_text_of(text) &&
               (good == good_.end() || !good->second.has_text_of(text));
    };
    std::erase_if(good_, [&](const auto& entry) { return named(entry.first) == sources_.end(); });
    std::erase_if(out_, [&](const ScriptSource& text) {
        return named(text.name) == sources_.end() || is_past(text);
    });
    std::erase_if(kills_, [&](const auto& entry) { return is_past(entry.first); });
    fresh_ = true;
    retry_at_ = 0;
}

void RemoteScriptHost::renew() {
    out_.clear();
    anew_ = true;
}

void RemoteScriptHost::stop() {
    if (running_) {
        channel_->kill();
    }
    running_ = false;
    waiting_ = false;
    output_.reset();
    stream_.clear();
}

ScriptOutput RemoteScriptHost::run(const ScriptWorld& world, std::span<const ScriptEvent> events) {
    ScriptOutput output;
    outgoing_.clear();
    for (const Evaluation& wanted : world.evaluations) {
        evaluating_.push_back(wanted.id);
    }
    if (world.ending ? !running_ : (fresh_ || !running_) && !start(output)) {
        give_up_evaluations(output, "scripts do not run");
        return output;
    }
    wire::encode_run(outgoing_, ++number_, world, events);
    channel_->send(outgoing_);
    waiting_ = true;
    watchdog_.start(now_);
    output.listening = last_.listening;
    return output;
}

// Who may not run is replaced by what ran before, if that may.
std::vector<ScriptSource> RemoteScriptHost::to_run() const {
    std::vector<ScriptSource> sources;
    for (const ScriptSource& source : sources_) {
        const ScriptSource* const one = may_run(source) ? &source : stand_in(source);
        if (one != nullptr && sources.size() < wire::most_scripts) {
            sources.push_back(*one);
            sources.back().store = source.store;
            sources.back().config = source.config;
        }
    }
    return sources;
}

const ScriptSource* RemoteScriptHost::stand_in(const ScriptSource& script) const {
    const auto found = good_.find(script.name);
    const bool helps = found != good_.end() && !found->second.has_text_of(script) &&
                       kills_.find(found->second) == kills_.end() && !out_.contains(found->second);
    return helps ? &found->second : nullptr;
}

// False when there is nothing to run, or no process to run it in.
bool RemoteScriptHost::start(ScriptOutput& output) {
    std::vector<ScriptSource> sources = to_run();
    if (sources.empty() && !running_) {
        fresh_ = false;
        return false;
    }
    if (!running_) {
        stream_.clear();
        if (const Result<void> started = channel_->start(); !started) {
            ++failures_;
            retry_at_ = now_ + delay_after(failures_);
            output.next_wake = 0;
            if (failures_ == 1) {
                output.log.push_back(about_host(LogLevel::error, started.error().message));
            }
            return false;
        }
        running_ = true;
    }
    wire::encode(
        outgoing_,
        wire::Load{
            .limits = limits_,
            .scripts = static_cast<std::uint32_t>(sources.size()),
            .anew = std::exchange(anew_, false),
        }
    );
    for (const ScriptSource& source : sources) {
        wire::encode(outgoing_, source);
    }
    sent_ = std::move(sources);
    fresh_ = false;
    untried_ = true;
    return true;
}

std::optional<ScriptOutput> RemoteScriptHost::take_output() {
    return std::exchange(output_, std::nullopt);
}

Ticks RemoteScriptHost::watch_due() const {
    if (waiting_) {
        return watchdog_.due();
    }
    return now_ < retry_at_ ? retry_at_ : never;
}

void RemoteScriptHost::watch(Ticks now) {
    now_ = now;
    if (!running_) {
        return;
    }
    // In this order: whatever a process said before its end has come by then.
    const std::optional<ScriptChannel::End> end = channel_->ended();
    hear();
    if (!running_) {
        return;
    }
    if (end) {
        look_after(*end);
    } else if (waiting_) {
        const std::string_view problem =
            watchdog_.look(channel_->pulse(), channel_->processor_time(), now);
        if (!problem.empty()) {
            end_process(problem, true);
        }
    }
}

void RemoteScriptHost::hear() {
    incoming_.clear();
    channel_->receive(incoming_);
    if (incoming_.empty()) {
        return;
    }
    stream_.add(incoming_);
    while (running_) {
        const auto message = stream_.next();
        if (!message) {
            return end_process(message.error().message, true);
        }
        if (!*message) {
            return;
        }
        Result<wire::Answer> answer = wire::decode_answer(**message);
        if (!answer) {
            return end_process(answer.error().message, true);
        }
        accept(*std::move(answer));
    }
}

void RemoteScriptHost::accept(wire::Answer answer) {
    if (!waiting_ || answer.number != number_) {
        return end_process("broken message: an answer that nobody waits for", true);
    }
    waiting_ = false;
    failures_ = 0;
    output_ = std::move(answer.output);
    keep_up(*output_);
    for (const Evaluated& each : output_->evaluated) {
        std::erase(evaluating_, each.id);
    }
    const bool others_end = put_out(output_->ended);
    if (fresh_) {
        output_->next_wake = 0;  // Others have been loaded meanwhile.
    } else if (sent_.empty() || (others_end && to_run().empty())) {
        output_->lost = true;
        std::optional<ScriptOutput> last_words = std::move(output_);
        stop();
        output_ = std::move(last_words);
    }
    last_.listening = output_->listening;
}

// True if that was news.
bool RemoteScriptHost::put_out(const std::vector<std::uint32_t>& places) {
    std::vector<bool> ended(sent_.size());
    bool news = false;
    for (const std::uint32_t place : places) {
        if (place < sent_.size()) {
            ended[place] = true;
            news = out_.insert(sent_[place]).second || news;
        }
    }
    for (std::size_t place = 0; untried_ && place < sent_.size(); ++place) {
        if (!ended[place]) {
            good_[sent_[place].name] = sent_[place];
        }
    }
    untried_ = false;
    return news;
}

void RemoteScriptHost::give_up_evaluations(ScriptOutput& output, const std::string& reason) {
    for (const std::uint64_t id : std::exchange(evaluating_, {})) {
        output.evaluated.push_back({.id = id, .good = false, .text = reason});
    }
}

std::vector<std::string> RemoteScriptHost::ended() const {
    std::vector<std::string> names;
    for (const ScriptSource& source : sources_) {
        if (!may_run(source) && stand_in(source) == nullptr) {
            names.push_back(source.name);
        }
    }
    return names;
}

// A process that starts again is sent what scripts have kept since they were loaded.
void RemoteScriptHost::keep_up(const ScriptOutput& output) {
    for (const ScriptCommand& command : output.commands) {
        if (const auto* const store = std::get_if<command::Store>(&command)) {
            const auto source = std::ranges::find(sources_, store->script, &ScriptSource::name);
            if (source != sources_.end()) {
                set_field(source->store, store->key, store->value);
            }
        }
    }
}

void RemoteScriptHost::look_after(const ScriptChannel::End& end) {
    end_process(fmt::format("ended its process ({})", end.how), end.crashed);
}

// The script that was running is named by the pulse, which may be a lie: then another one pays.
void RemoteScriptHost::end_process(std::string_view reason, bool blame) {
    const std::uint32_t running = channel_->pulse().script.load(std::memory_order_relaxed);
    channel_->kill();
    running_ = false;
    waiting_ = false;
    stream_.clear();
    last_ = {};
    if (!output_) {
        output_.emplace();
    }
    output_->listening = {};
    output_->next_wake = 0;
    output_->lost = true;
    if (blame && running != 0 && running <= sent_.size()) {
        const ScriptSource culprit = sent_[running - 1];
        out_.insert(culprit);
        ++kills_[culprit];
        const bool often = kills_[culprit] >= most_kills;
        if (often) {
            output_->given_up.push_back(culprit.name);
        }
        output_->log.push_back({
            LogLevel::error,
            culprit.name,
            fmt::format(
                "{}: {}; {}",
                culprit.name,
                reason,
                stand_in(culprit) != nullptr ? "its text before this one goes on"
                : often ? "stopped for the third time: it stays out until its text changes"
                        : "stopped until it is loaded again"
            ),
        });
    } else {
        ++failures_;
        retry_at_ = now_ + delay_after(failures_ - 1);
        output_->log.push_back(about_host(LogLevel::warning, fmt::format("it {}", reason)));
    }
    give_up_evaluations(*output_, output_->log.back().text);
    // Nobody is left to end what lasts until its script ends it.
    for (const ScriptSource& source : sent_) {
        if (std::ranges::count(source.permissions, "wind") != 0) {
            output_->commands.emplace_back(command::Wind{source.name, {}});
        }
    }
    if (!sent_.empty()) {
        output_->log.push_back(about_host(LogLevel::warning, "all other scripts start again"));
    }
}

}  // namespace hyrax
