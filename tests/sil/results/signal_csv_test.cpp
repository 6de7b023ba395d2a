// Signal CSV: header, units, round trip of every number, and fields that are not available.
#include "sil/results/signal_csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "tests/support/full_disk.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using test_support::ScratchFolder;
using test_support::text_of;

constexpr double deg_per_rad = 180.0 / 3.14159265358979323846;

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields(1U);
    for (const char character : line) {
        if (character == ',') {
            fields.emplace_back();
        } else {
            fields.back() += character;
        }
    }
    return fields;
}

std::string field(const std::string& row, const std::string& column) {
    const std::vector<std::string> names = sil::signal_csv_columns();
    const auto place = std::find(names.begin(), names.end(), column);
    EXPECT_NE(place, names.end()) << column;
    return fields_of(row).at(static_cast<std::size_t>(place - names.begin()));
}

// The words, and the columns of the signals that have no unit in the DBC file.
std::set<std::string> columns_without_unit() {
    std::set<std::string> names{"ecu_state", "ecu_side"};
    rsi::can_dbc::MessagesFromRolloverEcu::visit([&names](auto type) {
        using Message = typename decltype(type)::Type;
        if constexpr (Message::has_sources) {
            Message::visit_sources([&names](const char* field, const char*, auto member) {
                using Member = decltype(member);
                using Value = std::decay_t<decltype(Message{}.*member)>;
                const std::string name =
                    std::string{"ecu_"} + field + (std::is_enum_v<Value> ? "_number" : "");
                Message::visit_signals([&](const char*, const char* unit, auto other, auto) {
                    if constexpr (std::is_same_v<Member, decltype(other)>) {
                        if (member == other && std::string{unit} == "-") {
                            names.insert(name);
                        }
                    }
                });
            });
        }
    });
    return names;
}

TEST(SignalCsv, EveryColumnHasANameOfItsOwnAndAUnitOrNeedsNone) {
    const std::set<std::string> units{"s", "m", "mps", "mps2", "deg", "degps", "n", "nmprad", "nmsprad"};
    const std::set<std::string> without_unit = columns_without_unit();
    const std::vector<std::string> names = sil::signal_csv_columns();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    EXPECT_EQ(names.front(), "time_s");
    for (const std::string& name : names) {
        const std::string last_word = name.substr(name.rfind('_') + 1U);
        EXPECT_TRUE(units.count(last_word) == 1U || without_unit.count(name) == 1U) << name;
    }
}

TEST(SignalCsv, ARowHasAFieldForEveryColumn) {
    EXPECT_EQ(fields_of(sil::signal_csv_row({}, {}, {})).size(), sil::signal_csv_columns().size());
}

TEST(SignalCsv, AMissingValueIsAnEmptyField) {
    const std::string row = sil::signal_csv_row({}, {}, {});
    EXPECT_EQ(field(row, "sensor_lateral_acceleration_mps2"), "");
    EXPECT_EQ(field(row, "ecu_warning_level"), "");
    EXPECT_EQ(field(row, "ecu_state"), "unavailable");
    EXPECT_EQ(field(row, "ecu_side"), "none");
    EXPECT_EQ(row.find("nan"), std::string::npos);
}

TEST(SignalCsv, NumbersKeepNineSignificantDigits) {
    for (const double value : {0.1, 1.0 / 3.0, -1e-300, 6.02214076e23, 2.0 / 7.0 * 1e7}) {
        sil::Truth truth;
        truth.lateral_acceleration_mps2 = value;
        const std::string text = field(sil::signal_csv_row(truth, {}, {}), "true_lateral_acceleration_mps2");
        EXPECT_NEAR(std::strtod(text.c_str(), nullptr), value, std::abs(value) * 5e-9) << text;
    }
}

TEST(SignalCsv, NumbersHaveNoMoreThanNineSignificantDigits) {
    sil::Truth truth;
    truth.lateral_acceleration_mps2 = 2.0 / 3.0;
    EXPECT_EQ(field(sil::signal_csv_row(truth, {}, {}), "true_lateral_acceleration_mps2"), "0.666666667");
}

// 303 cycles of 10 ms add up to 3.0299999999999773 s.
TEST(SignalCsv, RoundingOfSumsIsNotShown) {
    sil::Truth truth;
    truth.time_s = 3.0299999999999773;
    EXPECT_EQ(field(sil::signal_csv_row(truth, {}, {}), "time_s"), "3.03");
}

TEST(SignalCsv, EveryValueStandsInItsOwnColumn) {
    sil::Truth truth;
    truth.steering_wheel_angle_rad = 1.0 / deg_per_rad;
    truth.angular_velocity_radps = {2.0 / deg_per_rad, 3.0 / deg_per_rad, 4.0 / deg_per_rad};
    truth.wheel_load_n = {11.0, 12.0, 13.0, 14.0};
    truth.roll_angle_rad = 5.0 / deg_per_rad;
    sil::SensorSample sample;
    sample.roll_angle_rad = 6.0 / deg_per_rad;
    sample.speed_mps = 7.0;
    sil::EcuOutput output;
    output.warning().state = sil::WarningState::warning;
    output.warning().side = sil::WarningSide::right;
    output.warning().warning_level = 0.75F;
    output.warning().lateral_acceleration_threshold_mps2 = 8.0F;
    output.of<rsi::can_dbc::RollCentreEstimate>().roll_centre_vertical_m = -0.0625F;
    const std::string row = sil::signal_csv_row(truth, sample, output);
    const auto number = [&row](const char* column) {
        return std::strtod(field(row, column).c_str(), nullptr);
    };
    EXPECT_DOUBLE_EQ(number("true_steering_wheel_angle_deg"), 1.0);
    EXPECT_DOUBLE_EQ(number("true_roll_rate_degps"), 2.0);
    EXPECT_DOUBLE_EQ(number("true_pitch_rate_degps"), 3.0);
    EXPECT_DOUBLE_EQ(number("true_yaw_rate_degps"), 4.0);
    EXPECT_EQ(number("true_wheel_load_front_left_n"), 11.0);
    EXPECT_EQ(number("true_wheel_load_front_right_n"), 12.0);
    EXPECT_EQ(number("true_wheel_load_rear_left_n"), 13.0);
    EXPECT_EQ(number("true_wheel_load_rear_right_n"), 14.0);
    EXPECT_DOUBLE_EQ(number("true_roll_angle_deg"), 5.0);
    EXPECT_DOUBLE_EQ(number("sensor_roll_angle_deg"), 6.0);
    EXPECT_EQ(number("sensor_speed_mps"), 7.0);
    EXPECT_EQ(number("ecu_state_number"), 3.0);
    EXPECT_EQ(number("ecu_warning_level"), 0.75);
    EXPECT_EQ(number("ecu_lateral_acceleration_threshold_mps2"), 8.0);
    EXPECT_EQ(number("ecu_roll_centre_vertical_m"), -0.0625);
    EXPECT_EQ(field(row, "ecu_state"), "warning");
    EXPECT_EQ(field(row, "ecu_side"), "right");
}

TEST(SignalCsvWriter, WritesTheHeaderAndThenTheRows) {
    const ScratchFolder folder;
    sil::SignalCsvWriter writer(folder.path() / "signals.csv");
    sil::Truth truth;
    writer.write(sil::signal_csv_row(truth, {}, {}));
    truth.time_s = 0.01;
    writer.write(sil::signal_csv_row(truth, {}, {}));
    writer.close();
    std::istringstream file(text_of(folder.path() / "signals.csv"));
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(fields_of(line), sil::signal_csv_columns());
    std::getline(file, line);
    EXPECT_EQ(field(line, "time_s"), "0");
    std::getline(file, line);
    EXPECT_EQ(field(line, "time_s"), "0.01");
    EXPECT_FALSE(std::getline(file, line));
}

TEST(SignalCsvWriter, AFileThatCannotBeWrittenIsNamed) {
    const ScratchFolder folder;
    const std::string path = (folder.path() / "nowhere" / "signals.csv").string();
    try {
        const sil::SignalCsvWriter writer(path);
        FAIL() << "no error";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
    }
}

TEST(SignalCsvWriter, AFullDiskIsAnError) {
    const ScratchFolder folder;
    const test_support::FullDisk full{100U};
    sil::SignalCsvWriter writer(folder.path() / "signals.csv");
    writer.write(sil::signal_csv_row({}, {}, {}));
    EXPECT_THROW(writer.close(), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "signals.csv"));
}

}  // namespace
