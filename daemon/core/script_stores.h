// SPDX-License-Identifier: MIT
// What scripts keep from one start to the next: one file for each of them.
#pragma once

#include "daemon/core/result.h"
#include "daemon/core/script_value.h"
#include "physics/ticks.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace hyrax {

class ScriptStores {
public:
    /// Files are <folder>/<name>.json. Without a folder nothing lasts longer than this object.
    explicit ScriptStores(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// What the script has kept. A file that cannot be read is told in the log and moved aside.
    const ScriptTable& of(const std::string& script);
    void set(const std::string& script, const std::string& key, ScriptValue value, Ticks now);

    /// When there is something to write: at most once a second.
    Ticks next_write() const { return due_; }
    /// Writes what has changed, if it is due.
    void write_due(Ticks now);
    /// Writes what has changed, now.
    void write_all();

private:
    struct Store {
        ScriptTable table;
        bool changed = false;
    };

    Store& store_of(const std::string& script);

    std::filesystem::path folder_;
    std::map<std::string, Store> stores_;
    Ticks due_ = never;
    Ticks not_before_ = 0;
};

/// The name of a script's file, without a folder: letters, digits, '.', '_' and '-' as they are,
/// other bytes as %XX, and never the name of a device.
std::string store_file_name(std::string_view script);

/// As text and back. Whole numbers stay whole.
std::string json_of(const ScriptTable& table);
/// `file` names it in messages.
[[nodiscard]] Result<ScriptTable> parse_store(std::string_view text, std::string_view file);

}  // namespace hyrax
