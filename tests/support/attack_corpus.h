// SPDX-License-Identifier: MIT
// The hostile scripts of tests/script/attacks. Each says in its first line how it must end.
#pragma once

#include "daemon/core/files.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

struct Attack {
    enum class End { ok, error, kill };

    std::string name;  ///< "01_busy_loop.lua"
    std::string text;
    End end = End::ok;
    std::string part{};  ///< Of the error's message.
};

/// "-- MUST: error:not enough memory | why"
inline Attack attack_from(const std::filesystem::path& file) {
    Attack attack{
        .name = file.filename().string(), .text = read_text_file(file, 1U << 20U).value()
    };
    std::string_view line = std::string_view(attack.text).substr(0, attack.text.find('\n'));
    line.remove_prefix(std::string_view("-- MUST: ").size());
    line = line.substr(0, line.find(" |"));
    if (line == "kill") {
        attack.end = Attack::End::kill;
    } else if (line.starts_with("error:")) {
        attack.end = Attack::End::error;
        attack.part = line.substr(6);
        attack.part.erase(0, attack.part.find_first_not_of(' '));
    }
    return attack;
}

inline std::vector<Attack> attacks() {
    std::vector<Attack> list;
    const std::filesystem::path folder = HYRAX_SOURCE_DIR "/tests/script/attacks";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".lua") {
            list.push_back(attack_from(entry.path()));
        }
    }
    std::ranges::sort(list, {}, &Attack::name);
    return list;
}

/// True once the errors that name the script, one a line, tell that it ended as it must.
inline bool ended_as_it_must(const Attack& attack, std::string_view errors) {
    const bool stopped = errors.contains("stopped until it is loaded again");
    switch (attack.end) {
        case Attack::End::ok:
            return errors.empty();
        case Attack::End::error:
            return !stopped && errors.starts_with(attack.name) && errors.contains(attack.part);
        case Attack::End::kill:
            return stopped && errors.starts_with(attack.name);
    }
    return false;
}

}  // namespace hyrax
