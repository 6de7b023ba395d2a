// SignalCsvWriter: the table of columns and their formatting.
#include "sil/results/signal_csv.hpp"

#include <iterator>
#include <type_traits>

#include "sil/units.hpp"

namespace sil {
namespace {

struct Row {
    const Truth& truth;
    const SensorSample& sample;
};

// clang-format off
constexpr CsvColumn<Row> number_columns[] = {
    {"time_s", [](const Row& row) { return row.truth.time_s; }},

    {"true_steering_wheel_angle_deg", [](const Row& row) { return row.truth.steering_wheel_angle_rad * degrees_per_radian; }},
    {"true_road_wheel_angle_deg", [](const Row& row) { return row.truth.road_wheel_angle_rad * degrees_per_radian; }},
    {"true_position_x_m", [](const Row& row) { return row.truth.position_x_m; }},
    {"true_position_y_m", [](const Row& row) { return row.truth.position_y_m; }},
    {"true_position_z_m", [](const Row& row) { return row.truth.position_z_m; }},
    {"true_yaw_angle_deg", [](const Row& row) { return row.truth.yaw_angle_rad * degrees_per_radian; }},
    {"true_speed_mps", [](const Row& row) { return row.truth.speed_mps; }},
    {"true_lateral_velocity_mps", [](const Row& row) { return row.truth.lateral_velocity_mps; }},
    {"true_roll_angle_deg", [](const Row& row) { return row.truth.roll_angle_rad * degrees_per_radian; }},
    {"true_roll_to_horizon_deg", [](const Row& row) { return row.truth.roll_to_horizon_rad * degrees_per_radian; }},
    {"true_pitch_angle_deg", [](const Row& row) { return row.truth.pitch_angle_rad * degrees_per_radian; }},
    {"true_bank_angle_deg", [](const Row& row) { return row.truth.bank_angle_rad * degrees_per_radian; }},
    {"true_roll_rate_degps", [](const Row& row) { return row.truth.angular_velocity_radps[0] * degrees_per_radian; }},
    {"true_pitch_rate_degps", [](const Row& row) { return row.truth.angular_velocity_radps[1] * degrees_per_radian; }},
    {"true_yaw_rate_degps", [](const Row& row) { return row.truth.angular_velocity_radps[2] * degrees_per_radian; }},
    {"true_longitudinal_specific_force_mps2", [](const Row& row) { return row.truth.specific_force_mps2[0]; }},
    {"true_lateral_specific_force_mps2", [](const Row& row) { return row.truth.specific_force_mps2[1]; }},
    {"true_vertical_specific_force_mps2", [](const Row& row) { return row.truth.specific_force_mps2[2]; }},
    {"true_lateral_acceleration_mps2", [](const Row& row) { return row.truth.lateral_acceleration_mps2; }},
    {"true_wheel_load_front_left_n", [](const Row& row) { return row.truth.wheel_load_n[front_left]; }},
    {"true_wheel_load_front_right_n", [](const Row& row) { return row.truth.wheel_load_n[front_right]; }},
    {"true_wheel_load_rear_left_n", [](const Row& row) { return row.truth.wheel_load_n[rear_left]; }},
    {"true_wheel_load_rear_right_n", [](const Row& row) { return row.truth.wheel_load_n[rear_right]; }},
    {"true_suspension_deflection_front_left_m", [](const Row& row) { return row.truth.suspension_deflection_m[front_left]; }},
    {"true_suspension_deflection_front_right_m", [](const Row& row) { return row.truth.suspension_deflection_m[front_right]; }},
    {"true_suspension_deflection_rear_left_m", [](const Row& row) { return row.truth.suspension_deflection_m[rear_left]; }},
    {"true_suspension_deflection_rear_right_m", [](const Row& row) { return row.truth.suspension_deflection_m[rear_right]; }},
    {"true_wheel_gap_front_left_m", [](const Row& row) { return row.truth.wheel_gap_m[front_left]; }},
    {"true_wheel_gap_front_right_m", [](const Row& row) { return row.truth.wheel_gap_m[front_right]; }},
    {"true_wheel_gap_rear_left_m", [](const Row& row) { return row.truth.wheel_gap_m[rear_left]; }},
    {"true_wheel_gap_rear_right_m", [](const Row& row) { return row.truth.wheel_gap_m[rear_right]; }},
    {"true_lateral_tyre_force_n", [](const Row& row) { return row.truth.lateral_tyre_force_n; }},
    {"true_roll_centre_height_m", [](const Row& row) { return row.truth.roll_centre_height_m; }},
    {"true_roll_centre_lateral_m", [](const Row& row) { return row.truth.roll_centre_lateral_m; }},

    {"sensor_lateral_acceleration_mps2", [](const Row& row) { return row.sample.lateral_acceleration_mps2; }},
    {"sensor_vertical_acceleration_mps2", [](const Row& row) { return row.sample.vertical_acceleration_mps2; }},
    {"sensor_roll_rate_degps", [](const Row& row) { return row.sample.roll_rate_radps * degrees_per_radian; }},
    {"sensor_roll_angle_deg", [](const Row& row) { return row.sample.roll_angle_rad * degrees_per_radian; }},
    {"sensor_bank_angle_deg", [](const Row& row) { return row.sample.bank_angle_rad * degrees_per_radian; }},
    {"sensor_speed_mps", [](const Row& row) { return row.sample.speed_mps; }},
    {"sensor_yaw_rate_degps", [](const Row& row) { return row.sample.yaw_rate_radps * degrees_per_radian; }},
    {"sensor_steering_wheel_angle_deg", [](const Row& row) { return row.sample.steering_wheel_angle_rad * degrees_per_radian; }},
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
    for (const CsvColumn<Row>& column : number_columns) {
        names.emplace_back(column.name);
    }
    visit_ecu_columns(EcuOutput{}, [&names](const std::string& name, double) { names.push_back(name); });
    names.insert(names.end(), std::begin(word_columns), std::end(word_columns));
    return names;
}

std::string signal_csv_row(const Truth& truth, const SensorSample& sample, const EcuOutput& output) {
    constexpr int digits = 9;
    CsvRow row;
    row.numbers(number_columns, Row{truth, sample}, digits);
    visit_ecu_columns(output, [&row](const std::string&, double value) { row.number(value, digits); });
    return row.text(to_string(output.state())).text(to_string(output.side())).line();
}

SignalCsvWriter::SignalCsvWriter(const std::filesystem::path& path)
    : file_{path, csv_header(signal_csv_columns())} {}

}  // namespace sil
