// SPDX-License-Identifier: MIT
#include "daemon/control/config_key.h"

#include <algorithm>

namespace hyrax {

std::string pointer_of(std::string_view key) {
    std::string pointer(key.starts_with('/') ? "" : "/");
    pointer += key;
    std::ranges::replace(pointer, '.', '/');
    return pointer;
}

std::string dotted(std::string_view pointer) {
    std::string key(pointer.substr(pointer.starts_with('/') ? 1 : 0));
    std::ranges::replace(key, '/', '.');
    return key;
}

std::vector<ConfigField> settable(std::vector<ConfigField> fields) {
    std::erase_if(fields, [](const ConfigField& field) {
        return field.path.contains('*') || field.path.contains('$');
    });
    return fields;
}

std::vector<std::string> settable_keys() {
    std::vector<std::string> keys;
    for (const ConfigField& field : settable(config_fields())) {
        keys.push_back(dotted(field.path));
    }
    return keys;
}

}  // namespace hyrax
