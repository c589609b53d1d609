// SPDX-License-Identifier: MIT
// What libstdc++ does when an exception is nobody's: its own handler prints the exception's name to
// a console that no tray program has, and brings 45 kB of a demangler for that.
#include <cstdlib>

namespace __gnu_cxx {

[[noreturn]] void __verbose_terminate_handler();

void __verbose_terminate_handler() {
    std::abort();
}

}  // namespace __gnu_cxx
