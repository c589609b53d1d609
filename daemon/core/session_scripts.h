// SPDX-License-Identifier: MIT
// What developers do with scripts while the daemon runs: scripts of their own that are in no
// folder, and fresh starts of those that are.
#pragma once

#include "daemon/core/result.h"
#include "daemon/core/script_port.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

class SessionScripts {
public:
    /// In front of their names, so that they are not taken for files.
    static constexpr std::string_view prefix = "run:";
    static constexpr std::size_t most = 16;
    static constexpr std::size_t longest_name = 64;  ///< Without the prefix [bytes].

    /// The script's whole name. It starts anew if it runs already. Fails for a name that is none,
    /// or if there are too many.
    [[nodiscard]] Result<std::string> put(std::string_view name, std::string text);
    /// False if there is none of this name, with the prefix or without.
    bool remove(std::string_view name);
    /// The script of this name starts anew with the next adjust().
    void restart(const std::string& script) { turns_[script] = ++last_turn_; }
    const std::vector<ScriptSource>& all() const { return scripts_; }

    /// Has those start anew that are to, and adds the session's own if `with_own`.
    void adjust(std::vector<ScriptSource>& sources, bool with_own) const;

private:
    std::vector<ScriptSource> scripts_;
    std::map<std::string, std::uint64_t> turns_;  // By name.
    std::uint64_t last_turn_ = 0;
};

}  // namespace hyrax
