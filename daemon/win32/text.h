// SPDX-License-Identifier: MIT
// Text for the system (UTF-16) and for the rest of the program (UTF-8), and messages of errors.
#pragma once

#include "daemon/core/result.h"

#include <windows.h>

#include <string>
#include <string_view>
#include <vector>

namespace hyrax::win32 {

/// What is not valid becomes U+FFFD.
std::wstring wide(std::string_view utf8);
std::string utf8(std::wstring_view wide_text);

/// "<what>: <the system's message> (error <number>)"
Error system_error(std::string_view what, DWORD code = ::GetLastError());

/// The arguments of this process, the program's name left out.
std::vector<std::string> command_line_arguments();

/// Cuts to what fits into a fixed field, never inside a surrogate pair.
std::wstring_view shortened(std::wstring_view text, std::size_t most);

}  // namespace hyrax::win32
