// SPDX-License-Identifier: MIT
#include "daemon/script/meter.h"

#include "daemon/script/script.h"

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <utility>

namespace hyrax::script {
namespace {

// Copying 16 bytes costs about as much as an instruction, fresh pages included.
constexpr std::size_t bytes_per_unit = 16;
// A refusal makes Lua run a full collection: about 10 ms for 16 MiB.
constexpr std::int64_t refusal_units = 2'000;
constexpr std::size_t heap_bytes_per_refusal_unit = 32;
// What a killed script may still need on its way out.
constexpr std::size_t overdraft = std::size_t{64} << 10U;
// Header and final zero of a string.
constexpr std::size_t string_overhead = 64;

}  // namespace

void Meter::begin(std::int64_t units, std::chrono::nanoseconds time) {
    if (limits_.pulse != nullptr) {
        limits_.pulse->call();
    }
    used_ = used();
    budget_ = units;
    units_ = units;
    time_ = time;
    half_time_.reset();
    deadline_ = std::chrono::steady_clock::now() + time / 2;
}

std::chrono::nanoseconds Meter::processor_time() const {
    if (limits_.processor_time != nullptr) {
        return limits_.processor_time();
    }
    return std::chrono::nanoseconds(std::clock() * (std::nano::den / CLOCKS_PER_SEC));
}

std::string Meter::budget_spent() const {
    return fmt::format("used more than {} work units in one call (an endless loop?)", budget_);
}

void Meter::condemn(lua_State* lua, std::string reason) {
    if (!killed_) {
        killed_ = true;
        verdict_ = {std::move(reason), call_trace(lua, 0)};
    }
}

// A light error object: raising it needs no memory. The hook on every instruction keeps __close
// handlers from running on the way out.
void Meter::stop(lua_State* lua) {
    condemn(lua);
    lua_sethook(lua, on_count, LUA_MASKCOUNT, 1);
    lua_pushlightuserdata(lua, this);
    lua_error(lua);
    std::unreachable();
}

void Meter::on_count(lua_State* lua, lua_Debug* /*call*/) {
    Meter& meter = Script::of(lua).meter;
    if (meter.limits_.pulse != nullptr) {
        meter.limits_.pulse->beat();
    }
    meter.charge(lua, period);
    meter.look_at_clock(lua);
}

// The wall is cheap to read, but a machine that slept or was busy with others is no fault of the
// script: for the second half of the time only its own time counts. The first half needs no look at
// the processor's clock, a system call that would cost as much as a short handler.
void Meter::look_at_clock(lua_State* lua) {
    const auto now = std::chrono::steady_clock::now();
    if (now < deadline_) {
        return;
    }
    const auto spent_time = processor_time();
    const auto used = spent_time - half_time_.value_or(spent_time);
    if (!half_time_ || used < time_ / 2) {
        half_time_ = half_time_.value_or(spent_time);
        deadline_ = now + (time_ / 2 - used);
        return;
    }
    condemn(
        lua,
        fmt::format(
            "used more than {} ms of processor time in one call",
            std::chrono::duration_cast<std::chrono::milliseconds>(time_).count()
        )
    );
    stop(lua);
}

void Meter::watch(lua_State* lua) {
    lua_sethook(lua, on_count, LUA_MASKCOUNT, period);
}

bool Meter::refuses(bool is_new, std::size_t kind, std::size_t old_size, std::size_t new_size) {
    const std::size_t cap = limits_.memory + (killed_ ? overdraft : 0);
    const bool long_string =
        is_new && kind == LUA_TSTRING && new_size > limits_.string + string_overhead;
    const bool full = new_size - old_size > cap || heap_ > cap - (new_size - old_size);
    const bool broke = units_ <= 0 && !killed_;
    if (long_string || full) {
        units_ -= refusal_units + static_cast<std::int64_t>(heap_ / heap_bytes_per_refusal_unit);
    }
    return long_string || full || broke;
}

// For a new block, Lua passes its type instead of its old size. Only growth may fail.
void* Meter::allocate(void* meter, void* block, std::size_t old_size, std::size_t new_size) {
    Meter& self = *static_cast<Meter*>(meter);
    const std::size_t kind = old_size;
    const std::size_t before = block == nullptr ? 0 : old_size;
    if (new_size == 0) {
        std::free(block);
        self.heap_ -= before;
        return nullptr;
    }
    const bool grows = new_size > before;
    if (grows && self.refuses(block == nullptr, kind, before, new_size)) {
        return nullptr;
    }
    void* const moved = std::realloc(block, new_size);
    if (moved == nullptr) {
        return grows ? nullptr : block;
    }
    if (grows) {
        self.units_ -= static_cast<std::int64_t>((new_size - before) / bytes_per_unit);
        if (self.limits_.pulse != nullptr) {
            self.limits_.pulse->beat();  // The cap and the units see to it that growth ends.
        }
    }
    self.heap_ = self.heap_ - before + new_size;
    return moved;
}

}  // namespace hyrax::script
