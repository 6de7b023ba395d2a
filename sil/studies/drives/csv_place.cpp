#include "sil/studies/drives/csv_place.hpp"

#include <fmt/format.h>

#include "sil/studies/drives/drive_csv.hpp"

namespace sil {

void CsvPlace::fail(std::size_t line, std::size_t column, const std::string& what,
                    const std::string& remedy) const {
    throw DriveCsvError(fmt::format("{}:{}:{}: {}; {}", file_, line, column, what, remedy));
}

}  // namespace sil
