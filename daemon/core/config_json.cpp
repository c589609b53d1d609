// SPDX-License-Identifier: MIT
// Reads config.json by the table of its keys.
#include "daemon/core/checked_json.h"
#include "daemon/core/config.h"
#include "daemon/core/config_fields.h"
#include "daemon/core/files.h"
#include "daemon/core/script_value_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <variant>

namespace hyrax {
namespace {

using nlohmann::json;

constexpr std::size_t max_file_bytes = 1U << 20U;

template <typename Target>
void read_members(
    const JsonValue& object,
    const std::string& prefix,
    std::span<const Field<Target>> fields,
    Target& target
);

std::optional<StartPets> read_start_item(const JsonValue& value) {
    StartItem item;
    read_members<StartItem>(value, "", start_table(), item);
    const std::optional<JsonValue> x = value.member("x");
    const std::optional<JsonValue> y = value.member("y");
    if (x.has_value() != y.has_value()) {
        (x ? x : y)->error_at_key("x and y are only allowed together");
    }
    if (item.x && item.y) {
        item.pets.at = Vec2{*item.x, *item.y};
    }
    return item.pets;
}

std::optional<FullScreenRule> read_full_screen_rule(const JsonValue& value) {
    FullScreenRule rule;
    read_members<FullScreenRule>(value, "", full_screen_rule_table(), rule);
    if (value.located().value.is_object() && !value.required("exe")) {
        return std::nullopt;
    }
    return rule;
}

// What the settings must be, their plugin knows.
void read_plugins(const JsonValue& value, std::map<std::string, PluginChoice>& plugins) {
    if (!value.is_object()) {
        return;
    }
    for (const JsonValue& each : value.children()) {
        if (!each.is_object()) {
            continue;
        }
        PluginChoice& choice = plugins[each.located().key];
        for (const JsonValue& member : each.children()) {
            const LocatedJson& located = member.located();
            if (located.key == "enabled") {
                choice.enabled = member.flag();
                continue;
            }
            choice.settings.push_back(
                {.key = located.key,
                 .value = script_value_from(located.value),
                 .place = member.place(),
                 .found = member.found()}
            );
        }
    }
}

std::optional<MonitorName> read_monitor_name(const JsonValue& value) {
    const json& raw = value.located().value;
    if (raw.is_string() && !raw.get_ref<const std::string&>().empty()) {
        return MonitorName{raw.get<std::string>()};
    }
    if (raw.is_string() || !raw.is_number()) {
        value.expected("must be the number or the name of a monitor");
        return std::nullopt;
    }
    const std::optional<int> number = value.whole_number(1, 100);
    return number ? std::optional(MonitorName{std::to_string(*number)}) : std::nullopt;
}

std::optional<Rect> read_area(const JsonValue& value) {
    const auto items = value.items(0, 4);
    if (!items || items->empty()) {
        return std::nullopt;
    }
    if (items->size() != 4) {
        value.expected("must be [x, y, width, height] or []");
        return std::nullopt;
    }
    constexpr int most = 1'000'000;
    std::array<int, 4> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::optional<int> number = (*items)[i].whole_number(i < 2 ? -most : 1, most);
        if (!number) {
            return std::nullopt;
        }
        numbers[i] = *number;
    }
    return Rect{numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::optional<KeyCombination> read_keys(const JsonValue& value) {
    constexpr const char* rule = "must be keys such as \"ctrl+alt+g\" or \"\"";
    const json& raw = value.located().value;
    if (!raw.is_string()) {
        value.expected(rule);
        return std::nullopt;
    }
    const std::string& text = raw.get_ref<const std::string&>();
    if (text.empty()) {
        return std::nullopt;
    }
    const Result<KeyCombination> keys = parse_keys(text);
    if (!keys) {
        value.expected(fmt::format("{} ({})", rule, keys.error().message));
        return std::nullopt;
    }
    return *keys;
}

// A value that does not pass leaves the slot as it was, and an error.
template <typename Info>
struct SlotReader {
    const JsonValue& value;
    const Info& field;

    template <typename T>
    static void assign(T& slot, const auto& read) {
        if (read) {
            slot = static_cast<T>(*read);
        }
    }

    void operator()(Ignored) const {}
    void operator()(double* slot) const {
        assign(*slot, value.number(field.range.low, field.range.high));
    }
    void operator()(bool* slot) const { assign(*slot, value.flag()); }
    void operator()(std::optional<double>* slot) const {
        *slot = value.number(field.range.low, field.range.high);
    }
    void operator()(int* slot) const { assign(*slot, whole()); }
    void operator()(std::size_t* slot) const { assign(*slot, whole()); }
    void operator()(std::int64_t* slot) const { assign(*slot, whole()); }
    void operator()(std::string* slot) const {
        assign(*slot, field.choices.empty() ? value.name() : value.choice(field.choices));
    }
    void operator()(Choice slot) const {
        if (const std::optional<std::string> name = value.choice(field.choices)) {
            const auto found = std::ranges::find(field.choices, *name);
            slot.set(static_cast<std::size_t>(found - field.choices.begin()));
        }
    }
    void operator()(std::vector<std::string>* slot) const {
        fill(*slot, [](const JsonValue& item) { return item.path_pattern(); });
    }
    void operator()(std::vector<MonitorName>* slot) const { fill(*slot, read_monitor_name); }
    void operator()(std::optional<Rect>* slot) const { *slot = read_area(value); }
    void operator()(std::optional<KeyCombination>* slot) const { *slot = read_keys(value); }
    void operator()(std::vector<StartPets>* slot) const { fill(*slot, read_start_item); }
    void operator()(std::vector<FullScreenRule>* slot) const { fill(*slot, read_full_screen_rule); }
    void operator()(std::map<std::string, PluginChoice>* slot) const { read_plugins(value, *slot); }

private:
    std::optional<int> whole() const {
        return value.whole_number(
            static_cast<int>(field.range.low), static_cast<int>(field.range.high)
        );
    }

    template <typename T>
    void fill(std::vector<T>& slot, auto read) const {
        const auto items = value.items(
            static_cast<std::size_t>(field.range.low), static_cast<std::size_t>(field.range.high)
        );
        slot.clear();
        for (const JsonValue& item : items.value_or(std::vector<JsonValue>{})) {
            if (std::optional<T> each = read(item)) {
                slot.push_back(std::move(*each));
            }
        }
    }
};

// The keys right below a place in the table.
template <typename Target>
std::vector<std::string_view> keys_below(
    std::string_view prefix, std::span<const Field<Target>> fields
) {
    std::vector<std::string_view> keys;
    for (const Field<Target>& field : fields) {
        std::string_view path = field.path;
        if (path.starts_with(prefix) && path.substr(prefix.size()).starts_with('/')) {
            path.remove_prefix(prefix.size() + 1);
            keys.push_back(path.substr(0, path.find('/')));
        }
    }
    return keys;
}

template <typename Target>
void read_members(
    const JsonValue& object,
    const std::string& prefix,
    std::span<const Field<Target>> fields,
    Target& target
) {
    if (!object.is_object()) {
        return;
    }
    const std::vector<std::string_view> known = keys_below(prefix, fields);
    for (const JsonValue& member : object.children()) {
        const std::string& key = member.located().key;
        if (std::ranges::count(known, key) == 0) {
            member.warn_of_unknown_key(known);
            continue;
        }
        const std::string path = prefix + "/" + key;
        const auto field = std::ranges::find(fields, path, &Field<Target>::path);
        if (field == fields.end()) {
            read_members(member, path, fields, target);
        } else {
            std::visit(SlotReader<Field<Target>>{member, *field}, field->slot(target));
        }
    }
}

struct SlotType {
    std::string_view operator()(Ignored) const { return "string"; }
    std::string_view operator()(const bool*) const { return "boolean"; }
    std::string_view operator()(const double*) const { return "number"; }
    std::string_view operator()(const std::optional<double>*) const { return "number"; }
    std::string_view operator()(const int*) const { return "integer"; }
    std::string_view operator()(const std::size_t*) const { return "integer"; }
    std::string_view operator()(const std::int64_t*) const { return "integer"; }
    std::string_view operator()(const std::string*) const { return "string"; }
    std::string_view operator()(const Choice&) const { return "string"; }
    std::string_view operator()(const std::vector<std::string>*) const { return "array"; }
    std::string_view operator()(const std::vector<MonitorName>*) const { return "array"; }
    std::string_view operator()(const std::optional<Rect>*) const { return "array"; }
    std::string_view operator()(const std::optional<KeyCombination>*) const { return "string"; }
    std::string_view operator()(const std::vector<StartPets>*) const { return "array"; }
    std::string_view operator()(const std::vector<FullScreenRule>*) const { return "array"; }
    std::string_view operator()(const std::map<std::string, PluginChoice>*) const {
        return "object";
    }
};

struct SlotDefault {
    std::span<const std::string_view> choices;

    std::string operator()(Ignored) const { return {}; }
    std::string operator()(const std::optional<double>*) const { return {}; }
    std::string operator()(const Choice& slot) const { return json(choices[slot.index()]).dump(); }
    std::string operator()(const std::vector<FullScreenRule>* slot) const {
        json list = json::array();
        for (const FullScreenRule& rule : *slot) {
            const auto act = static_cast<std::size_t>(rule.act);
            list.push_back({{"exe", rule.program}, {"do", full_screen_names[act]}});
        }
        return list.dump();
    }
    std::string operator()(const std::vector<MonitorName>* slot) const {
        json list = json::array();
        for (const MonitorName& monitor : *slot) {
            list.push_back(monitor.text);
        }
        return list.dump();
    }
    std::string operator()(const std::optional<Rect>* slot) const {
        const std::optional<Rect>& area = *slot;
        return area ? json{area->x, area->y, area->width, area->height}.dump() : "[]";
    }
    std::string operator()(const std::optional<KeyCombination>* slot) const {
        return json(*slot ? text_of(**slot) : "").dump();
    }
    std::string operator()(const std::vector<StartPets>* slot) const {
        json list = json::array();
        for (const StartPets& pets : *slot) {
            json item{{"kind", pets.kind}, {"count", pets.count}};
            if (pets.at) {
                item.update({{"x", pets.at->x}, {"y", pets.at->y}});
            }
            if (pets.velocity != Vec2{}) {
                item.update({{"vx", pets.velocity.x}, {"vy", pets.velocity.y}});
            }
            list.push_back(std::move(item));
        }
        return list.dump();
    }
    // Their settings have defaults in their manifests.
    std::string operator()(const std::map<std::string, PluginChoice>* slot) const {
        json object = json::object();
        for (const auto& [id, choice] : *slot) {
            object[id] = json::object();
            if (choice.enabled) {
                object[id]["enabled"] = *choice.enabled;
            }
            for (const GivenSetting& given : choice.settings) {
                object[id][given.key] = json_from(given.value);
            }
        }
        return object.dump();
    }
    std::string operator()(const auto* slot) const { return json(*slot).dump(); }
};

template <typename Target>
void describe(
    std::string_view prefix,
    std::span<const Field<Target>> fields,
    Target values,
    std::vector<ConfigField>& list
) {
    for (const Field<Target>& field : fields) {
        const Slot slot = field.slot(values);
        list.push_back(
            {.path = std::string(prefix) + std::string(field.path),
             .type = std::string(std::visit(SlotType{}, slot)),
             .low = field.range.low,
             .high = field.range.high,
             .choices = {field.choices.begin(), field.choices.end()},
             .default_value = std::visit(SlotDefault{field.choices}, slot),
             .unit = std::string(field.unit),
             .description = std::string(field.description)}
        );
    }
}

}  // namespace

std::vector<ConfigField> config_fields() {
    return config_values(Config{});
}

std::vector<ConfigField> config_values(const Config& config) {
    std::vector<ConfigField> list;
    describe<Config>("", config_table(), config, list);
    describe<StartItem>("/pets/start/*", start_table(), StartItem{}, list);
    describe<FullScreenRule>(
        "/overlay/fullscreen_rules/*", full_screen_rule_table(), FullScreenRule{}, list
    );
    return list;
}

Result<LoadedConfig> parse_config(std::string_view text, std::string_view file) {
    const Result<LocatedJson> root = parse_located_json(text, file);
    if (!root) {
        return std::unexpected(root.error());
    }
    JsonProblems problems{std::string(file)};
    LoadedConfig loaded;
    read_members<Config>(JsonValue(*root, "", problems), "", config_table(), loaded.config);
    if (problems.has_errors()) {
        return std::unexpected(problems.error());
    }
    loaded.warnings = problems.warnings();
    return loaded;
}

Result<LoadedConfig> load_config(const std::filesystem::path& path) {
    const Result<std::string> text = read_text_file(path, max_file_bytes);
    if (!text) {
        return std::unexpected(text.error());
    }
    return parse_config(*text, utf8_from_path(path));
}

}  // namespace hyrax
