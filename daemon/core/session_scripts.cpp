// SPDX-License-Identifier: MIT
#include "daemon/core/session_scripts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hyrax {
namespace {

std::string whole_name(std::string_view name) {
    return name.starts_with(SessionScripts::prefix)
               ? std::string(name)
               : fmt::format("{}{}", SessionScripts::prefix, name);
}

}  // namespace

Result<std::string> SessionScripts::put(std::string_view name, std::string text) {
    const std::string script = whole_name(name);
    const std::size_t length = script.size() - prefix.size();
    const bool plain = std::ranges::all_of(script, [](char letter) {
        return static_cast<unsigned char>(letter) >= 0x20 && letter != 0x7F;
    });
    if (length == 0 || length > longest_name || !plain) {
        return failure(fmt::format("a script's name must have 1 to {} bytes", longest_name));
    }
    const auto found = std::ranges::find(scripts_, script, &ScriptSource::name);
    if (found != scripts_.end()) {
        found->text = std::move(text);
    } else if (scripts_.size() == most) {
        return failure(fmt::format("{} scripts have been run already: run --stop ends one", most));
    } else {
        scripts_.push_back({
            .name = script,
            .text = std::move(text),
            .permissions = {script_permissions.begin(), script_permissions.end()},
        });
    }
    restart(script);
    return script;
}

bool SessionScripts::remove(std::string_view name) {
    const std::string script = whole_name(name);
    return std::erase_if(scripts_, [&](const ScriptSource& s) { return s.name == script; }) > 0;
}

void SessionScripts::adjust(std::vector<ScriptSource>& sources, bool with_own) const {
    if (with_own) {
        sources.insert(sources.end(), scripts_.begin(), scripts_.end());
    }
    for (ScriptSource& source : sources) {
        if (const auto turn = turns_.find(source.name); turn != turns_.end()) {
            source.turn = turn->second;
        }
    }
}

}  // namespace hyrax
