// Study page: what it holds, whatever the texts and numbers are.
#include "sil/page/study_page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rsi/rsi_outputs.h"

namespace study_page_test {
namespace {

using nlohmann::json;

// Text between the marks of its element, as the browser parses it.
json held_by(const std::string& html) {
    const std::string mark = "<script id=\"study\" type=\"application/json\">";
    const std::size_t begin = html.find(mark) + mark.size();
    return json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

TEST(StudyPage, HoldsTextsThatCannotEndTheirElement) {
    sil::StudyPage page{"</script><b>", "\xff\"'&"};
    page.section("</script>");
    page.text("<!--");
    page.list({"one", "</script>"});
    const std::string html = page.html();
    const json held = held_by(html);
    EXPECT_EQ(held["title"], "</script><b>");
    EXPECT_EQ(held["subtitle"], "\xef\xbf\xbd\"'&");
    EXPECT_EQ(held["sections"][0]["heading"], "</script>");
    EXPECT_EQ(held["sections"][0]["blocks"][0]["text"], "<!--");
    EXPECT_EQ(held["sections"][0]["blocks"][1]["items"][1], "</script>");
    EXPECT_EQ(html.find("</script><b>"), std::string::npos);
    EXPECT_EQ(html.find("<!--"), std::string::npos);
}

TEST(StudyPage, HasNoNumberThatIsNotFinite) {
    sil::StudyPage page{"a", "b"};
    page.section("c");
    sil::Table table;
    table.columns = {{"words"}, {"number", 2, "m"}};
    table.rows = {{std::string{"x"}, std::nan("")}, {std::string{"y"}, HUGE_VAL}, {std::string{"z"}, 1.5}};
    page.table(table);
    sil::StudyChart chart;
    chart.name = "chart";
    chart.y.to = 100.0;
    chart.marks_x = {0.5};
    chart.lines = {sil::index_line("published")};
    chart.lines[0].points = {{0.0, 1.0}, {1.0, std::nan("")}, {2.0, 1.0 / 3.0}};
    page.chart(chart);
    const json blocks = held_by(page.html())["sections"][0]["blocks"];
    EXPECT_EQ(blocks[0]["rows"], json::parse(R"([["x",null],["y",null],["z",1.5]])"));
    EXPECT_EQ(blocks[0]["columns"][0]["digits"], -1);
    EXPECT_EQ(blocks[1]["series"][0]["points"], json::parse("[[0,1],[1,null],[2,0.333333]]"));
    EXPECT_EQ(blocks[1]["y"]["least"], json::parse(R"({"to":100})"));
    EXPECT_EQ(blocks[1]["marks"], json::parse(R"([{"x":0.5}])"));
    EXPECT_EQ(blocks[1]["series"][0]["dash"], json::parse("[6,3]"));
}

TEST(IndexLine, IsAnIndexsOwnInEveryChart) {
    std::set<std::pair<std::string, std::vector<int>>> all{{"--quiet", {2, 3}}};  // that of an unknown one
#define NAME(name, unit, mirror, CHOICE, number, choice, scale, side, meaning) #choice,
#define NOTHING(...)
    for (const char* index : {RSI_OUTPUTS(NOTHING, NOTHING, NAME) "true_load_transfer"}) {
        const sil::StudyLine line = sil::index_line(index);
        EXPECT_EQ(line.words, index);
        EXPECT_TRUE(all.emplace(line.colour, line.dash).second) << index << " has no style, or another's";
    }
#undef NOTHING
#undef NAME
    EXPECT_EQ(all.count({sil::index_line("yet another").colour, sil::index_line("yet another").dash}), 1U);
}

sil::Table table_of_cells() {
    sil::Table table;
    table.columns = {{"name"}, {"share", 1, "%"}, {"count", 0, "", true}, {"lead", 2, "s"}};
    table.rows = {{"a", sil::TableShare{50.0, 41.26, 58.74}, 3.0, 0.125},
                  {"b", sil::TableShare{std::nan(""), 0.0, 100.0}, 0.0, std::nan("")},
                  {"c", 2.25, std::size_t{4}, std::size_t{12}}};
    return table;
}

TEST(Table, IsShownInMarkdownWithUnitsAndIntervals) {
    EXPECT_EQ(sil::markdown(table_of_cells()),
              "| name | share, % | lead, s |\n|---|---|---|\n"
              "| a | 50.0 (41.3 to 58.7) | 0.12 |\n| b | - | - |\n| c | 2.2 | 12 |\n");
    sil::Table table = table_of_cells();
    table.numbers_right = true;
    EXPECT_NE(sil::markdown(table).find("\n|---|---:|---:|\n"), std::string::npos);
}

TEST(Table, IsShownOnAPageWithAllColumns) {
    sil::StudyPage page{"a", "b"};
    page.section("c");
    page.table(table_of_cells());
    const json table = held_by(page.html())["sections"][0]["blocks"][0];
    EXPECT_EQ(table["columns"][2], json::parse(R"({"words":"count","digits":0,"unit":""})"));
    EXPECT_EQ(table["rows"],
              json::parse(R"([["a",[50,41.26,58.74],3,0.125],["b",null,0,null],["c",2.25,"4","12"]])"));
}

TEST(StudyPage, ThinsOutOnlyWhatIsLong) {
    EXPECT_EQ(sil::chart_stride(0U), 1U);
    EXPECT_EQ(sil::chart_stride(sil::most_chart_points), 1U);
    EXPECT_EQ(sil::chart_stride(sil::most_chart_points + 1U), 2U);
}

}  // namespace
}  // namespace study_page_test
