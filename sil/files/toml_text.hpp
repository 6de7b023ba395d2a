// TOML text: values as TOML wants them written.
#pragma once

#include <fmt/format.h>

#include <string>

namespace sil {

// A float, never without a point or an exponent; the shortest text that gives the same number.
inline std::string toml_number(double value) {
    const std::string text = fmt::format("{}", value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

// A string; it may hold a backslash, a quotation mark, even a line feed.
inline std::string toml_string(const std::string& text) {
    std::string result = "\"";
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            result += '\\';
            result += letter;
        } else if (code < 0x20U || code == 0x7FU) {
            result += fmt::format("\\u{:04X}", code);
        } else {
            result += letter;
        }
    }
    return result + "\"";
}

}  // namespace sil
