// SPDX-License-Identifier: MIT
#include "daemon/script/call_trace.h"

#include <fmt/format.h>
#include <lua.h>

#include <string_view>

namespace hyrax::script {
namespace {

// Enough to see who called whom; a deep recursion shows its two ends.
constexpr int first_frames = 8;
constexpr int last_frames = 4;

std::string function_name(const lua_Debug& call) {
    if (call.name != nullptr) {
        return fmt::format("in {} '{}'", call.namewhat, call.name);
    }
    if (std::string_view(call.what) == "main") {
        return "in main chunk";
    }
    if (std::string_view(call.what) == "C") {
        return "in a library function";
    }
    return fmt::format("in function <{}:{}>", call.short_src, call.linedefined);
}

// Lua walks from the innermost call to the one asked for, and recursions have 200 000 of them:
// looks at few.
int depth_of(lua_State* lua, int level) {
    const auto exists = [lua, level](int depth) {
        lua_Debug call{};
        return lua_getstack(lua, level + depth, &call) != 0;
    };
    int below = 0;
    int above = 1;
    while (exists(above - 1)) {
        below = above;
        above *= 2;
    }
    while (below + 1 < above) {
        const int middle = below + (above - below) / 2;
        (exists(middle - 1) ? below : above) = middle;
    }
    return below;
}

}  // namespace

CallTrace call_trace(lua_State* lua, int level) {
    CallTrace trace;
    const int depth = depth_of(lua, level);
    for (int i = 0; i < depth; ++i) {
        if (i == first_frames && depth > first_frames + last_frames) {
            const int skipped = depth - first_frames - last_frames;
            trace.frames.push_back(fmt::format("... ({} more calls)", skipped));
            i += skipped;
        }
        lua_Debug call{};
        lua_getstack(lua, level + i, &call);
        lua_getinfo(lua, "Sln", &call);
        std::string place;
        if (call.currentline > 0) {
            place = fmt::format("{}:{}", call.short_src, call.currentline);
            if (trace.where.empty()) {
                trace.where = place;
            }
            place += ": ";
        }
        trace.frames.push_back(place + function_name(call));
    }
    return trace;
}

}  // namespace hyrax::script
