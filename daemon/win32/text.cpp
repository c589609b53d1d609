// SPDX-License-Identifier: MIT
#include "daemon/win32/text.h"

#include "daemon/win32/handle.h"

#include <shellapi.h>

namespace hyrax::win32 {

std::wstring wide(std::string_view utf8_text) {
    const int bytes = static_cast<int>(utf8_text.size());
    const int units = ::MultiByteToWideChar(CP_UTF8, 0, utf8_text.data(), bytes, nullptr, 0);
    std::wstring text(static_cast<std::size_t>(units), L'\0');
    ::MultiByteToWideChar(CP_UTF8, 0, utf8_text.data(), bytes, text.data(), units);
    return text;
}

std::string utf8(std::wstring_view wide_text) {
    const int units = static_cast<int>(wide_text.size());
    const int bytes =
        ::WideCharToMultiByte(CP_UTF8, 0, wide_text.data(), units, nullptr, 0, nullptr, nullptr);
    std::string text(static_cast<std::size_t>(bytes), '\0');
    ::WideCharToMultiByte(
        CP_UTF8, 0, wide_text.data(), units, text.data(), bytes, nullptr, nullptr
    );
    return text;
}

Error system_error(std::string_view what, DWORD code) {
    wchar_t buffer[512];
    constexpr DWORD flags = FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS;
    const DWORD length = ::FormatMessageW(
        flags, nullptr, code, 0, buffer, static_cast<DWORD>(std::size(buffer)), nullptr
    );
    std::wstring_view reason(buffer, length);
    while (!reason.empty() && (reason.back() <= L' ' || reason.back() == L'.')) {
        reason.remove_suffix(1);
    }
    const std::string number = "error " + std::to_string(code);
    std::string message(what);
    message += reason.empty() ? ": " + number : ": " + utf8(reason) + " (" + number + ")";
    return {message};
}

std::vector<std::string> command_line_arguments() {
    int count = 0;
    wchar_t** const words = ::CommandLineToArgvW(::GetCommandLineW(), &count);
    const LocalMemory owner(words);
    std::vector<std::string> arguments;
    for (int i = 1; words != nullptr && i < count; ++i) {
        arguments.push_back(utf8(words[i]));
    }
    return arguments;
}

std::wstring_view shortened(std::wstring_view text, std::size_t most) {
    if (text.size() <= most) {
        return text;
    }
    const bool splits_pair = most > 0 && IS_HIGH_SURROGATE(text[most - 1]);
    return text.substr(0, splits_pair ? most - 1 : most);
}

}  // namespace hyrax::win32
