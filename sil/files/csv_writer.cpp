#include "sil/files/csv_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace sil {

void CsvRow::separate() {
    if (has_cells_) {
        line_ += ',';
    }
    has_cells_ = true;
}

CsvRow& CsvRow::text(std::string_view cell) {
    separate();
    if (cell.find_first_of(",\"\r\n") == std::string_view::npos) {
        line_ += cell;
        return *this;
    }
    line_ += '"';
    for (const char character : cell) {
        line_.append(character == '"' ? 2U : 1U, character);
    }
    line_ += '"';
    return *this;
}

CsvRow& CsvRow::count(std::uint64_t value) {
    separate();
    fmt::format_to(std::back_inserter(line_), "{}", value);
    return *this;
}

CsvRow& CsvRow::number(double value, int significant_digits) {
    separate();
    if (std::isfinite(value)) {
        fmt::format_to(std::back_inserter(line_), "{:.{}g}", value, significant_digits);
    }
    return *this;
}

CsvRow& CsvRow::fixed(const std::optional<double>& value, int decimals) {
    separate();
    if (value && std::isfinite(*value)) {
        fmt::format_to(std::back_inserter(line_), "{:.{}f}", *value, decimals);
    }
    return *this;
}

std::string csv_header(const std::vector<std::string>& columns) {
    CsvRow row;
    for (const std::string& column : columns) {
        row.text(column);
    }
    return row.line();
}

CsvFile::CsvFile(const std::filesystem::path& path, const std::string& header) : file_{path} {
    write(header);
}

}  // namespace sil
