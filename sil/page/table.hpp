// Table: a report's table, filled once and shown on a page (study_page.hpp) or in Markdown.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace sil {

// Numbers have so many decimals; fewer than none: the column holds words.
struct TableColumn {
    static constexpr int of_words = -1;

    std::string name{};
    int digits{of_words};
    std::string unit{};
    bool on_page_only{false};
};

// With an interval of confidence.
struct TableShare {
    double value;
    double lowest;
    double highest;
};

// A count has no decimals, whatever its column has. A number that is not finite is shown as not known.
using TableCell = std::variant<std::string, std::size_t, double, TableShare>;

struct Table {
    std::string name{};  // by which tests and links find it
    std::string heading{};
    std::vector<TableColumn> columns{};
    std::vector<std::vector<TableCell>> rows{};
    std::string note{};
    bool numbers_right{false};  // in Markdown
};

// Columns and rows; heading and note are the page's.
std::string markdown(const Table& table);

}  // namespace sil
