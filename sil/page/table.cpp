#include "sil/page/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

namespace sil {
namespace {

std::string text_of(const TableCell& cell, int digits) {
    const auto number = [digits](double value) { return fmt::format("{:.{}f}", value, digits); };
    if (const auto* words = std::get_if<std::string>(&cell)) {
        return *words;
    }
    if (const auto* count = std::get_if<std::size_t>(&cell)) {
        return fmt::format("{}", *count);
    }
    if (const auto* share = std::get_if<TableShare>(&cell)) {
        return std::isfinite(share->value) ? fmt::format("{} ({} to {})", number(share->value),
                                                         number(share->lowest), number(share->highest))
                                           : "-";
    }
    const double value = std::get<double>(cell);
    return std::isfinite(value) ? number(value) : "-";
}

}  // namespace

std::string markdown(const Table& table) {
    std::string head = "|";
    std::string rule = "|";
    for (const TableColumn& column : table.columns) {
        if (!column.on_page_only) {
            head += fmt::format(" {}{} |", column.name, column.unit.empty() ? "" : ", " + column.unit);
            rule += table.numbers_right && column.digits >= 0 ? "---:|" : "---|";
        }
    }
    std::string text = head + "\n" + rule + "\n";
    for (const std::vector<TableCell>& row : table.rows) {
        text += "|";
        for (std::size_t place = 0U; place < row.size(); ++place) {
            const TableColumn& column = table.columns[place];
            text += column.on_page_only ? "" : fmt::format(" {} |", text_of(row[place], column.digits));
        }
        text += "\n";
    }
    return text;
}

}  // namespace sil
