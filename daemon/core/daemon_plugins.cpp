// SPDX-License-Identifier: MIT
// Which plugins run, and what the user decides about them.
#include "daemon/core/daemon.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <set>
#include <utility>

namespace hyrax {
namespace {

std::set<std::string> running(const std::vector<PluginEntry>& plugins) {
    std::set<std::string> ids;
    for (const PluginEntry& entry : plugins) {
        if (entry.state == PluginState::on) {
            ids.insert(entry.id);
        }
    }
    return ids;
}

}  // namespace

void Daemon::read_plugins() {
    std::vector<std::string> warnings;
    std::vector<PluginEntry> found = find_plugins(profile_, plugins_, warnings);
    for (const std::string& warning : warnings) {
        spdlog::warn("{}", warning);
    }
    judge(found, config_.plugins, remembered_);
    const std::set<std::string> before = running(plugins_);
    plugins_ = std::move(found);
    const std::set<std::string> now = running(plugins_);
    for (const std::string& id : before) {
        if (!now.contains(id)) {
            scripts_.retire(engine_, id);
            // Whatever comes before the next load, that differs: its pets may come again.
            std::erase_if(sources_, [&id](const ScriptSource& source) {
                return source.name == id;
            });
        }
    }
}

std::vector<ScriptSource> Daemon::plugin_sources() {
    std::vector<std::string> problems = problems_of(plugins_, config_.plugins);
    std::vector<ScriptSource> sources;
    for (const PluginEntry& entry : plugins_) {
        if (entry.state == PluginState::on) {
            const auto choice = config_.plugins.find(entry.id);
            sources.push_back(source_of(
                *entry.plugin,
                choice == config_.plugins.end() ? PluginChoice{} : choice->second,
                problems
            ));
        }
    }
    tell_of_plugins(std::move(problems));
    return sources;
}

void Daemon::tell_of_plugins(std::vector<std::string> problems) {
    if (problems != plugin_problems_) {
        for (const std::string& problem : problems) {
            spdlog::error("{}", problem);
        }
        plugin_problems_ = std::move(problems);
    }
    std::string asking = asking_text(plugins_);
    if (asking != plugins_ask_ && !asking.empty()) {
        spdlog::warn("{}", asking);
    }
    plugins_ask_ = std::move(asking);
}

const PluginEntry* Daemon::plugin(const std::string& id) const {
    const auto found = std::ranges::find(plugins_, id, &PluginEntry::id);
    if (found == plugins_.end()) {
        spdlog::warn("there is no plugin \"{}\" (any more)", id);
        return nullptr;
    }
    return &*found;
}

void Daemon::carry_out(const request::SetPlugin& wish) {
    if (plugin(wish.plugin) != nullptr) {
        remembered_.plugins[wish.plugin] = wish.on;
        remember();
        read_scripts();
    }
}

// Who is allowed is wanted, and who is not is not asked about again.
void Daemon::carry_out(const request::AllowPlugin& wish) {
    const PluginEntry* const entry = plugin(wish.plugin);
    if (entry == nullptr) {
        return;
    }
    if (wish.allowed && entry->plugin) {
        remembered_.granted[wish.plugin] = entry->plugin->permissions;
    } else {
        remembered_.granted.erase(wish.plugin);
    }
    carry_out(request::SetPlugin{wish.plugin, wish.allowed});
}

// Who had to be killed again and again is off at the next start, too.
void Daemon::turn_off_given_up() {
    for (const std::string& name : scripts_.take_given_up()) {
        if (std::ranges::count(plugins_, name, &PluginEntry::id) != 0) {
            carry_out(request::SetPlugin{name, false});
        }
    }
}

}  // namespace hyrax
