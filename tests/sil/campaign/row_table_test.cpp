// Row table: rows as a report reads them, and what it says to a damaged file.
#include "sil/studies/campaign/row_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sil/input_error.hpp"
#include "sil/studies/campaign/fingerprint.hpp"
#include "tests/support/scratch_folder.hpp"

namespace row_table_test {
namespace {

using testing::HasSubstr;

constexpr const char* header =
    "run,vehicle,class,manoeuvre,largest_ltr,two_wheel_lift_time_s,brief_two_wheel_lift_time_s,end_time_s,"
    "distance_m,lead_time_s,wrong_side_duration_s,warnings,advisories,unavailable_duration_s,"
    "diagnostic_codes,"
    "x_threshold,x_threshold_100ms,x_threshold_200ms,x_lead_time_s,row_check\n";

std::string checked(const std::string& row) {
    return row + "," + sil::fingerprint_of(row) + "\n";
}

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
    const sil::RowTable table =
        load(std::string{header} +
             checked("5,car,small,turn,1,3.25,,4.5,80,0.15,0.02,2,3,0.04,imu lost,1.5,0.75,0.5,0.17") +
             checked("4,bus,,ramp,0.5,,1.5,9,90,,0,0,0,0,,0.25,0.25,0.25,"));
    EXPECT_THAT(table.index_names, testing::ElementsAre("x"));
    ASSERT_EQ(table.runs.size(), 2U);
    EXPECT_EQ(table.runs[0].number, 4U);
    EXPECT_EQ(table.runs[0].vehicle, "bus");
    EXPECT_EQ(table.runs[0].in_class, "");
    EXPECT_EQ(table.runs[1].in_class, "small");
    EXPECT_EQ(table.runs[0].brief_two_wheel_lift_time_s, 1.5);
    EXPECT_FALSE(table.runs[0].two_wheel_lift_time_s);
    EXPECT_FALSE(table.runs[0].lead_s);
    EXPECT_FALSE(table.runs[0].indices[0].lead_s);
    const sil::RecordedCampaignRun& lifted = table.runs[1];
    EXPECT_EQ(lifted.manoeuvre, "turn");
    EXPECT_EQ(lifted.two_wheel_lift_time_s, 3.25);
    EXPECT_EQ(lifted.end_time_s, 4.5);
    EXPECT_EQ(lifted.distance_m, 80.0);
    EXPECT_EQ(lifted.lead_s, 0.15);
    EXPECT_EQ(lifted.wrong_side_s, 0.02);
    EXPECT_EQ(lifted.warnings, 2U);
    EXPECT_EQ(lifted.advisories, 3U);
    EXPECT_EQ(lifted.unavailable_s, 0.04);
    EXPECT_TRUE(lifted.has_code);
    EXPECT_FALSE(table.runs[0].has_code);
    EXPECT_EQ(lifted.indices[0].threshold, 1.5);
    EXPECT_EQ(lifted.indices[0].threshold_100ms, 0.75);
    EXPECT_EQ(lifted.indices[0].threshold_200ms, 0.5);
    EXPECT_EQ(lifted.indices[0].lead_s, 0.17);
}

TEST(RowTable, LeavesOutALineThatWasCutOff) {
    const std::string row = "5,car,small,turn,1,3.25,,4.5,80,0.15,0.02,2,3,0.04,,1.5,0.75,0.5,0.1";
    EXPECT_EQ(load(header + checked(row) + row).runs.size(), 1U);
}

TEST(RowTable, AColumnWithoutANameBeforeItsEndingIsOfNoIndex) {
    std::string names = header;
    names.replace(names.find(",row_check"), 1U, ",_threshold_100ms,");
    EXPECT_THAT(
        load(names + checked("5,car,small,turn,1,3.25,,4.5,80,0.15,0.02,2,3,0.04,,1.5,0.75,0.5,0.17,9"))
            .index_names,
        testing::ElementsAre("x"));
}

TEST(RowTable, NamesLineAndColumnOfWhatIsWrong) {
    const std::string rest = ",,,1,1,,0,0,0,0,,1,1,1";
    expect_refused(header + checked("5,car,small,turn,much" + rest + ","),
                   "runs.csv:2:18: column largest_ltr wants a number, not \"much\"");
    expect_refused(header + checked("5,car,small,turn,nan" + rest + ","), "column largest_ltr");
    expect_refused(header + checked("5,car,small,turn,1" + rest), "runs.csv:2:1: has 19 cells, not 20");
    expect_refused("run,vehicle,class,manoeuvre\n5,car,,turn\n",
                   "runs.csv:1:1: there is no column largest_ltr");
    expect_refused("", "there are no rows");
}

TEST(RowTable, RefusesARowThatIsNotAsItWasWritten) {
    const std::string row = "5,car,small,turn,1,3.25,,4.5,80,0.15,0.02,2,3,0.04,,1.5,0.75,0.5,0.17";
    const std::string good = checked(row);
    EXPECT_EQ(load(header + good).runs.size(), 1U);
    for (std::size_t place = 0U; place + 1U < good.size(); ++place) {
        std::string flipped = good;
        flipped[place] = static_cast<char>(flipped[place] ^ 1);
        EXPECT_THROW(load(header + flipped), sil::InputError) << flipped;
    }
    std::string altered = good;
    altered.replace(altered.find("0.15"), 4U, "0.25");
    expect_refused(header + altered, "runs.csv:2:71: is not the fingerprint of this row");
    expect_refused(header + good + good, "has run 5 twice");
    std::string names = header;
    names.replace(names.find(",row_check"), 10U, "");
    expect_refused(names + row + "\n", "the last column is not row_check");
}

}  // namespace
}  // namespace row_table_test
