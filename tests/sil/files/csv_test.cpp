// CSV: rows as they are written, and the fields and numbers that are read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sil/files/csv_reader.hpp"
#include "sil/files/csv_writer.hpp"
#include "sil/files/file_io.hpp"
#include "sil/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace csv_test {
namespace {

using testing::HasSubstr;

struct Point {
    double x_m;
    double y_m;
};

constexpr sil::CsvColumn<Point> columns[] = {
    {"x_m", [](const Point& point) { return point.x_m; }},
    {"y_m", [](const Point& point) { return point.y_m; }},
};

TEST(CsvRow, HasNamesAndNumbersInTheOrderOfTheTable) {
    EXPECT_EQ(sil::CsvRow{}.names(columns).line(), "x_m,y_m");
    EXPECT_EQ(sil::CsvRow{}.numbers(columns, Point{1.0 / 3.0, 2.0e10}, 4).line(), "0.3333,2e+10");
}

TEST(CsvRow, LeavesWhatIsNotFiniteOrNotThereEmpty) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(sil::CsvRow{}.number(std::nan(""), 9).number(-infinity, 9).count(3U).line(), ",,3");
    EXPECT_EQ(sil::CsvRow{}.fixed(std::nullopt, 3).fixed(infinity, 3).fixed(0.5, 3).line(), ",,0.500");
}

TEST(CsvRow, QuotesATextThatHoldsASeparator) {
    EXPECT_EQ(sil::CsvRow{}.text("a b").text("a,b").text("say \"no\"").text("\n").line(),
              "a b,\"a,b\",\"say \"\"no\"\"\",\"\n\"");
}

TEST(CsvFile, HasHeaderAndRows) {
    const test_support::ScratchFolder folder;
    sil::CsvFile file{folder.path() / "points.csv", sil::CsvRow{}.names(columns).line()};
    file.write("1,2");
    file.close();
    EXPECT_EQ(sil::read_whole_file(folder.path() / "points.csv"), "x_m,y_m\n1,2\n");
}

TEST(CsvFile, NamesWhatCannotBeWritten) {
    try {
        const sil::CsvFile file{"/no/such/folder/points.csv", ""};
        FAIL() << "was opened";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(
            error.what(),
            "cannot write /no/such/folder/points.csv: No such file or directory; check that the folder "
            "exists and may be written");
    }
}

TEST(CsvLines, PassOverWhatIsNoLine) {
    sil::CsvLines lines{"\xEF\xBB\xBFtime,\" x\" \r\n\n1,+2"};
    sil::CsvLine line;
    std::vector<sil::CsvField> fields;
    ASSERT_TRUE(lines.next(line));
    sil::split_fields(line.text, fields);
    ASSERT_EQ(fields.size(), 2U);
    EXPECT_EQ(fields[1].text, " x");
    EXPECT_EQ(fields[1].column, 7U);
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line.number, 3U);
    EXPECT_FALSE(line.is_ended);
    EXPECT_FALSE(lines.next(line));
}

std::vector<std::string> fields_of(std::string_view line) {
    std::vector<sil::CsvField> fields;
    sil::split_fields(line, fields);
    std::vector<std::string> texts;
    for (const sil::CsvField& field : fields) {
        texts.push_back(std::to_string(field.column) + ":" + std::string{field.text});
    }
    return texts;
}

TEST(SplitFields, TakesBlanksAndQuotesFromTheEnds) {
    using testing::ElementsAre;
    EXPECT_THAT(fields_of("a,b"), ElementsAre("1:a", "3:b"));
    EXPECT_THAT(fields_of(" \ta b\t ,, c"), ElementsAre("3:a b", "9:", "11:c"));
    EXPECT_THAT(fields_of("\"a\",\"\",\"b,\"c"), ElementsAre("2:a", "6:", "8:\"b", "11:\"c"));
    EXPECT_THAT(fields_of("a,"), ElementsAre("1:a", "3:"));
    EXPECT_THAT(fields_of("\""), ElementsAre("1:\""));
    EXPECT_THAT(fields_of(" "), ElementsAre("2:"));
    EXPECT_THAT(fields_of(" ,b"), ElementsAre("2:", "3:b"));
    EXPECT_THAT(fields_of("a\",b\""), ElementsAre("1:a\"", "4:b\""));
}

TEST(SplitFields, ForgetsTheLineBefore) {
    std::vector<sil::CsvField> fields;
    sil::split_fields("a,b", fields);
    sil::split_fields("c", fields);
    ASSERT_EQ(fields.size(), 1U);
    EXPECT_EQ(fields[0].text, "c");
}

TEST(CsvLines, EndWithAnyEndOfALine) {
    sil::CsvLines lines{"a\r\n\r\n \t\nb\nc\r"};
    std::vector<std::string> seen;
    for (sil::CsvLine line; lines.next(line);) {
        seen.push_back(std::to_string(line.number) + (line.is_ended ? ":" : "?") + std::string{line.text});
    }
    EXPECT_THAT(seen, testing::ElementsAre("1:a", "4:b", "5?c\r"));
    sil::CsvLines without_mark{
        "\xEF\xBB"
        "a\n"};
    sil::CsvLine line;
    ASSERT_TRUE(without_mark.next(line));
    EXPECT_EQ(line.text,
              "\xEF\xBB"
              "a");
}

TEST(CsvHeader, HasTheNamesInTheirOrder) {
    EXPECT_EQ(sil::csv_header({"a", "b,c", ""}), "a,\"b,c\",");
    EXPECT_EQ(sil::csv_header({}), "");
}

TEST(FiniteNumber, IsAWholeFieldWithAPoint) {
    EXPECT_EQ(sil::finite_number("+1.5e1"), 15.0);
    EXPECT_EQ(sil::finite_number("+1"), 1.0);
    EXPECT_EQ(sil::finite_number("12"), 12.0);
    EXPECT_EQ(sil::finite_number("-12.5"), -12.5);
    EXPECT_EQ(sil::finite_number("-0"), 0.0);
    for (const char* none : {"", "+", "+-1", "1,5", "1 ", "nan", "inf", "1e999", "0x10"}) {
        EXPECT_EQ(sil::finite_number(none), std::nullopt) << none;
    }
}

TEST(CsvPlace, IsNamedInAnError) {
    try {
        sil::CsvPlace{"a.csv"}.fail(3U, 7U, "is wrong", "mend it");
    } catch (const sil::InputError& error) {
        EXPECT_STREQ(error.what(), "a.csv:3:7: is wrong; mend it");
    }
}

// The last one can be opened; its first page, which is in no program, cannot be read.
TEST(ReadWholeFile, NamesWhatCannotBeRead) {
    for (const char* path : {"/no/such/file", "/tmp", "/proc/self/mem"}) {
        try {
            sil::read_whole_file(path);
            ADD_FAILURE() << path;
        } catch (const sil::InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(std::string{path} + ": cannot be read: "));
        }
    }
}

}  // namespace
}  // namespace csv_test
