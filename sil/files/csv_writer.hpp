// CSV writer: rows of cells, and a file that is written row by row.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sil/files/file_io.hpp"

namespace sil {

// A column of numbers: its name, which ends with the unit, and its value in a row's data. A table of them is
// the one place that orders the columns.
template <typename Row>
struct CsvColumn {
    const char* name;
    double (*value)(const Row& row);
};

// Cells one after the other. A value that is not finite, or missing, is an empty cell.
class CsvRow {
 public:
    // In quotation marks where it holds a comma, a quotation mark or an end of line.
    CsvRow& text(std::string_view cell);
    CsvRow& count(std::uint64_t value);
    CsvRow& number(double value, int significant_digits);
    CsvRow& fixed(const std::optional<double>& value, int decimals);

    template <typename Row, std::size_t size>
    CsvRow& names(const CsvColumn<Row> (&columns)[size]) {
        for (const CsvColumn<Row>& column : columns) {
            text(column.name);
        }
        return *this;
    }

    template <typename Row, std::size_t size>
    CsvRow& numbers(const CsvColumn<Row> (&columns)[size], const Row& row, int significant_digits) {
        for (const CsvColumn<Row>& column : columns) {
            number(column.value(row), significant_digits);
        }
        return *this;
    }

    // Without its end.
    const std::string& line() const { return line_; }

 private:
    void separate();

    std::string line_{};
    bool has_cells_{false};
};

// The line that names the columns.
std::string csv_header(const std::vector<std::string>& columns);

class CsvFile {
 public:
    // Begins the file (sil/files/file_io.hpp) with the header. Throws std::runtime_error with path and
    // reason, like all of it.
    CsvFile(const std::filesystem::path& path, const std::string& header);

    void write(const std::string& line) { file_.write(line + '\n'); }

    // From here on the file is there.
    void close() { file_.finish(); }

 private:
    GrowingFile file_;
};

}  // namespace sil
