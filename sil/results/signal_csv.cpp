// SignalCsvWriter: the table of columns and their formatting.
#include "sil/results/signal_csv.hpp"

#include <iterator>
#include <type_traits>

#include "sil/results/sensor_columns.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

// clang-format off
constexpr CsvColumn<Truth> truth_columns[] = {
    {"time_s", [](const Truth& truth) { return truth.time_s; }},

    {"true_steering_wheel_angle_deg", [](const Truth& truth) { return truth.steering_wheel_angle_rad * degrees_per_radian; }},
    {"true_road_wheel_angle_deg", [](const Truth& truth) { return truth.road_wheel_angle_rad * degrees_per_radian; }},
    {"true_position_x_m", [](const Truth& truth) { return truth.position_x_m; }},
    {"true_position_y_m", [](const Truth& truth) { return truth.position_y_m; }},
    {"true_position_z_m", [](const Truth& truth) { return truth.position_z_m; }},
    {"true_yaw_angle_deg", [](const Truth& truth) { return truth.yaw_angle_rad * degrees_per_radian; }},
    {"true_speed_mps", [](const Truth& truth) { return truth.speed_mps; }},
    {"true_lateral_velocity_mps", [](const Truth& truth) { return truth.lateral_velocity_mps; }},
    {"true_roll_angle_deg", [](const Truth& truth) { return truth.roll_angle_rad * degrees_per_radian; }},
    {"true_roll_to_horizon_deg", [](const Truth& truth) { return truth.roll_to_horizon_rad * degrees_per_radian; }},
    {"true_pitch_angle_deg", [](const Truth& truth) { return truth.pitch_angle_rad * degrees_per_radian; }},
    {"true_bank_angle_deg", [](const Truth& truth) { return truth.bank_angle_rad * degrees_per_radian; }},
    {"true_roll_rate_degps", [](const Truth& truth) { return truth.angular_velocity_radps[0] * degrees_per_radian; }},
    {"true_pitch_rate_degps", [](const Truth& truth) { return truth.angular_velocity_radps[1] * degrees_per_radian; }},
    {"true_yaw_rate_degps", [](const Truth& truth) { return truth.angular_velocity_radps[2] * degrees_per_radian; }},
    {"true_longitudinal_specific_force_mps2", [](const Truth& truth) { return truth.specific_force_mps2[0]; }},
    {"true_lateral_specific_force_mps2", [](const Truth& truth) { return truth.specific_force_mps2[1]; }},
    {"true_vertical_specific_force_mps2", [](const Truth& truth) { return truth.specific_force_mps2[2]; }},
    {"true_lateral_acceleration_mps2", [](const Truth& truth) { return truth.lateral_acceleration_mps2; }},
    {"true_wheel_load_front_left_n", [](const Truth& truth) { return truth.wheel_load_n[front_left]; }},
    {"true_wheel_load_front_right_n", [](const Truth& truth) { return truth.wheel_load_n[front_right]; }},
    {"true_wheel_load_rear_left_n", [](const Truth& truth) { return truth.wheel_load_n[rear_left]; }},
    {"true_wheel_load_rear_right_n", [](const Truth& truth) { return truth.wheel_load_n[rear_right]; }},
    {"true_suspension_deflection_front_left_m", [](const Truth& truth) { return truth.suspension_deflection_m[front_left]; }},
    {"true_suspension_deflection_front_right_m", [](const Truth& truth) { return truth.suspension_deflection_m[front_right]; }},
    {"true_suspension_deflection_rear_left_m", [](const Truth& truth) { return truth.suspension_deflection_m[rear_left]; }},
    {"true_suspension_deflection_rear_right_m", [](const Truth& truth) { return truth.suspension_deflection_m[rear_right]; }},
    {"true_wheel_gap_front_left_m", [](const Truth& truth) { return truth.wheel_gap_m[front_left]; }},
    {"true_wheel_gap_front_right_m", [](const Truth& truth) { return truth.wheel_gap_m[front_right]; }},
    {"true_wheel_gap_rear_left_m", [](const Truth& truth) { return truth.wheel_gap_m[rear_left]; }},
    {"true_wheel_gap_rear_right_m", [](const Truth& truth) { return truth.wheel_gap_m[rear_right]; }},
    {"true_lateral_tyre_force_n", [](const Truth& truth) { return truth.lateral_tyre_force_n; }},
    {"true_roll_centre_height_m", [](const Truth& truth) { return truth.roll_centre_height_m; }},
    {"true_roll_centre_lateral_m", [](const Truth& truth) { return truth.roll_centre_lateral_m; }},
};
// clang-format on

// Words stand last, so that the numbers before them keep their places.
constexpr const char* word_columns[] = {"ecu_state", "ecu_side"};

// Calls visitor(name of the column, value) for each signal of the ECU that carries an output of the firmware.
template <typename Visitor>
void visit_ecu_columns(const EcuOutput& output, Visitor&& visitor) {
    rsi::can_dbc::MessagesFromRolloverEcu::visit([&](auto type) {
        using Message = typename decltype(type)::Type;
        if constexpr (Message::has_sources) {
            Message::visit_sources([&](const char* field, const char*, auto member) {
                const auto value = output.of<Message>().*member;
                const char* ending = std::is_enum_v<decltype(value)> ? "_number" : "";
                visitor(std::string{"ecu_"} + field + ending, static_cast<double>(value));
            });
        }
    });
}

}  // namespace

std::vector<std::string> signal_csv_columns() {
    std::vector<std::string> names;
    for (const CsvColumn<Truth>& column : truth_columns) {
        names.emplace_back(column.name);
    }
    for (const CsvColumn<SensorSample>& column : sensor_columns) {
        names.emplace_back(column.name);
    }
    visit_ecu_columns(EcuOutput{}, [&names](const std::string& name, double) { names.push_back(name); });
    names.insert(names.end(), std::begin(word_columns), std::end(word_columns));
    return names;
}

std::string signal_csv_row(const Truth& truth, const SensorSample& sample, const EcuOutput& output) {
    constexpr int digits = 9;
    CsvRow row;
    row.numbers(truth_columns, truth, digits).numbers(sensor_columns, sample, digits);
    visit_ecu_columns(output, [&row](const std::string&, double value) { row.number(value, digits); });
    return row.text(to_string(output.state())).text(to_string(output.side())).line();
}

SignalCsvWriter::SignalCsvWriter(const std::filesystem::path& path)
    : file_{path, csv_header(signal_csv_columns())} {}

}  // namespace sil
