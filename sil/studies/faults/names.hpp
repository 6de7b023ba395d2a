// Names: values of an enumeration in TOML files, by what to_string calls them.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "sil/files/toml_table.hpp"

namespace sil {

// The value whose name the key gives. `last`: of the enumeration.
template <typename Value>
Value named(TomlTable& table, std::string_view key, Value last) {
    std::vector<std::string_view> names;
    for (std::size_t value = 0U; value <= static_cast<std::size_t>(last); ++value) {
        names.emplace_back(to_string(static_cast<Value>(value)));
    }
    return static_cast<Value>(table.choice(key, names));
}

}  // namespace sil
