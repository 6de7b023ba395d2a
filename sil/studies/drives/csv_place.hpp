// CSV place: errors of one file, with line and column.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

namespace sil {

class CsvPlace {
 public:
    explicit CsvPlace(std::string file) : file_{std::move(file)} {}

    // Throws DriveCsvError: "FILE:LINE:COLUMN: what; remedy".
    [[noreturn]] void fail(std::size_t line, std::size_t column, const std::string& what,
                           const std::string& remedy) const;

 private:
    std::string file_;
};

}  // namespace sil
