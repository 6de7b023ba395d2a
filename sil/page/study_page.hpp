// Study page: the report of a campaign, an identification or the like, as sections of texts, tables and
// charts.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sil/page/table.hpp"

namespace sil {

struct StudyAxis {
    std::string words{};
    std::string unit{};
    int digits{2};
    // The range of x; values that y includes at least. Otherwise that of the points.
    std::optional<double> from{};
    std::optional<double> to{};
};

// x and y, and of some charts a third value that is read off with them, in brackets or as the band's end. A y
// that is not finite interrupts the line.
using StudyPoint = std::vector<double>;

struct StudyLine {
    // A mark: few points. A cloud: many, in any order, not read off. A band: between y and the third value.
    enum class Style { line, mark, cloud, band };

    std::string words{};
    std::string colour{"--blue"};  // of style.css
    std::vector<int> dash{};
    double width{2.0};
    Style style{Style::line};
    bool shown{true};                  // at first
    std::vector<StudyPoint> points{};  // in the order of x, unless a cloud
};

// Which point of a line is read off at x: the nearest; the last until there; the first from there on.
enum class StudyReading { nearest, last, next };

struct StudyChart {
    std::string name{};
    std::string heading{};
    StudyAxis x{};
    StudyAxis y{};
    std::vector<StudyLine> lines{};
    std::string extra{};            // meaning of a point's third value
    std::vector<double> marks_x{};  // thin lines across
    std::vector<double> marks_y{};
    std::string note{};
    StudyReading reading{StudyReading::nearest};
};

// Words in one colour.
StudyLine plain_line(const std::string& words, const std::string& colour, double width);

// A signal as it was measured, and what a model makes of it. The latter lies on top; dashed, it leaves the
// former in sight where both are the same.
StudyLine measured_line(const std::string& words);
StudyLine predicted_line(const std::string& words);

// With colour and dash of the index, which are the same in every chart; an index without them is grey and
// dotted.
StudyLine index_line(const std::string& index);

class StudyPage {
 public:
    StudyPage(std::string title, std::string subtitle)
        : title_{std::move(title)}, subtitle_{std::move(subtitle)} {}

    // The following parts belong to it; there must be one first.
    void section(const std::string& heading);
    void text(const std::string& text);
    void list(const std::vector<std::string>& sentences);
    void table(const Table& table);
    void chart(const StudyChart& chart);

    // The whole page. Texts may hold anything.
    std::string html() const;

 private:
    struct Section {
        std::string heading;
        std::vector<std::string> blocks;  // JSON
    };

    std::string title_;
    std::string subtitle_;
    std::vector<Section> sections_{};
};

// Every so many of `count` samples: few enough that a page stays small, enough that no eye misses any.
inline constexpr std::size_t most_chart_points = 1500U;
constexpr std::size_t chart_stride(std::size_t count) {
    return 1U + count / (most_chart_points + 1U);
}

}  // namespace sil
