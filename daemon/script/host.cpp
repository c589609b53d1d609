// SPDX-License-Identifier: MIT
// All scripts in one process and on one thread: who runs when, and what comes out.
#include "daemon/script/script.h"
#include "daemon/script/script_host.h"

#include <algorithm>
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
    explicit PumpHost(const ScriptLimits& limits) : limits_(limits) {}

    void load(std::vector<ScriptSource> sources) override {
        scripts_.clear();
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
            for (const auto& script : scripts_) {
                script->deliver(event);
            }
        }
        for (const auto& script : scripts_) {
            script->run_due();
            script->end();
            output.listening.add(script->listening());
            output.next_wake = std::min(output.next_wake, script->next_wake());
        }
        return output;
    }

private:
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
            Script& script = *scripts_.emplace_back(std::make_unique<Script>(source.name, limits_));
            script.begin(run);
            script.run_main_chunk(source.text);
        }
        if (!sources.empty()) {
            for (const auto& script : scripts_) {
                script->ready();
            }
        }
    }

    const ScriptLimits limits_;
    std::vector<std::unique_ptr<Script>> scripts_;
    std::vector<ScriptSource> new_sources_;
    std::uint64_t last_made_key_ = 0;
};

}  // namespace

std::unique_ptr<ScriptHost> make_script_host(const ScriptLimits& limits) {
    return std::make_unique<PumpHost>(limits);
}

}  // namespace hyrax
