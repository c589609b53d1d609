// SPDX-License-Identifier: MIT
#include "tests/script/random_program.h"

#include <cstddef>
#include <initializer_list>
#include <random>
#include <span>
#include <string_view>

namespace hyrax {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::string_view numbers[]{
    "0",       "1",      "-1",   "0.5",   "100",     "-300",        "640",  "1e4",
    "1e308",   "-1e308", "0/0",  "1/0",   "-1/0",    "1e-320",      "2^53", "math.mininteger",
    "1 << 62", "'7'",    "3.99", "0.004", "math.pi", "hyrax.now()", "-0.0", "20000",
};
constexpr std::string_view oddities[]{
    "nil",
    "true",
    "false",
    "{}",
    "'x'",
    "('y'):rep(300)",
    "'\\255\\254'",
    "'a\\0b'",
    "print",
    "hyrax",
    "coroutine.create(print)",
    "setmetatable({}, { __index = error })",
    "setmetatable({}, { __tostring = function() hyrax.wait(1) end })",
    "_G",
    "({})[1]",
};
constexpr std::string_view texts[]{
    "'hello'",
    "''",
    "'stage'",
    "'a longer text that has to be wrapped into several lines'",
    "'\\u{e4}\\u{1F600}'",
    "('word '):rep(30)",
    "tostring(pick())",
};
constexpr std::string_view events[]{
    "ready",
    "tick",
    "spawn",
    "remove",
    "grab",
    "throw",
    "bounce",
    "land",
    "click",
    "collide",
    "monitors",
    "config",
    "unload",
    "hotkey",
    "nonsense",
};
constexpr std::string_view fields[]{
    "valid",
    "id",
    "kind",
    "owner",
    "x",
    "y",
    "vx",
    "vy",
    "w",
    "h",
    "state",
    "tag",
    "facing",
    "scale",
    "nonsense",
    "fling",
};
constexpr std::string_view options[]{
    "kind",
    "x",
    "y",
    "vx",
    "vy",
    "tag",
    "scale",
    "all",
    "near",
    "r",
    "loop",
    "fps",
    "nonsense",
};
constexpr std::string_view methods[]{
    "fling",
    "push",
    "stop",
    "reset",
    "move_to",
    "walk_to",
    "play",
    "say",
    "remove",
    "on",
};
constexpr std::string_view functions[]{
    "spawn",     "pets",        "pet_at",       "fling",      "reset",    "clear",
    "on",        "after",       "every",        "task",       "wait",     "wait_for",
    "now",       "arena",       "monitors",     "cursor",     "windows",  "hotkey",
    "notify",    "store.get",   "store.set",    "log.info",   "log.warn", "log.error",
    "test.case", "test.expect", "test.advance", "test.fails", "config.x", "plugin",
};
constexpr std::string_view animations[]{"'idle'", "'walk'", "'fall'", "'nonsense'"};
constexpr std::string_view keys[]{"'ctrl+alt+h'", "'f5'", "'h'", "'nonsense+x'"};

// What every program begins with: pets and subscriptions to pick from.
constexpr std::string_view prologue = R"(
local pets, subs = {}, {}
local function keep(...)
  for _, value in ipairs{ ... } do
    if type(value) == "userdata" then
      local list = pcall(function() return value.id end) and pets or subs
      list[#list + 1] = value
    end
  end
  return ...
end
local function pick() return pets[math.random(math.max(1, #pets))] end
local function sub() return subs[math.random(math.max(1, #subs))] end
for i = 1, 3 do keep(hyrax.spawn{ x = 200 * i, y = 300, vx = 50 * i }) end
)";

class Writer {
public:
    explicit Writer(std::uint64_t seed) : random_(seed) {}

    std::string program() {
        std::string text(prologue);
        for (int i = 0, count = 5 + below(20); i < count; ++i) {
            text += statement(3) + "\n";
        }
        return text;
    }

private:
    int below(int most) { return static_cast<int>(random_() % static_cast<std::uint64_t>(most)); }
    bool chance(int percent) { return below(100) < percent; }
    std::string one_of(Words words) { return std::string(words[random_() % words.size()]); }

    std::string number() {
        return chance(70) ? std::to_string(below(2'000) - 500) : one_of(numbers);
    }

    std::string table(int depth) {
        std::string text = "{ ";
        for (int i = 0, count = below(4); i < count; ++i) {
            text += one_of(options) + " = " + value(depth - 1) + ", ";
        }
        return text + "}";
    }

    std::string function(int depth) {
        return "function(...) keep(...) " + statement(depth - 1) + " " + statement(depth - 1) +
               " end";
    }

    std::string value(int depth) {
        switch (below(depth > 0 ? 12 : 9)) {
            case 0:
            case 1:
            case 2:
                return number();
            case 3:
                return one_of(texts);
            case 4:
                return "'" + one_of(events) + "'";
            case 5:
            case 6:
                return "pick()";
            case 7:
                return chance(50) ? one_of(oddities) : one_of(animations);
            case 8:
                return chance(30) ? one_of(keys) : number();
            case 9:
                return "{ near = { x = 1, y = 2, r = " + number() + " }, all = true }";
            case 10:
                return table(depth);
            default:
                return function(depth);
        }
    }

    std::string arguments(int depth) {
        std::string text;
        for (int i = 0, count = below(4); i < count; ++i) {
            text += (i > 0 ? ", " : "") + value(depth);
        }
        return text;
    }

    // One that has a chance to be right.
    std::string sensible(int depth) {
        switch (below(14)) {
            case 0:
                return "keep(hyrax.spawn{ x = " + number() + ", y = " + number() +
                       ", scale = 0.5 })";
            case 1:
                return "pick():walk_to(" + number() + ", 150)";
            case 2:
                return "pick():say(" + one_of(texts) + ", 1)";
            case 3:
                return "pick():play(" + one_of(animations) + ", { loop = true })";
            case 4:
                return "keep(hyrax.on('" + one_of(events) + "', " + function(depth) + "))";
            case 5:
                return "keep(pick():on('" + one_of(events) + "', " + function(depth) + "))";
            case 6:
                return "keep(hyrax.every(0.0" + std::to_string(1 + below(9)) + ", " +
                       function(depth) + "))";
            case 7:
                return "hyrax.task(" + function(depth) + ")";
            case 8:
                return "hyrax.wait(0." + std::to_string(below(9)) + ")";
            case 9:
                return "keep(hyrax.wait_for(pick(), '" + one_of(events) + "', 0.3))";
            case 10:
                return "hyrax.store.set('k" + std::to_string(below(5)) + "', " + table(depth) + ")";
            case 11:
                return "pick().scale = 0.25 + math.random() * 3";
            case 12:
                return "pick().facing = 'left'";
            default:
                return "pick():fling(" + number() + ", " + number() + ")";
        }
    }

    std::string call(int depth) {
        if (chance(50)) {
            return sensible(depth);
        }
        if (chance(10)) {
            return "sub():cancel()";
        }
        if (chance(10)) {
            return "pick()." + one_of(fields) + " = " + value(depth);
        }
        if (chance(10)) {
            return "local _ = pick()." + one_of(fields);
        }
        if (chance(40)) {
            return "keep(pick():" + one_of(methods) + "(" + arguments(depth) + "))";
        }
        return "keep(hyrax." + one_of(functions) + "(" + arguments(depth) + "))";
    }

    // Most errors are caught, so that the program goes on.
    std::string statement(int depth) {
        if (depth <= 0) {
            return "pcall(function() " + call(0) + " end)";
        }
        switch (below(12)) {
            case 0:
                return call(depth);
            case 1:
                return "for i = 1, " + std::to_string(1 + below(6)) + " do " +
                       statement(depth - 1) + " end";
            case 2:
                return "table.sort({ 3, 1, 2 }, function(a, b) " + statement(depth - 1) +
                       " return a < b end)";
            case 3:
                return "coroutine.wrap(function() " + statement(depth - 1) + " end)()";
            case 4:
                return "if math.random() < 0.5 then " + statement(depth - 1) + " end";
            default:
                return "pcall(function() " + call(depth) + " end)";
        }
    }

    std::mt19937_64 random_;
};

}  // namespace

std::string random_program(std::uint64_t seed) {
    return Writer(seed).program();
}

}  // namespace hyrax
