// SPDX-License-Identifier: MIT
// A PNG file that says how large it is, and holds nothing.
#pragma once

#include <string>

namespace hyrax {

/// The first 24 bytes: all that is read before decoding.
inline std::string png_header(unsigned width, unsigned height) {
    std::string header("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16);
    for (const unsigned number : {width, height}) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            header += static_cast<char>(number >> static_cast<unsigned>(shift) & 0xFFU);
        }
    }
    return header;
}

}  // namespace hyrax
