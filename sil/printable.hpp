// Printable: what a file says, as a message may repeat it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace sil {

// At most 40 characters, others than printable ASCII replaced by '?'.
inline std::string printable(std::string_view text) {
    constexpr std::size_t longest = 40U;
    std::string result{text.substr(0U, longest)};
    std::replace_if(
        result.begin(), result.end(), [](char character) { return character < ' ' || character > '~'; }, '?');
    return text.size() > longest ? result + "..." : result;
}

}  // namespace sil
