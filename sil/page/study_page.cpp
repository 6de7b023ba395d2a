#include "sil/page/study_page.hpp"

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sil/page/json_text.hpp"
#include "sil/page/page_recording.hpp"
#include "sil/page/page_text.hpp"

namespace sil {
namespace {

using Json = nlohmann::ordered_json;

// As many digits as are read off, so that a page stays small.
Json number(double value) {
    constexpr double most_exact = 1.0e9;
    if (!std::isfinite(value)) {
        return nullptr;
    }
    const double rounded = std::round(value * 1.0e6) / 1.0e6;
    return std::fabs(value) < most_exact ? Json(rounded) : Json(value);
}

Json json_of(const TableCell& cell) {
    if (const auto* share = std::get_if<TableShare>(&cell)) {
        return std::isfinite(share->value)
                   ? Json{number(share->value), number(share->lowest), number(share->highest)}
                   : Json(nullptr);
    }
    if (const auto* count = std::get_if<std::size_t>(&cell)) {
        return std::to_string(*count);
    }
    return std::holds_alternative<double>(cell) ? number(std::get<double>(cell))
                                                : Json(std::get<std::string>(cell));
}

Json json_of(const StudyAxis& axis, bool is_y) {
    Json json{{"words", axis.words}, {"unit", axis.unit}, {"digits", axis.digits}};
    Json& range = is_y ? json["least"] : json;
    if (axis.from) {
        range["from"] = number(*axis.from);
    }
    if (axis.to) {
        range["to"] = number(*axis.to);
    }
    return json;
}

Json json_of(const StudyLine& line) {
    static constexpr const char* styles[] = {"line", "mark", "cloud", "band"};
    Json json{{"words", line.words},
              {"colour", line.colour},
              {"dash", line.dash},
              {"width", line.width},
              {"style", styles[static_cast<std::size_t>(line.style)]},
              {"shown", line.shown}};
    Json& points = json["points"] = Json::array();
    for (const StudyPoint& point : line.points) {
        Json values = Json::array();
        for (const double value : point) {
            values.push_back(number(value));
        }
        points.push_back(values);
    }
    return json;
}

}  // namespace

StudyLine plain_line(const std::string& words, const std::string& colour, double width) {
    StudyLine line;
    line.words = words;
    line.colour = colour;
    line.width = width;
    return line;
}

StudyLine measured_line(const std::string& words) {
    return plain_line(words, "--sky", 2.5);
}

StudyLine predicted_line(const std::string& words) {
    StudyLine line = plain_line(words, "--vermilion", 2.0);
    line.dash = {6, 3};
    return line;
}

StudyLine index_line(const std::string& index) {
    static const std::vector<std::vector<int>> dashes{{}, {6, 3}, {2, 3}};
    StudyLine line = plain_line(index, "--quiet", 2.0);
    line.dash = dashes[2];
    std::istringstream rows{std::string{index_styles}};
    for (std::string row; std::getline(rows, row);) {
        const std::vector<std::string> cells = cells_of(row);
        if (cells.at(0) == index) {
            line.colour = "--" + (cells.at(1) == "grey" ? "quiet" : cells.at(1));
            line.dash = dashes.at(std::stoul(cells.at(2)) - 1U);
        }
    }
    return line;
}

void StudyPage::section(const std::string& heading) {
    sections_.push_back({heading, {}});
}

void StudyPage::text(const std::string& text) {
    sections_.back().blocks.push_back(json_text({{"kind", "text"}, {"text", text}}));
}

void StudyPage::list(const std::vector<std::string>& sentences) {
    sections_.back().blocks.push_back(json_text({{"kind", "list"}, {"items", sentences}}));
}

void StudyPage::table(const Table& table) {
    Json json{{"kind", "table"}, {"name", table.name}, {"heading", table.heading}, {"note", table.note}};
    json["columns"] = Json::array();
    for (const TableColumn& column : table.columns) {
        json["columns"].push_back({{"words", column.name}, {"digits", column.digits}, {"unit", column.unit}});
    }
    json["rows"] = Json::array();
    for (const std::vector<TableCell>& row : table.rows) {
        Json cells = Json::array();
        for (const TableCell& cell : row) {
            cells.push_back(json_of(cell));
        }
        json["rows"].push_back(cells);
    }
    sections_.back().blocks.push_back(json_text(json));
}

void StudyPage::chart(const StudyChart& chart) {
    Json json{{"kind", "chart"}, {"name", chart.name}, {"heading", chart.heading}, {"note", chart.note}};
    json["x"] = json_of(chart.x, false);
    json["y"] = json_of(chart.y, true);
    static constexpr const char* readings[] = {"nearest", "last", "next"};
    json["reading"] = readings[static_cast<std::size_t>(chart.reading)];
    json["marks"] = Json::array();
    for (const double x : chart.marks_x) {
        json["marks"].push_back({{"x", number(x)}});
    }
    for (const double y : chart.marks_y) {
        json["marks"].push_back({{"y", number(y)}});
    }
    json["series"] = Json::array();
    for (const StudyLine& line : chart.lines) {
        json["series"].push_back(json_of(line));
    }
    sections_.back().blocks.push_back(json_text(json));
}

std::string StudyPage::html() const {
    std::string json = "{\"title\":" + json_text(Json(title_)) +
                       ",\"subtitle\":" + json_text(Json(subtitle_)) + ",\n\"sections\":[";
    for (std::size_t place = 0U; place < sections_.size(); ++place) {
        const Section& section = sections_[place];
        json += std::string{place > 0U ? ",\n" : "\n"} + "{\"heading\":" + json_text(Json(section.heading)) +
                ",\"blocks\":[";
        for (std::size_t block = 0U; block < section.blocks.size(); ++block) {
            json += std::string{block > 0U ? ",\n" : "\n"} + section.blocks[block];
        }
        json += "]}";
    }
    return study_with(json + "]}");
}

}  // namespace sil
