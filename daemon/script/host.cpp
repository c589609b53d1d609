// SPDX-License-Identifier: MIT
// All scripts in one process and on one thread: who runs when, and what comes out.
#include "daemon/script/script.h"
#include "daemon/script/script_host.h"

#include <algorithm>
#include <concepts>
#include <memory>
#include <utility>
#include <vector>

namespace hyrax {
namespace {

using script::Run;
using script::Script;
using script::Snapshot;

class PumpHost final : public ScriptHost {
public:
    explicit PumpHost(const ScriptLimits& limits) : next_limits_(limits), limits_(limits) {}

    // The clock and the pulse belong to this process.
    void set_limits(const ScriptLimits& limits) override {
        const ScriptLimits own = std::exchange(next_limits_, limits);
        next_limits_.processor_time =
            limits.processor_time != nullptr ? limits.processor_time : own.processor_time;
        next_limits_.pulse = limits.pulse != nullptr ? limits.pulse : own.pulse;
    }

    void load(std::vector<ScriptSource> sources) override {
        scripts_.clear();
        limits_ = next_limits_;
        new_sources_ = std::move(sources);
    }

    ScriptOutput run(const ScriptWorld& world, std::span<const ScriptEvent> events) override {
        ScriptOutput output;
        Run run{Snapshot(world), output, last_made_key_};
        keep_keys_apart(world);
        for (const auto& script : scripts_) {
            script->begin(run);
        }
        start_new_scripts(run);
        for (const ScriptEvent& event : events) {
            for_each([&event](Script& script) { script.deliver(event); });
        }
        for_each([&output](Script& script) {
            script.run_due();
            script.end();
            output.listening.add(script.listening());
            output.next_wake = std::min(output.next_wake, script.next_wake());
        });
        for (std::uint32_t place = 0; place < scripts_.size(); ++place) {
            if (scripts_[place]->ended()) {
                output.ended.push_back(place);
            }
        }
        return output;
    }

private:
    // Calls into every script, and says so.
    template <std::invocable<Script&> Call>
    void for_each(Call call) {
        for (std::uint32_t place = 0; place < scripts_.size(); ++place) {
            if (limits_.pulse != nullptr) {
                limits_.pulse->enter(place);
            }
            call(*scripts_[place]);
        }
        if (limits_.pulse != nullptr) {
            limits_.pulse->leave();
        }
    }

    // Pets may have been spawned by a host before this one.
    void keep_keys_apart(const ScriptWorld& world) {
        for (const PetView& pet : world.pets) {
            if ((pet.key & script_made_key) != 0) {
                last_made_key_ = std::max(last_made_key_, pet.key & ~script_made_key);
            }
        }
    }

    // All main chunks run before the first handler does.
    void start_new_scripts(Run& run) {
        const std::vector<ScriptSource> sources = std::exchange(new_sources_, {});
        for (const ScriptSource& source : sources) {
            scripts_.emplace_back(std::make_unique<Script>(source.name, limits_))->begin(run);
        }
        if (!sources.empty()) {
            auto source = sources.begin();
            for_each([&source](Script& script) { script.run_main_chunk(source++->text); });
            for_each([](Script& script) { script.ready(); });
        }
    }

    ScriptLimits next_limits_;
    ScriptLimits limits_;  // Scripts refer to it.
    std::vector<std::unique_ptr<Script>> scripts_;
    std::vector<ScriptSource> new_sources_;
    std::uint64_t last_made_key_ = 0;
};

}  // namespace

std::unique_ptr<ScriptHost> make_script_host(const ScriptLimits& limits) {
    return std::make_unique<PumpHost>(limits);
}

}  // namespace hyrax
