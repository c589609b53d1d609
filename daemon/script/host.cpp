// SPDX-License-Identifier: MIT
// All scripts in one process and on one thread: who runs when, what comes out, and how a new text
// takes the place of an old one.
#include "daemon/script/script.h"
#include "daemon/script/script_host.h"

#include <algorithm>
#include <concepts>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hyrax {
namespace {

using script::Run;
using script::Script;
using script::Snapshot;

/// A script and what it was made from, but for its store, which is its own.
struct Loaded {
    ScriptSource source;
    std::unique_ptr<Script> script;
    std::optional<ScriptSource> refused{};  ///< A newer text that failed.
    bool is_new = false;
    ScriptUse told{};  ///< As the last output has it.

    bool runs(const ScriptSource& other) const {
        return source.name == other.name && source.has_text_of(other) && runs_alike(other);
    }
    bool has_refused(const ScriptSource& other) const {
        return refused && refused->has_text_of(other) && runs_alike(other);
    }

private:
    bool runs_alike(const ScriptSource& other) const {
        return source.version == other.version && source.permissions == other.permissions &&
               source.file == other.file && source.testing == other.testing;
    }
};

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
        new_sources_ = std::move(sources);
        loading_ = true;
    }

    void renew() override { anew_ = true; }

    ScriptOutput run(const ScriptWorld& world, std::span<const ScriptEvent> events) override {
        ScriptOutput output;
        Run run{Snapshot(world), output, last_made_key_};
        keep_keys_apart(world);
        for (const Loaded& each : scripts_) {
            each.script->begin(run);
        }
        if (std::exchange(loading_, false)) {
            replace_scripts(run);
        }
        for (const Evaluation& wanted : world.evaluations) {
            evaluate(wanted, output);
        }
        for (const PressedHotkey& pressed : world.pressed_hotkeys) {
            for_each([&pressed](Script& script) {
                if (script.name() == pressed.script) {
                    script.press_hotkey(pressed.id);
                }
            });
        }
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
            if (scripts_[place].script->ended() || scripts_[place].refused) {
                output.ended.push_back(place);
            }
        }
        tell_of_uses(output);
        if (world.ending) {
            for (const Loaded& each : std::exchange(scripts_, {})) {
                each.script->unload("exit");
            }
            output.listening = {};
            output.next_wake = never;
        }
        return output;
    }

    std::vector<std::string> ended() const override {
        std::vector<std::string> names;
        for (const Loaded& each : scripts_) {
            if (each.script->ended()) {
                names.push_back(each.source.name);
            }
        }
        return names;
    }

private:
    // What runs until this goes is the work of the script at this place.
    class Turn {
    public:
        Turn(ScriptPulse* pulse, std::size_t place) : pulse_(pulse) {
            if (pulse_ != nullptr) {
                pulse_->enter(static_cast<std::uint32_t>(place));
            }
        }
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;
        ~Turn() {
            if (pulse_ != nullptr) {
                pulse_->leave();
            }
        }

    private:
        ScriptPulse* pulse_;
    };

    template <std::invocable<Script&> Call>
    void for_each(Call call) {
        for (std::size_t place = 0; place < scripts_.size(); ++place) {
            const Turn turn(limits_.pulse, place);
            call(*scripts_[place].script);
        }
    }

    void evaluate(const Evaluation& wanted, ScriptOutput& output) {
        const auto found = std::ranges::find_if(scripts_, [&wanted](const Loaded& each) {
            return each.source.name == wanted.script && each.script->active();
        });
        if (found == scripts_.end()) {
            output.evaluated.push_back(
                {.id = wanted.id, .good = false, .text = wanted.script + " does not run"}
            );
            return;
        }
        const Turn turn(limits_.pulse, static_cast<std::size_t>(found - scripts_.begin()));
        found->script->evaluate(wanted);
    }

    void tell_of_uses(ScriptOutput& output) {
        for (Loaded& each : scripts_) {
            if (ScriptUse use = each.script->use(); use != each.told) {
                each.told = use;
                output.uses.push_back(std::move(use));
            }
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
    void replace_scripts(Run& run) {
        std::vector<Loaded> former = std::exchange(scripts_, {});
        const bool all = std::exchange(anew_, false) || limits_ != next_limits_;
        limits_ = next_limits_;
        for (ScriptSource& source : std::exchange(new_sources_, {})) {
            const auto old = std::ranges::find_if(former, [&source](const Loaded& each) {
                return each.script != nullptr && each.source.name == source.name;
            });
            if (old == former.end()) {
                scripts_.push_back(started(std::move(source), run));
            } else if (!all && (old->runs(source) || old->has_refused(source))) {
                scripts_.push_back(kept(std::move(*old), source));
            } else {
                scripts_.push_back(replaced(std::move(*old), std::move(source), run));
            }
        }
        for (const Loaded& gone : former) {
            if (gone.script != nullptr) {
                gone.script->unload("disable");
            }
        }
        for (std::size_t place = 0; place < scripts_.size(); ++place) {
            if (std::exchange(scripts_[place].is_new, false)) {
                const Turn turn(limits_.pulse, place);
                scripts_[place].script->ready();
            }
        }
    }

    // It goes to the next place, and leaves no commands if it fails.
    Loaded started(ScriptSource source, Run& run) {
        const std::size_t commands = run.output.commands.size();
        auto script = std::make_unique<Script>(source, limits_);
        script->begin(run);
        const Turn turn(limits_.pulse, scripts_.size());
        const bool good = script->run_main_chunk(source);
        if (!good) {
            run.output.commands.resize(commands);
        }
        source.store.clear();
        return {.source = std::move(source), .script = std::move(script), .is_new = good};
    }

    Loaded kept(Loaded old, const ScriptSource& source) {
        if (!old.has_refused(source)) {
            old.refused.reset();
        }
        const Turn turn(limits_.pulse, scripts_.size());
        const ScriptTable before = std::exchange(old.source.config, source.config);
        for (const ScriptField& field : source.config) {
            const ScriptValue* const known = find_field(before, field.name);
            if (known == nullptr || *known != field.value) {
                old.script->change_setting(field.name, field.value);
            }
        }
        for (const ScriptField& field : before) {
            if (find_field(source.config, field.name) == nullptr) {
                old.script->change_setting(field.name, {});
            }
        }
        return old;
    }

    // The new text runs once on trial, so that the old one does not hear of its end, and say what
    // it keeps, before there is somebody to go on.
    Loaded replaced(Loaded old, ScriptSource source, Run& run) {
        source.store = old.script->belongings.store;
        if (old.script->active() && !passes_trial(source, run)) {
            old.script->journal.tell(
                LogLevel::warning, "the text before this one goes on, until it is saved again"
            );
            old.refused = std::move(source);
            return old;
        }
        if (!source.keep_pets) {
            old.script->remove_pets();
        }
        old.script->unload("reload");
        source.store = old.script->belongings.store;
        return started(std::move(source), run);
    }

    bool passes_trial(const ScriptSource& source, Run& run) {
        const ScriptOutput before = run.output;
        const Loaded trial = started(source, run);
        if (trial.is_new) {
            run.output = before;  // It says all of it again.
        }
        return trial.is_new;
    }

    ScriptLimits next_limits_;
    ScriptLimits limits_;
    std::vector<Loaded> scripts_;
    std::vector<ScriptSource> new_sources_;
    bool loading_ = false;
    bool anew_ = false;
    std::uint64_t last_made_key_ = 0;
};

}  // namespace

std::unique_ptr<ScriptHost> make_script_host(const ScriptLimits& limits) {
    return std::make_unique<PumpHost>(limits);
}

}  // namespace hyrax
