// Page recording: rows as signals.csv has them, a long run thinned out, changes of the diagnosis, and a page
// that no name can break out of.
#include "sil/page/page_recording.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "sil/page/page_text.hpp"
#include "sil/page/summary_facts.hpp"
#include "sil/results/signal_csv.hpp"

namespace page_recording_test {
namespace {

using nlohmann::json;

std::string csv_row(double time_s) {
    sil::Truth truth;
    truth.time_s = time_s;
    truth.roll_angle_rad = 0.1;
    sil::EcuOutput output;
    output.warning().state = sil::WarningState::warning;
    output.warning().side = sil::WarningSide::left;
    return sil::signal_csv_row(truth, {}, output);
}

json recorded(std::size_t cycles) {
    sil::PageRecording recording;
    for (std::size_t cycle = 0U; cycle < cycles; ++cycle) {
        recording.cycle(csv_row(0.01 * static_cast<double>(cycle)), {}, 0.01 * static_cast<double>(cycle));
    }
    return json::parse(recording.json({}, {}));
}

TEST(PageRow, HasTheCellsOfItsColumns) {
    const json row = json::parse(sil::page_row(csv_row(1.25)));
    ASSERT_EQ(row.size(), sil::page_columns().size());
    for (std::size_t place = 0U; place < row.size(); ++place) {
        const std::string& column = sil::page_columns()[place];
        if (column == "time_s") {
            EXPECT_EQ(row[place], 1.25);
        } else if (column == "true_roll_angle_deg") {
            EXPECT_EQ(row[place], 5.72957795);
        } else if (column == "ecu_state") {
            EXPECT_EQ(row[place], "warning");
        } else if (column == "ecu_side") {
            EXPECT_EQ(row[place], "left");
        } else if (column == "ecu_warning_level" || column == "sensor_roll_angle_deg") {
            EXPECT_TRUE(row[place].is_null()) << column;
        }
    }
}

TEST(PageRecording, KeepsEveryRowOfAnOrdinaryRun) {
    const json recording = recorded(2U * sil::PageRecording::longest_rows);
    EXPECT_EQ(recording["every"], 1);
    ASSERT_EQ(recording["rows"].size(), 2U * sil::PageRecording::longest_rows);
    EXPECT_EQ(recording["rows"][7][0], 0.07);
}

TEST(PageRecording, ThinsOutALongerOneEvenly) {
    const json recording = recorded(2U * sil::PageRecording::longest_rows + 3U);
    EXPECT_EQ(recording["every"], 2);
    ASSERT_EQ(recording["rows"].size(), sil::PageRecording::longest_rows + 2U);
    for (std::size_t row = 0U; row < recording["rows"].size(); ++row) {
        EXPECT_NEAR(recording["rows"][row][0].get<double>(), 0.02 * static_cast<double>(row), 1e-6);
    }
}

TEST(PageRecording, TellsOfTheMomentsThatWere) {
    sil::RunEvents events;
    events.warning = sil::EventMoment{1.5, 9.80665, 0.1};
    events.judgement.lead_s = 0.504;
    events.judgement.falling_side = sil::WarningSide::right;
    const json recording = json::parse(sil::PageRecording{}.json({"a", "b", {}, {{"c", "d"}}}, events));
    EXPECT_EQ(recording["title"], "a");
    EXPECT_EQ(recording["subtitle"], "b");
    EXPECT_EQ(recording["facts"][0][1], "d");
    EXPECT_EQ(recording["events"].size(), 1U);
    EXPECT_EQ(recording["events"]["warning"]["time_s"], 1.5);
    EXPECT_EQ(recording["events"]["warning"]["ay_g"], 1.0);
    EXPECT_NEAR(recording["events"]["warning"]["roll_deg"].get<double>(), 5.729577951, 1e-9);
    EXPECT_EQ(recording["judgement"]["lead_time_s"], 0.504);
    EXPECT_EQ(recording["judgement"]["falling_side"], "right");
    EXPECT_TRUE(recording["rows"].empty());
}

TEST(DiagnosisWatch, TellsTheFirstAndEachChange) {
    using Diagnosis = rsi::can_dbc::RolloverDiagnosis;
    sil::DiagnosisWatch watch;
    Diagnosis diagnosis;
    diagnosis.degradation = Diagnosis::Degradation::full;
    EXPECT_TRUE(watch.observe(0.0, diagnosis));
    EXPECT_FALSE(watch.observe(0.01, diagnosis));
    diagnosis.code = Diagnosis::Code::speed_stuck;
    diagnosis.code_status = Diagnosis::CodeStatus::set;
    EXPECT_TRUE(watch.observe(0.02, diagnosis));
    EXPECT_FALSE(watch.observe(0.03, diagnosis));
    EXPECT_EQ(sil::code_names(watch.latest().codes.set), "speed stuck");
    EXPECT_EQ(watch.latest().codes.confirmed, 0U);
    EXPECT_EQ(watch.latest().time_s, 0.02);
    diagnosis.code_status = Diagnosis::CodeStatus::confirmed;
    EXPECT_TRUE(watch.observe(0.04, diagnosis));
    EXPECT_EQ(sil::list_of_codes(watch.latest().codes.confirmed), std::vector<std::string>{"speed stuck"});
    diagnosis.degradation = Diagnosis::Degradation::motion_lost;
    EXPECT_TRUE(watch.observe(0.05, diagnosis));
}

TEST(PageText, HoldsARecordingThatCannotEndItsElement) {
    const std::string page = sil::page_with(R"({"title":"</script><b>"})");
    EXPECT_NE(page.find(R"(>{"title":"\u003c/script>\u003cb>"}</script>)"), std::string::npos);
    EXPECT_EQ(page.find("</script><b>"), std::string::npos);
    EXPECT_EQ(page.rfind("</html>\n"), page.size() - 8U);
}

TEST(PageText, GivesBackTheRecordingThatIsInAPage) {
    const std::string recording = R"({"title":"</script><b>"})";
    EXPECT_EQ(json::parse(sil::recording_in(sil::page_with(recording))), json::parse(recording));
    EXPECT_EQ(sil::recording_in(std::string{sil::live_page}), "");
    EXPECT_EQ(sil::recording_in(sil::study_with(recording)), "");
    EXPECT_EQ(sil::recording_in(""), "");
    EXPECT_EQ(sil::recording_in(R"(<script id="recording" type="application/json">{"cut)"), "");
}

TEST(PageCells, RefuseAColumnThatIsNotThere) {
    const sil::PageCells cells{{"a", "state", "b"}, {"b", "state"}};
    EXPECT_EQ(cells.row("1,ready,-2.5e-05"), R"([-2.5e-05,"ready"])");
    EXPECT_EQ(cells.row("1,,"), "[null,null]");
    EXPECT_THROW((sil::PageCells{{"a"}, {"b"}}), std::logic_error);
}

TEST(PageVehicle, HasTheShapeOfTheParameters) {
    sil::VehicleParameters parameters;
    parameters.geometry.track_width_m = 1.6;
    parameters.geometry.cg_height_m = 1.0;
    parameters.geometry.wheel_radius_m = 0.4;
    parameters.hull.half_width_m = 0.9;
    parameters.hull.top_above_cg_m = 0.8;
    parameters.hull.bottom_below_cg_m = 0.7;
    parameters.mass.sprung_kg = 2000.0;
    const sil::PageVehicle vehicle = sil::page_vehicle(parameters);
    EXPECT_EQ(vehicle.track_width_m, 1.6);
    EXPECT_EQ(vehicle.cg_height_m, 1.0);
    EXPECT_EQ(vehicle.wheel_radius_m, 0.4);
    EXPECT_EQ(vehicle.half_width_m, 0.9);
    EXPECT_EQ(vehicle.top_above_cg_m, 0.8);
    EXPECT_EQ(vehicle.bottom_below_cg_m, 0.7);
    EXPECT_EQ(vehicle.mass_kg, 2000.0);
    EXPECT_EQ(vehicle.static_stability_factor, 0.8);
}

TEST(SummaryFacts, SayWhatHappenedAndWhatDidNot) {
    sil::Summary summary;
    summary.noise = "noise";
    summary.seed = 7U;
    summary.events.warning = sil::EventMoment{1.5, -0.5 * 9.80665, 0.0};
    const auto facts = sil::summary_facts(summary);
    const auto value = [&](const std::string& name) {
        for (const auto& [each, text] : facts) {
            if (each == name) {
                return text;
            }
        }
        return std::string{"missing"};
    };
    EXPECT_EQ(value("First warning"), "1.500 s, -0.500 g");
    EXPECT_EQ(value("Two-wheel lift-off"), "did not happen");
    EXPECT_EQ(value("Lead time"), "none");
    EXPECT_EQ(value("Sensors"), "with noise, seed 7");
}

}  // namespace
}  // namespace page_recording_test
