// SPDX-License-Identifier: MIT
// Carries out what a developer types, and describes what comes of it as people read it.
#include "daemon/script/api.h"
#include "daemon/script/sandbox.h"
#include "daemon/script/script.h"
#include "daemon/script/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax::script {
namespace {

constexpr std::int64_t units_per_byte = 10;
constexpr std::int64_t units_per_value = 10;
constexpr std::size_t longest_answer = 8'000;
constexpr std::size_t longest_string = 1'000;
constexpr std::size_t most_entries = 40;
constexpr std::size_t most_seen = 10'000;  // To walk through more would use up the budget.

std::string_view text_at(lua_State* lua, int index) {
    std::size_t length = 0;
    const char* const text = lua_tolstring(lua, index, &length);
    return {text, length};
}

std::string quoted(std::string_view text) {
    std::string quoted = "\"";
    for (const char letter : text.substr(0, longest_string)) {
        const auto byte = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            quoted += '\\';
            quoted += letter;
        } else if (letter == '\n') {
            quoted += "\\n";
        } else if (byte < 0x20U || byte == 0x7FU) {
            quoted += fmt::format("\\x{:02X}", byte);
        } else {
            quoted += letter;
        }
    }
    return quoted + (text.size() > longest_string ? "..." : "") + "\"";
}

bool is_name(std::string_view text) {
    const auto is_letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    return !text.empty() && text.size() <= longest_string && is_letter(text.front()) &&
           std::ranges::all_of(text, [&is_letter](char c) {
               return is_letter(c) || (c >= '0' && c <= '9');
           });
}

std::string described(lua_State* lua, int index, bool inside);

std::string key_of(lua_State* lua, int index) {
    if (lua_type(lua, index) == LUA_TSTRING && is_name(text_at(lua, index))) {
        return std::string(text_at(lua, index));
    }
    return "[" + described(lua, index, true) + "]";
}

// The list first, then the rest by its names.
std::string table_text(lua_State* lua, int table) {
    const auto length =
        static_cast<lua_Integer>(std::min<lua_Unsigned>(lua_rawlen(lua, table), most_entries));
    std::vector<std::string> entries;
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_rawgeti(lua, table, i);
        entries.push_back(described(lua, -1, true));
        lua_pop(lua, 1);
    }
    std::vector<std::string> named;
    bool all = lua_rawlen(lua, table) <= most_entries;
    lua_pushnil(lua);
    for (std::size_t seen = 0; lua_next(lua, table) != 0; ++seen) {
        const bool listed =
            lua_isinteger(lua, -2) != 0 && lua_tointeger(lua, -2) >= 1 &&
            static_cast<lua_Unsigned>(lua_tointeger(lua, -2)) <= lua_rawlen(lua, table);
        if (seen == most_seen || (!listed && entries.size() + named.size() >= most_entries)) {
            lua_pop(lua, 2);
            all = false;
            break;
        }
        if (!listed) {
            named.push_back(key_of(lua, -2) + " = " + described(lua, -1, true));
        }
        Script::of(lua).meter.charge(lua, units_per_value);
        lua_pop(lua, 1);
    }
    std::ranges::sort(named);
    entries.insert(entries.end(), named.begin(), named.end());
    if (!all) {
        entries.emplace_back("...");
    }
    return fmt::format("{{{}}}", fmt::join(entries, ", "));
}

// Tables within tables are only hinted at.
std::string described(lua_State* lua, int index, bool inside) {
    index = lua_absindex(lua, index);
    luaL_checkstack(lua, 8, "too many values");
    Script::of(lua).meter.charge(lua, units_per_value);
    if (lua_type(lua, index) == LUA_TSTRING) {
        return quoted(text_at(lua, index));
    }
    const int top = lua_gettop(lua);
    const bool plain_table = lua_type(lua, index) == LUA_TTABLE &&
                             luaL_getmetafield(lua, index, "__tostring") == LUA_TNIL;
    lua_settop(lua, top);
    if (plain_table && !inside) {
        return table_text(lua, index);
    }
    if (plain_table) {
        lua_pushnil(lua);
        const bool is_empty = lua_next(lua, index) == 0;
        lua_settop(lua, top);
        return is_empty ? "{}" : "{...}";
    }
    push_text(lua, index);
    std::string text = clean_text(text_at(lua, -1), longest_string);
    lua_settop(lua, top);
    return text;
}

// What stands above `base` on the stack becomes one text.
int describe_results(lua_State* lua, int /*status*/, lua_KContext base) {
    std::string text;
    const int last = lua_gettop(lua);
    for (int i = static_cast<int>(base) + 1; i <= last && text.size() < longest_answer; ++i) {
        text += (text.empty() ? "" : ", ") + described(lua, i, false);
    }
    if (text.size() > longest_answer) {
        text = clean_text(text, longest_answer);
    }
    lua_pushlstring(lua, text.data(), text.size());
    return 1;
}

// An expression, or else statements: what it says of the latter is of more use.
void compile(lua_State* lua, std::string_view text) {
    constexpr const char* name = "=eval";
    Script::of(lua).meter.charge(lua, 2 * static_cast<std::int64_t>(text.size()) * units_per_byte);
    const std::string expression = "return " + std::string(text);
    if (luaL_loadbufferx(lua, expression.data(), expression.size(), name, "t") == LUA_OK) {
        return;
    }
    lua_pop(lua, 1);
    if (luaL_loadbufferx(lua, text.data(), text.size(), name, "t") != LUA_OK) {
        lua_error(lua);
    }
}

int evaluate_text(lua_State* lua) {
    compile(lua, text_at(lua, 1));
    Script::of(lua).meter.check(lua);
    lua_callk(lua, 0, LUA_MULTRET, 1, describe_results);
    return describe_results(lua, LUA_OK, 1);
}

}  // namespace

void Script::evaluate(const Evaluation& wanted) {
    const std::size_t before = run_->output.log.size();
    evaluations_.begin(wanted.id);
    meter.begin(limits.callback_units, limits.callback_time);
    protect([this, &wanted](lua_State* lua) {
        lua_pushcfunction(lua, evaluate_text);
        lua_pushlstring(lua, wanted.text.data(), wanted.text.size());
        start(lua, 1);
    });
    std::string printed;
    for (std::size_t i = before; i < run_->output.log.size(); ++i) {
        printed += run_->output.log[i].text + "\n";
    }
    if (Evaluations::Open* const open = evaluations_.find(wanted.id)) {
        open->printed = std::move(printed);
        open->has_waited = true;
        if (open->thread == nullptr) {  // Not even its coroutine could be made.
            run_->output.evaluated.push_back({wanted.id, false, "not enough memory", {}});
            evaluations_.take(nullptr);
        }
    } else {
        run_->output.evaluated.back().printed = std::move(printed);
    }
}

// False where nobody would hear of an error: it came too late, or not from an evaluation.
bool Script::end_evaluation(lua_State* thread, int status) {
    const std::optional<Evaluations::Open> ended = evaluations_.take(thread);
    if (!ended) {
        return false;
    }
    const bool good = status == LUA_OK;
    std::string text = good ? std::string(text_at(thread, -1))
                            : clean_text(error_text(thread, status), longest_answer);
    run_->output.evaluated.push_back({ended->id, good, std::move(text), ended->printed});
    return !ended->has_waited;
}

void Script::give_up_evaluations(const std::string& problem) {
    for (Evaluations::Open& each : evaluations_.take_all()) {
        run_->output.evaluated.push_back({each.id, false, problem, std::move(each.printed)});
    }
}

}  // namespace hyrax::script
