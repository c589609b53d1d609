// SPDX-License-Identifier: MIT
// All scripts in one process and on one thread: who runs when, and what comes out.
#include "daemon/script/script.h"
#include "daemon/script/script_host.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
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
        // Those that have been loaded, but have not run yet, have nothing to say.
        leaving_.insert(
            leaving_.end(),
            std::make_move_iterator(scripts_.begin()),
            std::make_move_iterator(scripts_.end())
        );
        scripts_.clear();
        new_sources_ = std::move(sources);
    }

    ScriptOutput run(const ScriptWorld& world, std::span<const ScriptEvent> events) override {
        ScriptOutput output;
        Run run{Snapshot(world), output, last_made_key_};
        keep_keys_apart(world);
        end_leaving_scripts(run);
        for (const auto& script : scripts_) {
            script->begin(run);
        }
        start_new_scripts(run);
        for (const ScriptSetting& setting : world.new_settings) {
            if (Script* const script = find(setting.script)) {
                script->change_setting(setting);
            }
        }
        for (const PressedHotkey& pressed : world.pressed_hotkeys) {
            if (Script* const script = find(pressed.script)) {
                script->press_hotkey(pressed.id);
            }
        }
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
        if (world.ending) {
            for (const auto& script : std::exchange(scripts_, {})) {
                script->unload("exit");
            }
            output.listening = {};
            output.next_wake = never;
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

    Script* find(const std::string& name) const {
        const auto found = std::ranges::find(scripts_, name, [](const auto& script) -> auto& {
            return script->name();
        });
        return found == scripts_.end() ? nullptr : found->get();
    }

    void end_leaving_scripts(Run& run) {
        for (const auto& script : std::exchange(leaving_, {})) {
            const auto next = std::ranges::find(new_sources_, script->name(), &ScriptSource::name);
            const bool comes_back = next != new_sources_.end();
            script->begin(run);
            script->unload(comes_back ? "reload" : "disable");
            if (comes_back) {  // with what it has just kept
                next->store = script->belongings.store;
            }
        }
    }

    // All main chunks run before the first handler does.
    void start_new_scripts(Run& run) {
        const std::vector<ScriptSource> sources = std::exchange(new_sources_, {});
        for (const ScriptSource& source : sources) {
            Script& script = *scripts_.emplace_back(std::make_unique<Script>(source, limits_));
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
    std::vector<std::unique_ptr<Script>> leaving_;  // Replaced: they hear of it in the next run.
    std::vector<ScriptSource> new_sources_;
    std::uint64_t last_made_key_ = 0;
};

}  // namespace

std::unique_ptr<ScriptHost> make_script_host(const ScriptLimits& limits) {
    return std::make_unique<PumpHost>(limits);
}

}  // namespace hyrax
