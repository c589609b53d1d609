// SPDX-License-Identifier: MIT
// Words to whoever started the program from a command line.
#pragma once

#include <string_view>

namespace hyrax::win32 {

/// Writes UTF-8 text to standard output if there is one, else to the console of the parent
/// process, else into a message box: a program of the GUI subsystem has no console of its own.
void say(std::string_view text);

}  // namespace hyrax::win32
