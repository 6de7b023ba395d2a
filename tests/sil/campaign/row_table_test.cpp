// Row table: rows as a report reads them, and what it says to a damaged file.
#include "sil/studies/campaign/row_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sil/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace row_table_test {
namespace {

using testing::HasSubstr;

constexpr const char* header =
    "run,vehicle,manoeuvre,largest_ltr,two_wheel_lift_time_s,brief_two_wheel_lift_time_s,warning_time_s,"
    "x_peak,x_peak_100ms_before,x_time_s\n";

sil::RowTable load(const std::string& text) {
    const test_support::ScratchFolder folder;
    test_support::write_text(folder.path() / "runs.csv", text);
    return sil::load_rows(folder.path() / "runs.csv");
}

void expect_refused(const std::string& text, const std::string& why) {
    try {
        load(text);
        FAIL() << "was accepted: " << text;
    } catch (const sil::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(why));
    }
}

TEST(RowTable, ReadsEveryCellAndSortsByRun) {
    const sil::RowTable table = load(std::string{header} + "5,car,turn,1,3.25,,3.1,1.5,0.75,3.08\n" +
                                     "4,bus,ramp,0.5,,1.5,,0.25,0.25,\n");
    EXPECT_THAT(table.index_names, testing::ElementsAre("x"));
    ASSERT_EQ(table.runs.size(), 2U);
    EXPECT_EQ(table.runs[0].number, 4U);
    EXPECT_EQ(table.runs[0].vehicle, "bus");
    EXPECT_EQ(table.runs[0].brief_two_wheel_lift_time_s, 1.5);
    EXPECT_FALSE(table.runs[0].two_wheel_lift_time_s);
    EXPECT_FALSE(table.runs[0].indices[0].time_s);
    EXPECT_EQ(table.runs[1].manoeuvre, "turn");
    EXPECT_EQ(table.runs[1].two_wheel_lift_time_s, 3.25);
    EXPECT_EQ(table.runs[1].warning_time_s, 3.1);
    EXPECT_EQ(table.runs[1].indices[0].peak, 1.5);
    EXPECT_EQ(table.runs[1].indices[0].peak_100ms_before, 0.75);
    EXPECT_EQ(table.runs[1].indices[0].time_s, 3.08);
}

TEST(RowTable, LeavesOutALineThatWasCutOff) {
    const std::string row = "5,car,turn,1,3.25,,3.1,1.5,0.75,3.0";
    EXPECT_EQ(load(header + row + "\n" + row).runs.size(), 1U);
}

TEST(RowTable, NamesLineAndColumnOfWhatIsWrong) {
    expect_refused(std::string{header} + "5,car,turn,much,,,,1,1,\n",
                   "runs.csv:2:12: column largest_ltr wants a number, not \"much\"");
    expect_refused(std::string{header} + "5,car,turn,nan,,,,1,1,\n", "column largest_ltr");
    expect_refused(std::string{header} + "5,car,turn,1,,,,1,1\n", "runs.csv:2:1: has 9 cells, not 10");
    expect_refused("run,vehicle,manoeuvre\n5,car,turn\n", "there is no column largest_ltr");
    expect_refused("", "there are no rows");
}

}  // namespace
}  // namespace row_table_test
