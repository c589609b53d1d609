// SPDX-License-Identifier: MIT
// A process that a test plays: it reads what was sent and says, hangs and dies as the test wants.
#pragma once

#include "daemon/core/script_channel.h"
#include "daemon/core/script_wire.h"

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace hyrax {

struct FakeProcess {
    int starts = 0;
    int kills = 0;
    bool alive = false;
    bool refuses_to_start = false;
    wire::Bytes to_say;
    std::vector<wire::ToHost> heard;  ///< Everything that was sent to the living process.
    std::optional<ScriptChannel::End> end;
    ScriptPulse pulse{};
    std::optional<Ticks> used = 0;
    std::function<void()> while_waited_for{};

    template <typename Message>
    std::vector<Message> heard_of() const {
        std::vector<Message> found;
        for (const wire::ToHost& message : heard) {
            if (const auto* const it = std::get_if<Message>(&message)) {
                found.push_back(*it);
            }
        }
        return found;
    }
    void answer(ScriptOutput output = {}) {
        wire::encode_answer(to_say, heard_of<wire::Run>().back().number, output);
    }
    void crash() { end = {.crashed = true, .how = "signal 11"}; }
    void be_killed() { end = {.crashed = false, .how = "signal 9"}; }
};

class FakeScriptChannel final : public ScriptChannel {
public:
    explicit FakeScriptChannel(FakeProcess& process) : process_(process) {}

    Result<void> start() override {
        if (process_.refuses_to_start) {
            return failure("no such program");
        }
        ++process_.starts;
        process_.alive = true;
        process_.heard.clear();
        process_.to_say.clear();
        process_.end.reset();
        process_.pulse.script = 0;
        return {};
    }
    void send(std::span<const std::byte> bytes) override {
        stream_.add(bytes);
        while (const auto message = stream_.next().value()) {
            process_.heard.push_back(wire::decode_to_host(*message).value());
        }
    }
    void receive(wire::Bytes& bytes) override {
        bytes.insert(bytes.end(), process_.to_say.begin(), process_.to_say.end());
        process_.to_say.clear();
    }
    std::optional<End> ended() override { return process_.end; }
    bool wait(std::chrono::milliseconds) override {
        if (process_.while_waited_for) {
            process_.while_waited_for();
        }
        return process_.alive && process_.while_waited_for;
    }
    void kill() override {
        ++process_.kills;
        process_.alive = false;
        stream_.clear();
    }
    const ScriptPulse& pulse() const override { return process_.pulse; }
    std::optional<Ticks> processor_time() override { return process_.used; }

private:
    FakeProcess& process_;
    wire::MessageStream stream_{wire::longest_to_host};
};

}  // namespace hyrax
