// SPDX-License-Identifier: MIT
#include "daemon/core/file_name.h"

#include "daemon/core/ascii.h"

#include <algorithm>
#include <array>
#include <string>

namespace hyrax {

bool names_device(std::string_view file_name) {
    std::string name;
    for (const char letter : file_name.substr(0, file_name.find('.'))) {
        name += lower_ascii(letter);
    }
    // Blanks before the dot do not count either.
    name.erase(name.find_last_not_of(' ') + 1);
    constexpr std::array<std::string_view, 4> devices{"con", "prn", "aux", "nul"};
    const bool numbered = name.size() == 4 &&
                          (name.starts_with("com") || name.starts_with("lpt")) && name[3] >= '0' &&
                          name[3] <= '9';
    return numbered || std::ranges::find(devices, name) != devices.end();
}

}  // namespace hyrax
