// Report: groups, JSON, Markdown and the pictures' data from rows made by hand.
#include "sil/studies/campaign/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/sil/campaign/small_campaign.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using testing::HasSubstr;
using testing::Not;
using testing_campaign::HandMadeRun;
using testing_campaign::recorded;

// Two lift-offs of the bus, warned of 0.5 and 0.05 s ahead; two calm runs, one each, one with an alarm.
sil::RowTable four_runs() {
    HandMadeRun early{3.0, 1.0, 2.5, 1.4, 1.1, 2.4, "bus", "turn"};
    HandMadeRun late{4.0, 1.0, 3.95, 1.2, 0.7, 3.9, "bus", "swerve"};
    HandMadeRun calm{{}, 0.5, {}, 0.4, 0.4, {}, "bus", "turn"};
    HandMadeRun alarm{{}, 0.6, 1.0, 0.8, 0.8, {}, "car", "turn"};
    return {{"level"}, {recorded(early), recorded(late), recorded(calm), recorded(alarm)}};
}

TEST(Report, GroupsByVehicleAndManoeuvre) {
    const sil::CampaignReport report = sil::make_report(four_runs(), 4U);
    EXPECT_EQ(report.all.runs, 4U);
    EXPECT_EQ(report.all.lifted, 2U);
    EXPECT_EQ(report.all.calm, 2U);
    ASSERT_EQ(report.vehicles.size(), 2U);
    EXPECT_EQ(report.vehicles[0].name, "bus");
    EXPECT_EQ(report.vehicles[0].runs, 3U);
    EXPECT_EQ(report.vehicles[1].name, "car");
    EXPECT_EQ(report.vehicles[1].judgements[0].detection.false_alarms.count, 1U);
    ASSERT_EQ(report.manoeuvres.size(), 2U);
    EXPECT_EQ(report.manoeuvres[0].name, "swerve");
    EXPECT_EQ(report.manoeuvres[0].lifted, 1U);
    EXPECT_EQ(report.manoeuvres[1].calm, 2U);
}

TEST(Report, JsonHasCountsSharesAndLeads) {
    const auto json = nlohmann::json::parse(sil::report_json(sil::make_report(four_runs(), 4U)));
    EXPECT_EQ(json["complete"], true);
    const auto& warning = json["all"]["indices"]["warning"];
    EXPECT_EQ(warning["warned"]["count"], 2);
    EXPECT_EQ(warning["warned"]["of"], 2);
    EXPECT_EQ(warning["warned_100ms_before"]["share"], 0.5);
    EXPECT_EQ(warning["false_alarms"]["share"], 0.5);
    EXPECT_EQ(warning["lead_time_median_s"], 0.275);           // of 0.5 and 0.05
    EXPECT_EQ(warning["lead_time_10th_percentile_s"], 0.095);  // 0.05 + 0.1 (0.5 - 0.05)
    const auto& level = json["all"]["indices"]["level"];
    EXPECT_EQ(level["false_alarms"]["count"], 0);
    EXPECT_EQ(level["best"][2]["false_alarms_at_most"], 0.01);
    EXPECT_EQ(level["best"][2]["threshold"], 1.1);
    EXPECT_EQ(level["best"][2]["warned_100ms_before"]["count"], 1);
}

TEST(Report, SaysWhenTheCampaignHasNotFinished) {
    const sil::CampaignReport report = sil::make_report(four_runs(), 5U);
    EXPECT_EQ(nlohmann::json::parse(sil::report_json(report))["complete"], false);
    EXPECT_THAT(sil::report_markdown(report), HasSubstr("Not complete: 4 of 5 runs"));
    EXPECT_THAT(sil::report_markdown(sil::make_report(four_runs(), 4U)), Not(HasSubstr("Not complete")));
}

TEST(Report, OfRunsWithoutLiftOffHasNoSharesOfThem) {
    sil::RowTable table = four_runs();
    table.runs.erase(table.runs.begin(), table.runs.begin() + 2);
    const auto json = nlohmann::json::parse(sil::report_json(sil::make_report(table, 2U)));
    EXPECT_TRUE(json["all"]["indices"]["warning"]["warned"]["share"].is_null());
    EXPECT_TRUE(json["all"]["indices"]["level"]["best"][2]["threshold"].is_null());
}

TEST(Report, CurvesAndLeadsAreWrittenForThePictures) {
    const test_support::ScratchFolder folder;
    sil::write_report(sil::make_report(four_runs(), 4U), folder.path());
    const std::string curves = test_support::text_of(folder.path() / "curves.csv");
    EXPECT_THAT(curves, HasSubstr("level,1.4,0.000000,,0.500000,0.000000\n"));
    EXPECT_THAT(curves, HasSubstr("level,0.4,1.000000,,1.000000,1.000000\n"));
    const std::string leads = test_support::text_of(folder.path() / "leads.csv");
    EXPECT_THAT(leads, HasSubstr("warning,0.500,0.500000\nwarning,0.050,1.000000\nlevel,0.600,0.500000\n"));
    EXPECT_THAT(test_support::text_of(folder.path() / "report.gp"), HasSubstr("index_names = \"level\"\n"));
}

}  // namespace
