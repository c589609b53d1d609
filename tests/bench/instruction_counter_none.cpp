// SPDX-License-Identifier: MIT
#include "tests/bench/instruction_counter.h"

namespace hyrax::bench {

InstructionCounter hardware_counter() {
    return {};
}

InstructionCounter valgrind_counter(int, const char* const*) {
    return {};
}

InstructionCounter counted_by_valgrind() {
    return {};
}

}  // namespace hyrax::bench
