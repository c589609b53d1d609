// SPDX-License-Identifier: MIT
#include "daemon/core/script_stores.h"

#include "daemon/core/file_name.h"
#include "daemon/core/files.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace hyrax {
namespace {

// A store of 256 KiB, escaped and indented at its worst.
constexpr std::size_t most_bytes = std::size_t{4} << 20U;

bool is_plain(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') || letter == '.' || letter == '_' || letter == '-';
}

}  // namespace

std::string store_file_name(std::string_view script) {
    const bool device = names_device(script);
    std::string name;
    for (const char letter : script) {
        const bool first = name.empty();
        if (is_plain(letter) && !(first && (device || letter == '.'))) {
            name += letter;
        } else {
            name += fmt::format("%{:02X}", static_cast<unsigned char>(letter));
        }
    }
    return name + ".json";
}

const ScriptTable& ScriptStores::of(const std::string& script) {
    return store_of(script).table;
}

ScriptStores::Store& ScriptStores::store_of(const std::string& script) {
    const auto [place, is_new] = stores_.try_emplace(script);
    Store& store = place->second;
    if (!is_new || folder_.empty()) {
        return store;
    }
    const std::filesystem::path path = folder_ / store_file_name(script);
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        return store;
    }
    const Result<std::string> text = read_text_file(path, most_bytes);
    Result<ScriptTable> table =
        text ? parse_store(*text, utf8_from_path(path.filename())) : std::unexpected(text.error());
    if (table) {
        store.table = *std::move(table);
        return store;
    }
    std::filesystem::path aside = path;
    aside += ".broken";
    std::filesystem::rename(path, aside, error);
    spdlog::error(
        "{}; the script begins with an empty store, the file is now {}",
        table.error().message,
        utf8_from_path(aside.filename())
    );
    return store;
}

void ScriptStores::set(
    const std::string& script, const std::string& key, ScriptValue value, Ticks now
) {
    Store& store = store_of(script);
    set_field(store.table, key, std::move(value));
    store.changed = true;
    if (due_ == never && !folder_.empty()) {
        due_ = std::max(now, not_before_);
    }
}

void ScriptStores::write_due(Ticks now) {
    if (now >= due_) {
        write_all();
        not_before_ = now + ticks_per_second;
    }
}

void ScriptStores::write_all() {
    due_ = never;
    for (auto& [script, store] : stores_) {
        if (!std::exchange(store.changed, false) || folder_.empty()) {
            continue;
        }
        std::error_code error;
        std::filesystem::create_directories(folder_, error);
        const auto written =
            write_file_atomically(folder_ / store_file_name(script), json_of(store.table));
        if (!written) {
            spdlog::error("{}: the store of {} is not kept", written.error().message, script);
        }
    }
}

}  // namespace hyrax
