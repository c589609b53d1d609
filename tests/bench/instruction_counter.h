// SPDX-License-Identifier: MIT
// How many instructions a piece of work takes: from the processor's counters, or where they are out
// of reach, as in most virtual machines, from a second run of this program inside valgrind.
#pragma once

#include <functional>

namespace hyrax::bench {

using Work = std::function<void()>;

/// Runs the work once and says its instructions; empty where nothing can count them.
using InstructionCounter = std::function<double(const Work&)>;

/// The processor's counter of instructions in user space. Linux only; perf_event_paranoid <= 2.
InstructionCounter hardware_counter();

/// Runs this program with the same arguments inside `valgrind --tool=callgrind` first, and then
/// gives the counts of that run in turn: both runs must measure the same work in the same order.
InstructionCounter valgrind_counter(int argc, const char* const* argv);

/// What the program adds to its own arguments inside valgrind.
inline constexpr const char* inside_valgrind_flag = "--inside-valgrind";

/// For the run inside valgrind, which sees what one function does; its figure is 0.
InstructionCounter counted_by_valgrind();

}  // namespace hyrax::bench
