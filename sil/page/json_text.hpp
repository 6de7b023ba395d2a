// JSON text: what pages hold, from values that files gave.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace sil {

// Names come from files: bytes that are not UTF-8 are replaced and never thrown about.
inline std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace sil
