// Message on a wrong file: at least the file, and something about it.
#pragma once

#include <cctype>
#include <string>
#include <string_view>

#include "tests/quality/fuzz/support/require.hpp"

namespace fuzz {

// "FILE: ..." or "FILE:LINE: ...".
inline void require_place(std::string_view message, std::string_view file) {
    const bool named = message.substr(0U, file.size()) == file && message.size() > file.size() + 3U &&
                       message[file.size()] == ':';
    require(named, "an error names the file");
    std::string_view rest = message.substr(file.size() + 1U);
    while (!rest.empty() && std::isdigit(static_cast<unsigned char>(rest.front())) != 0) {
        rest.remove_prefix(1U);
    }
    require(rest.size() > 3U && (rest.front() == ':' || rest.front() == ' '), "an error says what is wrong");
}

}  // namespace fuzz
