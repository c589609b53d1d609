// SPDX-License-Identifier: MIT
// Which fields of the wire's structs go over it, in which order and within which bounds: one
// description each, by which script_wire.cpp both writes and reads.
#pragma once

#include "daemon/core/script_wire.h"

#include <chrono>
#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>

namespace hyrax::wire {

/// T, or const T: the one to be read, or to be written.
template <typename Given, typename T>
concept Is = std::same_as<std::remove_const_t<Given>, T>;

void fields(auto& wire, Is<bool> auto& flag) {
    wire.flag(flag);
}

void fields(auto& wire, Is<double> auto& number) {
    wire.finite(number);
}

void fields(auto& wire, Is<std::int64_t> auto& number) {
    wire.whole(number);
}

/// In a value or in a list of names.
void fields(auto& wire, Is<std::string> auto& text) {
    wire.text(text, longest_text);
}

void fields(auto& wire, Is<Vec2> auto& v) {
    wire.number(v.x);
    wire.number(v.y);
}

void fields(auto& wire, Is<Size> auto& size) {
    wire.length(size.width);
    wire.length(size.height);
}

void fields(auto& wire, Is<Rect> auto& rect) {
    wire.whole(rect.x);
    wire.whole(rect.y);
    wire.length(rect.width);
    wire.length(rect.height);
}

void fields(auto& wire, Is<Monitor> auto& monitor) {
    fields(wire, monitor.bounds);
    fields(wire, monitor.work);
    wire.flag(monitor.primary);
    wire.text(monitor.name, longest_name);
}

void fields(auto& wire, Is<Kind> auto& kind) {
    wire.text(kind.name, longest_name);
    fields(wire, kind.box);
    wire.list(kind.animations, most_animations);
}

void fields(auto& wire, Is<PetView> auto& pet) {
    wire.whole(pet.key);
    wire.text(pet.kind, longest_name);
    wire.text(pet.owner, longest_name);
    wire.text(pet.tag, longest_name);
    wire.finite(pet.position);
    wire.finite(pet.velocity);
    fields(wire, pet.box);
    wire.text(pet.state, longest_name);
    wire.flag(pet.faces_left);
    wire.finite(pet.scale);
    wire.finite(pet.spawned_at);
}

void fields(auto& /*wire*/, Is<std::monostate> auto& /*nothing*/) {}

void fields(auto& wire, Is<ScriptValue> auto& value) {
    wire.nested(value);
}

void fields(auto& wire, Is<ScriptValue::List> auto& list) {
    wire.list(list, most_values);
}

void fields(auto& wire, Is<ScriptField> auto& field) {
    wire.text(field.name, longest_text);
    wire.nested(field.value);
}

void fields(auto& wire, Is<ScriptTable> auto& table) {
    wire.list(table, most_values);
    wire.sorted(table);
}

void fields(auto& wire, Is<PressedHotkey> auto& pressed) {
    wire.text(pressed.script, longest_name);
    wire.whole(pressed.id);
}

void fields(auto& wire, Is<Evaluation> auto& evaluation) {
    wire.whole(evaluation.id);
    wire.text(evaluation.script, longest_name);
    wire.text(evaluation.text, longest_evaluation);
}

void fields(auto& wire, Is<Evaluated> auto& evaluated) {
    wire.whole(evaluated.id);
    wire.flag(evaluated.good);
    wire.lines(evaluated.text, longest_evaluated);
    wire.lines(evaluated.printed, longest_evaluated);
}

void fields(auto& wire, Is<ScriptWorld> auto& world) {
    wire.whole(world.now);
    wire.list(world.pets, most_pets);
    wire.list(world.monitors, most_monitors);
    wire.list(world.kinds, most_kinds);
    wire.finite(world.cursor);
    wire.list(world.windows, most_windows);
    wire.list(world.pressed_hotkeys, most_told);
    wire.list(world.evaluations, most_told);
    wire.flag(world.ending);
}

/// Without the pets' ids, which mean nothing outside the engine.
void fields(auto& wire, Is<ScriptEvent> auto& event) {
    wire.choice(event.event.kind, last_event_kind);
    wire.choice(event.event.side, Side::bottom);
    wire.choice(event.event.button, Button::middle);
    wire.finite(event.event.speed);
    wire.finite(event.event.velocity);
    wire.text(event.event.tag, longest_name);
    wire.whole(event.pet);
    wire.whole(event.other);
}

void fields(auto& wire, Is<SpawnOptions> auto& options) {
    wire.text(options.kind, longest_name);
    wire.optional(options.at);
    fields(wire, options.velocity);
    wire.text(options.owner, longest_name);
    wire.text(options.tag, longest_name);
    wire.number(options.scale);
    wire.number(options.opacity);
}

void fields(auto& wire, Is<command::Spawn> auto& spawn) {
    wire.made_key(spawn.key);
    fields(wire, spawn.options);
}

void fields(auto& wire, Is<command::Fling> auto& fling) {
    wire.whole(fling.pet);
    fields(wire, fling.velocity);
}

void fields(auto& wire, Is<command::Push> auto& push) {
    wire.whole(push.pet);
    fields(wire, push.change);
}

void fields(auto& wire, Is<command::Stop> auto& stop) {
    wire.whole(stop.pet);
}

void fields(auto& wire, Is<command::Reset> auto& reset) {
    wire.whole(reset.pet);
}

void fields(auto& wire, Is<command::MoveTo> auto& move) {
    wire.whole(move.pet);
    fields(wire, move.position);
}

void fields(auto& wire, Is<command::SetTag> auto& set) {
    wire.whole(set.pet);
    wire.text(set.tag, longest_name);
}

void fields(auto& wire, Is<command::Remove> auto& remove) {
    wire.whole(remove.pet);
}

void fields(auto& wire, Is<command::WalkTo> auto& walk) {
    wire.whole(walk.pet);
    wire.number(walk.x);
    wire.number(walk.speed);
}

void fields(auto& wire, Is<command::Play> auto& play) {
    wire.whole(play.pet);
    wire.text(play.animation, longest_name);
    wire.optional(play.loop);
    wire.number(play.fps);
}

void fields(auto& wire, Is<command::Say> auto& say) {
    wire.whole(say.pet);
    wire.text(say.text, longest_line);
    wire.number(say.seconds);
}

void fields(auto& wire, Is<command::SetScale> auto& set) {
    wire.whole(set.pet);
    wire.number(set.scale);
}

void fields(auto& wire, Is<command::Face> auto& face) {
    wire.whole(face.pet);
    wire.flag(face.left);
}

void fields(auto& wire, Is<command::Store> auto& store) {
    wire.text(store.script, longest_name);
    wire.text(store.key, longest_name);
    wire.nested(store.value);
}

void fields(auto& wire, Is<command::Notify> auto& notify) {
    wire.text(notify.script, longest_name);
    wire.line(notify.text, longest_line);
}

void fields(auto& wire, Is<command::Hotkey> auto& hotkey) {
    wire.text(hotkey.script, longest_name);
    wire.whole(hotkey.id);
    wire.text(hotkey.keys, longest_name);
    wire.text(hotkey.label, longest_line);
}

void fields(auto& wire, Is<command::Wind> auto& wind) {
    wire.text(wind.script, longest_name);
    wire.number(wind.velocity.x);
    wire.number(wind.velocity.y);
}

void fields(auto& wire, Is<ScriptCommand> auto& command) {
    wire.alternative(command, "there is no such command");
}

void fields(auto& wire, Is<ScriptLog> auto& log) {
    wire.choice(log.level, LogLevel::error);
    wire.line(log.script, longest_name);
    wire.line(log.text, longest_line);
}

void fields(auto& wire, Is<std::uint32_t> auto& number) {
    wire.whole(number);
}

void fields(auto& wire, Is<ScriptTest> auto& test) {
    wire.line(test.script, longest_name);
    wire.line(test.name, longest_line);
    wire.line(test.problem, longest_line);
    wire.finite(test.seconds);
}

void fields(auto& wire, Is<ScriptUse> auto& use) {
    wire.line(use.script, longest_name);
    wire.whole(use.units);
    wire.whole(use.memory);
    wire.whole(use.errors);
    wire.events(use.listening);
}

void fields(auto& wire, Is<ScriptOutput> auto& output) {
    wire.list(output.commands, most_commands);
    wire.list(output.log, most_lines);
    wire.events(output.listening);
    wire.whole(output.next_wake);
    wire.list(output.ended, most_scripts);
    wire.list(output.tests, most_tests);
    wire.whole(output.open_tests);
    wire.list(output.evaluated, most_told);
    wire.list(output.uses, most_scripts);
}

/// Without what only the other process can know.
void fields(auto& wire, Is<ScriptLimits> auto& limits) {
    wire.positive(limits.memory);
    wire.positive(limits.string);
    wire.positive(limits.source);
    wire.positive(limits.chunk);
    wire.positive(limits.load_units);
    wire.positive(limits.callback_units);
    wire.positive(limits.unload_units);
    wire.time(limits.load_time);
    wire.time(limits.callback_time);
    wire.positive(limits.pets);
    wire.positive(limits.timers);
    wire.positive(limits.handlers);
    wire.positive(limits.waiting);
    wire.positive(limits.commands);
    wire.positive(limits.max_speed);
    wire.positive(limits.name);
    wire.positive(limits.log_lines_per_second);
    wire.positive(limits.log_burst);
    wire.positive(limits.log_line);
    wire.positive(limits.store);
    wire.positive(limits.speech);
    wire.time(limits.notice_pause);
    wire.whole(limits.seed);
}

void fields(auto& wire, Is<Load> auto& load) {
    fields(wire, load.limits);
    wire.count(load.scripts, most_scripts);
    wire.flag(load.anew);
}

void fields(auto& wire, Is<ScriptModule> auto& module) {
    wire.text(module.name, longest_name);
    wire.text(module.text, longest_source);
}

void fields(auto& wire, Is<ScriptSource> auto& source) {
    wire.text(source.name, longest_name);
    wire.text(source.text, longest_source);
    wire.text(source.version, longest_name);
    wire.text(source.file, longest_name);
    wire.list(source.modules, most_modules);
    wire.list(source.permissions, most_permissions);
    fields(wire, source.config);
    fields(wire, source.store);
    wire.flag(source.keep_pets);
    wire.flag(source.testing);
    wire.whole(source.turn);
}

void fields(auto& wire, Is<Run> auto& run) {
    wire.whole(run.number);
    fields(wire, run.world);
    wire.list(run.events, most_events);
}

void fields(auto& wire, Is<Answer> auto& answer) {
    wire.whole(answer.number);
    fields(wire, answer.output);
}

}  // namespace hyrax::wire
