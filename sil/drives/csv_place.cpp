#include "sil/drives/csv_place.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sil/drives/drive_csv.hpp"

namespace sil {

void CsvPlace::fail(std::size_t line, std::size_t column, const std::string& what,
                    const std::string& remedy) const {
    throw DriveCsvError(fmt::format("{}:{}:{}: {}; {}", file_, line, column, what, remedy));
}

std::string printable(std::string_view text) {
    constexpr std::size_t longest = 40U;
    std::string result{text.substr(0U, longest)};
    std::replace_if(
        result.begin(), result.end(), [](char character) { return character < ' ' || character > '~'; }, '?');
    return text.size() > longest ? result + "..." : result;
}

}  // namespace sil
