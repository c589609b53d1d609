// SPDX-License-Identifier: MIT
// What happens to a script during a run, and in which order.
#include "daemon/script/api.h"
#include "daemon/script/sandbox.h"
#include "daemon/script/script.h"
#include "daemon/script/values.h"

#include <fmt/format.h>
#include <lauxlib.h>

#include <string_view>
#include <utility>
#include <vector>

namespace hyrax::script {
namespace {

// Parsing is one call that no hook interrupts.
constexpr std::int64_t units_per_source_byte = 10;

}  // namespace

void Script::begin(Run& run) {
    run_ = &run;
    commands_ = 0;
    view.renew(run.snapshot);
    journal.begin_run(now(), run.output.log);
}

bool Script::run_main_chunk(const ScriptSource& source) {
    loaded_at_ = now();
    failed_ = false;
    meter.begin(limits.load_units, limits.load_time);
    protect([this, &source](lua_State* lua) {
        open_sandbox(lua, *this);
        open_api(lua);
        std::string_view text = source.text;
        if (text.starts_with("\xEF\xBB\xBF")) {
            text.remove_prefix(3);
        }
        if (text.size() > limits.source) {
            luaL_error(
                lua,
                "source text of %d bytes is over the limit of %d",
                static_cast<int>(text.size()),
                static_cast<int>(limits.source)
            );
        }
        meter.charge(lua, static_cast<std::int64_t>(text.size()) * units_per_source_byte);
        const std::string chunk = "@" + name() + (source.file.empty() ? "" : "/" + source.file);
        if (luaL_loadbufferx(lua, text.data(), text.size(), chunk.c_str(), "t") != LUA_OK) {
            lua_error(lua);
        }
        start(lua, 0);
    });
    if (!failed_ && active()) {
        return true;
    }
    end();
    close();
    return false;
}

void Script::ready() {
    fire(Topic::ready, 0, 0, [](lua_State*, PetKey) { return 0; });
}

// What happened to a pet that is gone by now would only be an error in every handler.
void Script::deliver(const ScriptEvent& event) {
    const Topic topic = topic_of(event.event.kind);
    const auto is_gone = [this](PetKey pet) { return pet != 0 && view.find(pet) == nullptr; };
    if (is_about_pets(topic) && topic != Topic::remove &&
        (event.pet == 0 || is_gone(event.pet) || is_gone(event.other))) {
        return;
    }
    // Who begins to wait in a handler does not hear the event that the handler is about.
    const auto waiters = waiters_for(topic, event);
    fire(topic, event.pet, event.other, [&event](lua_State* lua, PetKey subject) {
        return push_event(lua, event, subject);
    });
    for (const std::uint64_t id : waiters) {
        if (const auto waiter = schedule.take_waiter(id); waiter && active()) {
            wake(*waiter, [&](lua_State* lua) { return push_outcome(lua, event, waiter->pet); });
        }
    }
}

void Script::change_setting(const std::string& key, const ScriptValue& value) {
    set_field(belongings.config, key, value);
    if (!active()) {
        return;
    }
    protect([&](lua_State* lua) {
        push_value(lua, value);
        set_config(lua, key);
    });
    fire(Topic::config, 0, 0, [&](lua_State* lua, PetKey) {
        lua_pushlstring(lua, key.data(), key.size());
        push_value(lua, value);
        return 2;
    });
}

void Script::press_hotkey(std::uint64_t id) {
    if (const Handler* const handler = schedule.handler(id);
        handler != nullptr && handler->topic == Topic::hotkey && active()) {
        call(handler->function, [](lua_State*) { return 0; });
    }
}

// Handlers may come and go meanwhile: those that are there now, as far as they still are.
template <typename PushArguments>
void Script::fire(Topic topic, PetKey first, PetKey second, PushArguments push) {
    std::vector<std::uint64_t> handlers;
    for (const Handler& handler : schedule.handlers()) {
        if (handler.hears(topic, first, second)) {
            handlers.push_back(handler.id);
        }
    }
    for (const std::uint64_t id : handlers) {
        if (const Handler* const handler = schedule.handler(id); handler != nullptr && active()) {
            const PetKey subject = handler->pet;
            call(handler->function, [&](lua_State* lua) { return push(lua, subject); });
        }
    }
}

std::vector<std::uint64_t> Script::waiters_for(Topic topic, const ScriptEvent& event) const {
    std::vector<std::uint64_t> waiters;
    for (const Waiter& waiter : schedule.waiters()) {
        if (waiter.pet != 0 && waiter.topic == topic &&
            (waiter.pet == event.pet || waiter.pet == event.other)) {
            waiters.push_back(waiter.id);
        }
    }
    return waiters;
}

void Script::run_due() {
    end_waits_for_gone_pets();
    while (active()) {
        if (const auto waiter = schedule.take_due_waiter(now(), schedule.next_timer())) {
            wake(*waiter, [&](lua_State* lua) {
                if (waiter->pet == 0) {
                    lua_pushnumber(lua, to_seconds(now() - waiter->since));
                } else {
                    lua_pushnil(lua);  // the timeout of wait_for
                }
                return 1;
            });
        } else if (const auto timer = schedule.take_timer(now())) {
            call(timer->function, [](lua_State*) { return 0; });
            if (timer->period == 0) {
                release(timer->function);
            }
        } else {
            break;
        }
    }
    if (active()) {
        if (const auto seconds = schedule.take_tick(now())) {
            fire(Topic::tick, 0, 0, [&seconds](lua_State* lua, PetKey) {
                lua_pushnumber(lua, *seconds);
                return 1;
            });
        }
        run_tests();
    }
}

// One after the other; a case that ends at once makes room for the next.
void Script::run_tests() {
    while (active()) {
        const auto function = tests.begin_next(now());
        if (!function) {
            break;
        }
        call(*function, [](lua_State*) { return 0; });
        release(*function);
    }
    run_->output.open_tests += tests.open();
}

// The next case finds no pet of this one.
void Script::end_test() {
    if (auto ended = tests.end(name(), now())) {
        run_->output.tests.push_back(*std::move(ended));
    }
    remove_pets();
}

void Script::remove_pets() {
    std::vector<PetKey> own;
    view.for_each([&](const PetView& pet) {
        if (pet.owner == name()) {
            own.push_back(pet.key);
        }
    });
    for (const PetKey pet : own) {
        run_->output.commands.emplace_back(command::Remove{pet});
        view.remove(pet);
    }
}

void Script::give_up_tests(const char* problem) {
    for (ScriptTest& ended : tests.give_up(name(), now(), problem)) {
        run_->output.tests.push_back(std::move(ended));
    }
}

void Script::end_waits_for_gone_pets() {
    std::vector<std::uint64_t> ended;
    for (const Waiter& waiter : schedule.waiters()) {
        if (waiter.pet != 0 && view.is_past(waiter.pet)) {
            ended.push_back(waiter.id);
        }
    }
    for (const std::uint64_t id : ended) {
        if (const auto waiter = schedule.take_waiter(id); waiter && active()) {
            wake(*waiter, [](lua_State* lua) {
                lua_pushnil(lua);
                return 1;
            });
        }
    }
}

void Script::forget_gone_pets() {
    std::vector<std::uint64_t> gone;
    for (const Handler& handler : schedule.handlers()) {
        if (handler.pet != 0 && view.is_past(handler.pet)) {
            gone.push_back(handler.id);
        }
    }
    for (const std::uint64_t id : gone) {
        if (const auto function = schedule.cancel(id)) {
            release(*function);
        }
    }
    forget_handles(lua_, view);
}

void Script::end() {
    if (lua_ == nullptr) {
        return;
    }
    if (!active()) {
        drop_hotkeys();
        end_wind();
        give_up_tests("the script was stopped");
    }
    if (meter.killed()) {
        if (tests.enabled()) {
            run_->output.tests.push_back({name(), "its end", meter.verdict().reason, 0.0});
        }
        const std::size_t line = run_->output.log.size();
        journal.ended(meter.verdict().reason, meter.verdict().trace);
        give_up_evaluations(run_->output.log[line].text);
        close();
    } else {
        forget_gone_pets();
    }
}

void Script::unload(const char* reason) {
    if (lua_ == nullptr) {
        return;
    }
    unloading_ = true;
    meter.begin(limits.unload_units, limits.callback_time);
    fire(Topic::unload, 0, 0, [reason](lua_State* lua, PetKey) {
        lua_pushstring(lua, reason);
        return 1;
    });
    end();
    give_up_evaluations(name() + ": was unloaded");
    drop_hotkeys();
    end_wind();
    close();
}

void Script::end_wind() {
    if (belongings.wind != Vec2{}) {
        belongings.wind = {};
        run_->output.commands.emplace_back(command::Wind{name(), {}});
    }
}

void Script::drop_hotkeys() {
    for (const Handler& handler : schedule.handlers()) {
        if (handler.topic == Topic::hotkey) {
            run_->output.commands.emplace_back(command::Hotkey{name(), handler.id, "", ""});
        }
    }
    schedule.drop(Topic::hotkey);
}

template <std::invocable<lua_State*> PushArguments>
void Script::call(int function, PushArguments push) {
    if (!unloading_) {  // whose handlers share one budget
        meter.begin(limits.callback_units, limits.callback_time);
    }
    protect([&](lua_State* lua) {
        lua_rawgeti(lua, LUA_REGISTRYINDEX, function);
        start(lua, push(lua));
    });
}

template <std::invocable<lua_State*> PushArguments>
void Script::wake(const Waiter& waiter, PushArguments push) {
    meter.begin(limits.callback_units, limits.callback_time);
    protect([&](lua_State* lua) {
        const int results = push(lua);
        lua_xmove(lua, waiter.thread.lua, results);
        resume(waiter.thread, lua, results);
    });
}

}  // namespace hyrax::script
