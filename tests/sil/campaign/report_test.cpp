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
    HandMadeRun early{3.0, 1.0, 0.5, 1U, 1.4, 1.1, 0.9, 0.6, "bus", "turn"};
    HandMadeRun late{4.0, 1.0, 0.05, 1U, 1.2, 0.7, 0.6, 0.1, "bus", "swerve"};
    HandMadeRun calm{{}, 0.5, {}, 0U, 0.4, 0.4, 0.4, {}, "bus", "turn"};
    HandMadeRun alarm{{}, 0.75, {}, 1U, 0.8, 0.8, 0.8, {}, "car", "turn"};
    sil::RowTable table{{"level"}, {recorded(early), recorded(late), recorded(calm), recorded(alarm)}};
    table.runs[0].brief_two_wheel_lift_time_s = 2.0;
    table.runs[1].wrong_side_s = 0.25;
    table.runs[2].unavailable_s = 0.5;
    table.runs[2].has_code = true;
    table.runs[3].brief_two_wheel_lift_time_s = 2.0;
    return table;
}

TEST(Report, GroupsByVehicleAndManoeuvre) {
    const sil::CampaignReport report = sil::make_report(four_runs(), 4U);
    EXPECT_EQ(report.all.runs, 4U);
    EXPECT_EQ(report.all.lifted, 2U);
    EXPECT_EQ(report.all.calm, 2U);
    EXPECT_THAT(report.all.bands, testing::ElementsAre(1U, 1U, 0U, 0U));
    EXPECT_EQ(report.all.vehicles, 2U);
    EXPECT_EQ(report.all.brief_lifts, 1U) << "those of lifted runs do not count";
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

TEST(Report, CountsRunsThatComeCloseAsNeitherCalmNorBrief) {
    sil::RowTable table = four_runs();
    table.runs.push_back(recorded({{}, 0.95, {}, 0U, 0.4, 0.4, 0.4}));
    const sil::CampaignReport report = sil::make_report(table, 5U);
    EXPECT_EQ(report.all.calm, 2U);
    EXPECT_THAT(report.all.bands, testing::ElementsAre(1U, 1U, 0U, 1U));
    EXPECT_EQ(report.all.brief_lifts, 1U);
}

TEST(Report, KeepsEachClassUnlessNoVehicleHasOne) {
    sil::RowTable table = four_runs();
    for (sil::RecordedCampaignRun& run : table.runs) {
        run.in_class = "heavy";
    }
    ASSERT_EQ(sil::make_report(table, 4U).classes.size(), 1U);
    EXPECT_EQ(sil::make_report(table, 4U).classes[0].name, "heavy");
    table.runs[3].in_class = "";
    ASSERT_EQ(sil::make_report(table, 4U).classes.size(), 2U);
    EXPECT_EQ(sil::make_report(table, 4U).classes[0].name, "");
    EXPECT_TRUE(sil::make_report({{"level"}, {}}, 4U).classes.empty());
}

TEST(Report, GroupsByClassWhereVehiclesHaveOne) {
    sil::RowTable table = four_runs();
    EXPECT_TRUE(sil::make_report(table, 4U).classes.empty());
    EXPECT_THAT(sil::report_markdown(sil::make_report(table, 4U)), Not(HasSubstr("by class of vehicle")));
    for (sil::RecordedCampaignRun& run : table.runs) {
        run.in_class = run.vehicle == "bus" ? "heavy" : "light";
    }
    const sil::CampaignReport report = sil::make_report(table, 4U);
    ASSERT_EQ(report.classes.size(), 2U);
    EXPECT_EQ(report.classes[0].name, "heavy");
    EXPECT_EQ(report.classes[0].lifted, 2U);
    EXPECT_EQ(report.classes[1].runs, 1U);
    EXPECT_THAT(sil::report_markdown(report), HasSubstr("by class of vehicle"));
    EXPECT_EQ(nlohmann::json::parse(sil::report_json(report))["classes"][1]["name"], "light");
}

TEST(Report, JsonHasCountsSharesAndLeads) {
    const auto json = nlohmann::json::parse(sil::report_json(sil::make_report(four_runs(), 4U)));
    EXPECT_EQ(json["complete"], true);
    const auto& warning = json["all"]["indices"]["warning"];
    EXPECT_EQ(warning["warned"]["count"], 2);
    EXPECT_EQ(warning["warned"]["of"], 2);
    EXPECT_EQ(warning["warned_100ms_before"]["share"], 0.5);
    EXPECT_EQ(warning["false_alarms"]["share"], 0.5);
    EXPECT_EQ(warning["warned_200ms_before"]["share"], 0.5);
    EXPECT_EQ(warning["alarms"]["below 0.7"]["share"], 0.0);
    EXPECT_EQ(warning["alarms"]["0.7 to 0.8"]["share"], 1.0);
    EXPECT_TRUE(warning["alarms"]["0.8 to 0.9"]["share"].is_null());
    EXPECT_EQ(warning["lead_time_median_s"], 0.275);           // of 0.5 and 0.05
    EXPECT_EQ(warning["lead_time_10th_percentile_s"], 0.095);  // 0.05 + 0.1 (0.5 - 0.05)
    EXPECT_EQ(json["confidence"], "by run");
    EXPECT_EQ(json["all"]["wrong_side_s"], 0.25);
    EXPECT_EQ(json["all"]["wrong_side_s_per_1000_runs"], 62.5);
    EXPECT_EQ(json["all"]["unavailable_s"], 0.5);
    EXPECT_EQ(json["all"]["unavailable_s_per_1000_runs"], 125.0);
    EXPECT_EQ(json["all"]["runs_with_diagnostic_code"], 1);
    EXPECT_TRUE(json["ordinary_driving"].is_null());
    const auto& level = json["all"]["indices"]["level"];
    EXPECT_EQ(level["false_alarms"]["count"], 0);
    EXPECT_EQ(level["best"][2]["false_alarms_at_most"], 0.01);
    EXPECT_EQ(level["best"][2]["threshold"], 0.9);
    EXPECT_EQ(level["best"][2]["warned"]["count"], 2);
    EXPECT_EQ(level["best"][2]["warned_100ms_before"]["count"], 1);
    EXPECT_EQ(level["best"][2]["warned_200ms_before"]["count"], 1);
}

// Ten vehicles: their runs are no longer taken for independent.
TEST(Report, OfManyVehiclesCountsVehicles) {
    sil::RowTable table = four_runs();
    for (std::uint64_t vehicle = 0U; vehicle < 8U; ++vehicle) {
        table.runs.push_back(recorded({3.0, 1.0, 0.5, 1U, 1.4, 1.1, 0.9, 0.6, std::to_string(vehicle)}));
    }
    const sil::CampaignReport report = sil::make_report(table, 12U);
    const auto json = nlohmann::json::parse(sil::report_json(report));
    EXPECT_EQ(json["confidence"], "by vehicle");
    EXPECT_THAT(sil::report_markdown(report), HasSubstr("counting vehicles"));
    EXPECT_THAT(sil::report_markdown(sil::make_report(four_runs(), 4U)), HasSubstr("independent"));
}

TEST(Report, OfVeryManyVehiclesShowsTheWorst) {
    sil::RowTable table = four_runs();
    for (int vehicle = 0; vehicle < 29; ++vehicle) {
        table.runs.push_back(
            recorded({3.0, 1.0, 0.5, 1U, 1.4, 1.1, 0.9, 0.6, "v" + std::to_string(vehicle)}));
    }
    const std::string text = sil::report_markdown(sil::make_report(table, 33U));
    EXPECT_THAT(text, HasSubstr("the worst 30 of 31"));
    EXPECT_LT(text.find("| bus |"), text.find("| v0 |")) << "the fewest warned of 0.1 s before stand first";
    EXPECT_EQ(text.find("| car |"), std::string::npos) << "without a lift-off it is not among them";
}

TEST(Report, OrdinaryDrivingCountsByHourAndKilometreAlone) {
    sil::RowTable table = four_runs();
    for (int drive = 0; drive < 2; ++drive) {
        sil::RecordedCampaignRun run =
            recorded({{}, 0.3, {}, 1U, 0.4, 0.4, 0.4, {}, "van", "ordinary-driving"});
        run.end_time_s = 1800.0;
        run.distance_m = 25'000.0;
        run.advisories = 2U;
        run.unavailable_s = 1.5;
        run.has_code = drive == 1;
        table.runs.push_back(run);
    }
    const sil::CampaignReport report = sil::make_report(table, 6U);
    EXPECT_TRUE(report.complete());
    EXPECT_EQ(report.all.runs, 4U);
    EXPECT_EQ(report.vehicles.size(), 2U);
    const auto json = nlohmann::json::parse(sil::report_json(report))["ordinary_driving"];
    EXPECT_EQ(json["hours"], 1.0);
    EXPECT_EQ(json["kilometres"], 50.0);
    EXPECT_EQ(json["alarms"], 2.0);
    EXPECT_EQ(json["alarms_per_hour"], 2.0);
    EXPECT_EQ(json["alarms_per_1000_km"], 40.0);
    EXPECT_EQ(json["advisories_per_hour"], 4.0);
    EXPECT_EQ(json["unavailable_s_per_1000_km"], 60.0);
    EXPECT_EQ(json["runs_with_diagnostic_code"], 1);
    EXPECT_THAT(sil::report_markdown(report),
                HasSubstr("| drives with a diagnostic code | 1 | 1.000 | 20.000 |\n"));
    EXPECT_THAT(sil::report_markdown(report), HasSubstr("| alarms | 2 | 2.000 | 40.000 |\n"));
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
    EXPECT_THAT(curves, HasSubstr("level,1.4,0.000000,0.000000,0.000000,,,0.500000,0.000000,0.000000\n"));
    EXPECT_THAT(curves, HasSubstr("level,0.4,1.000000,1.000000,1.000000,,,1.000000,1.000000,1.000000\n"));
    const std::string leads = test_support::text_of(folder.path() / "leads.csv");
    EXPECT_THAT(leads, HasSubstr("warning,0.500,0.500000\nwarning,0.050,1.000000\nlevel,0.600,0.500000\n"));
    EXPECT_THAT(test_support::text_of(folder.path() / "report.gp"), HasSubstr("index_names = \"level\"\n"));
}

}  // namespace
