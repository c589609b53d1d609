// SPDX-License-Identifier: MIT
// Runs CLI11's parser without its exceptions.
#pragma once

#include "daemon/control/command_line.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace hyrax {

/// An answer means that the program has only to print it and to end.
inline std::optional<Farewell> parse(CLI::App& app, std::vector<std::string> arguments) {
    // CLI11 takes the arguments in reverse order.
    std::ranges::reverse(arguments);
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::ParseError& error) {
        std::ostringstream out;
        std::ostringstream err;
        const int code = app.exit(error, out, err);
        return Farewell{out.str() + err.str(), code == 0 ? 0 : 2};
    }
    return std::nullopt;
}

}  // namespace hyrax
