// A row of a campaign: every value stands under its own name, in its unit.
#include "sil/studies/campaign/row.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sil/files/csv_reader.hpp"
#include "sil/results/diagnostic_codes.hpp"
#include "sil/studies/campaign/indices.hpp"

namespace row_test {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<sil::CsvField> fields;
    sil::split_fields(line, fields);
    std::vector<std::string> cells;
    for (const sil::CsvField& field : fields) {
        cells.emplace_back(field.text);
    }
    return cells;
}

std::map<std::string, std::string> named_cells(const sil::CampaignRow& row) {
    const std::vector<std::string> names = cells_of(sil::row_header());
    const std::vector<std::string> cells = cells_of(sil::row_line(row));
    EXPECT_EQ(names.size(), cells.size());
    std::map<std::string, std::string> named;
    for (std::size_t i = 0U; i < names.size(); ++i) {
        EXPECT_TRUE(named.emplace(names[i], cells.at(i)).second) << names[i] << " twice";
    }
    return named;
}

using Named = std::map<std::string, std::string>;

void expect_cells(const Named& cells, const Named& expected) {
    for (const auto& [name, value] : expected) {
        ASSERT_EQ(cells.count(name), 1U) << name;
        EXPECT_EQ(cells.at(name), value) << name;
    }
}

sil::CampaignRow row() {
    sil::CampaignRow row;
    row.draw.number = 7U;
    row.draw.mirrored = true;
    row.draw.speed_factor = 1.1;
    row.draw.steering_factor = 1.2;
    row.draw.friction_factor = 0.9;
    row.draw.load_share = 0.3;
    row.draw.load_height_factor = 1.4;
    row.draw.cg_height_error = 0.01;
    row.draw.stiffness_error = -0.02;
    row.draw.mass_error = 0.03;
    row.draw.mass_sensor_error = 0.04;
    row.draw.lateral_bias_g = 0.005;
    row.draw.vertical_bias_g = -0.006;
    row.draw.sensor_seed = 99U;
    row.vehicle = "van";
    row.in_class = "heavy";
    row.manoeuvre = "turn";
    row.speed_kmh = 87.123456789;
    row.outcome.one_wheel_lift_time_s = 1.0;
    row.outcome.two_wheel_lift_time_s = 1.25;
    row.outcome.brief_two_wheel_lift_time_s = 1.125;
    row.outcome.largest_ltr = 1.0;
    row.outcome.largest_ltr_before_lift = 0.875;
    row.outcome.largest_lateral_acceleration_mps2 = 0.75 * 9.80665;
    row.outcome.largest_roll_angle_rad = 0.5;
    row.outcome.rolled_over = true;
    row.outcome.end_time_s = 4.5;
    row.outcome.distance_m = 80.5;
    row.warning_time_s = 1.1;
    row.judgement.falling_side = sil::WarningSide::right;
    row.judgement.side_at_lift_off = sil::WarningSide::left;
    row.judgement.lead_s = 0.15;
    row.judgement.wrong_side_s = 0.02;
    row.judgement.warnings = 2U;
    row.judgement.advisories = 3U;
    row.judgement.warning_s = 0.5;
    row.judgement.advisory_s = 0.6;
    row.judgement.unavailable_s = 0.04;
    row.codes = std::uint64_t{0b110U};
    row.interventions = 4U;
    row.intervention_s = 0.7;
    row.indices = {{1.5, 0.75, 0.5, 0.17}};
    return row;
}

TEST(CampaignRow, HasEveryValueUnderItsName) {
    const Named cells = named_cells(row());
    expect_cells(cells, {{"run", "7"},
                         {"vehicle", "van"},
                         {"class", "heavy"},
                         {"manoeuvre", "turn"},
                         {"mirrored", "1"},
                         {"speed_kmh", "87.1234568"},
                         {"speed_factor", "1.1"},
                         {"steering_factor", "1.2"},
                         {"friction_factor", "0.9"},
                         {"load_share", "0.3"},
                         {"load_height_factor", "1.4"},
                         {"cg_height_error", "0.01"},
                         {"stiffness_error", "-0.02"},
                         {"mass_error", "0.03"},
                         {"mass_sensor_error", "0.04"},
                         {"lateral_bias_g", "0.005"},
                         {"vertical_bias_g", "-0.006"},
                         {"sensor_seed", "99"}});
    expect_cells(cells, {{"one_wheel_lift_time_s", "1.000"},
                         {"two_wheel_lift_time_s", "1.250"},
                         {"brief_two_wheel_lift_time_s", "1.125"},
                         {"largest_ltr", "1"},
                         {"largest_ltr_before_lift", "0.875"},
                         {"largest_ay_g", "0.75"},
                         {"largest_roll_deg", "28.6478898"},
                         {"rolled_over", "1"},
                         {"end_time_s", "4.500"},
                         {"distance_m", "80.5"}});
    expect_cells(cells, {{"warning_time_s", "1.100"},
                         {"falling_side", "right"},
                         {"side_at_lift_off", "left"},
                         {"lead_time_s", "0.150"},
                         {"wrong_side_duration_s", "0.020"},
                         {"warnings", "2"},
                         {"advisories", "3"},
                         {"warning_duration_s", "0.500"},
                         {"advisory_duration_s", "0.600"},
                         {"unavailable_duration_s", "0.040"},
                         {"diagnostic_codes", sil::code_names(0b110U)},
                         {"interventions", "4"},
                         {"intervention_duration_s", "0.700"}});
    const std::string first = sil::campaign_indices().front().name;
    expect_cells(cells, {{first + "_threshold", "1.5"},
                         {first + "_threshold_100ms", "0.75"},
                         {first + "_threshold_200ms", "0.5"},
                         {first + "_lead_time_s", "0.170"}});
}

TEST(CampaignRow, OfNothingHasEmptyTimesAndSides) {
    const Named cells = named_cells({});
    for (const char* name :
         {"one_wheel_lift_time_s", "two_wheel_lift_time_s", "brief_two_wheel_lift_time_s", "warning_time_s",
          "falling_side", "side_at_lift_off", "lead_time_s", "diagnostic_codes"}) {
        expect_cells(cells, {{name, ""}});
    }
    expect_cells(cells, {{"mirrored", "0"},
                         {"rolled_over", "0"},
                         {"speed_kmh", "0"},
                         {"largest_ay_g", "0"},
                         {"largest_ltr_before_lift", "0"},
                         {"largest_roll_deg", "0"}});
    for (const sil::Index& index : sil::campaign_indices()) {
        expect_cells(cells, {{index.name + "_threshold", "0"},
                             {index.name + "_threshold_100ms", "0"},
                             {index.name + "_threshold_200ms", "0"},
                             {index.name + "_lead_time_s", ""}});
    }
}

// A unit at the end of a name is that of the column; every column says what it means.
TEST(CampaignRow, TellsUnitAndMeaningOfEveryColumn) {
    const std::map<std::string, std::string> endings{
        {"_s", "s"}, {"_m", "m"}, {"_g", "g"}, {"_deg", "deg"}, {"_kmh", "km/h"}};
    for (const sil::RowColumn& column : sil::row_columns()) {
        EXPECT_GT(column.meaning.size(), 5U) << column.name;
        const std::size_t last = column.name.rfind('_');
        const auto ending =
            last == std::string::npos ? endings.end() : endings.find(column.name.substr(last));
        EXPECT_EQ(column.unit, ending == endings.end() ? "" : ending->second) << column.name;
    }
    const auto json = nlohmann::json::parse(sil::row_columns_json());
    ASSERT_EQ(json.size(), sil::row_columns().size());
    EXPECT_EQ(json[0]["name"], "run");
    EXPECT_EQ(json[0]["kind"], "count");
    EXPECT_EQ(json[5]["name"], "speed_kmh");
    EXPECT_EQ(json[5]["kind"], "number");
    EXPECT_EQ(json[5]["unit"], "km/h");
    EXPECT_EQ(json[5]["meaning"], "speed at the beginning, drawn");
}

TEST(CampaignRow, HasColumnsOfTheTrueLoadTransferToo) {
    EXPECT_EQ(named_cells(row()).count("true_load_transfer_threshold"), 1U);
}

}  // namespace
}  // namespace row_test
