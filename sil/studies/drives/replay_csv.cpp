#include "sil/studies/drives/replay_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "sil/units.hpp"

namespace sil {
namespace {

using Cycle = ReplayCycle;

struct NumberColumn {
    const char* name;
    double (*value)(const Cycle& cycle);
};

double number(float value) {
    return static_cast<double>(value);
}

double degrees(float radians) {
    return number(radians) * degrees_per_radian;
}

// clang-format off
constexpr NumberColumn number_columns[] = {
    {"time_s", [](const Cycle& c) { return c.sample.time_s; }},

    {"sensor_lateral_acceleration_mps2", [](const Cycle& c) { return c.sample.lateral_specific_force_mps2; }},
    {"sensor_vertical_acceleration_mps2", [](const Cycle& c) { return c.sample.vertical_specific_force_mps2; }},
    {"sensor_roll_rate_degps", [](const Cycle& c) { return c.sample.roll_rate_radps * degrees_per_radian; }},
    {"sensor_roll_angle_deg", [](const Cycle& c) { return c.sample.roll_angle_rad * degrees_per_radian; }},
    {"sensor_bank_angle_deg", [](const Cycle& c) { return c.sample.bank_angle_rad * degrees_per_radian; }},
    {"sensor_speed_mps", [](const Cycle& c) { return c.sample.speed_mps; }},
    {"sensor_yaw_rate_degps", [](const Cycle& c) { return c.sample.yaw_rate_radps * degrees_per_radian; }},
    {"sensor_steering_wheel_angle_deg", [](const Cycle& c) { return c.sample.steering_wheel_angle_rad * degrees_per_radian; }},
    {"measured_load_transfer_ratio", [](const Cycle& c) { return c.load_transfer_ratio; }},

    {"state_number", [](const Cycle& c) { return static_cast<double>(c.ecu.state); }},
    {"warning_level", [](const Cycle& c) { return c.warning_level; }},

    {"rsi", [](const Cycle& c) { return number(c.outputs.rsi); }},
    {"rsi_bank_free", [](const Cycle& c) { return number(c.outputs.rsi_bank_free); }},
    {"lateral_acceleration_mps2", [](const Cycle& c) { return number(c.outputs.lateral_acceleration_mps2); }},
    {"lateral_acceleration_threshold_mps2", [](const Cycle& c) { return number(c.outputs.lateral_acceleration_threshold_mps2); }},
    {"road_parallel_force_mps2", [](const Cycle& c) { return number(c.outputs.road_parallel_force_mps2); }},
    {"road_normal_force_mps2", [](const Cycle& c) { return number(c.outputs.road_normal_force_mps2); }},
    {"fixed_model_roll_angle_deg", [](const Cycle& c) { return degrees(c.outputs.fixed_model_roll_angle_rad); }},
    {"compensated_roll_angle_deg", [](const Cycle& c) { return degrees(c.outputs.compensated_roll_angle_rad); }},
    {"additional_roll_moment_nm", [](const Cycle& c) { return number(c.outputs.additional_roll_moment_nm); }},
    {"roll_centre_vertical_m", [](const Cycle& c) { return number(c.outputs.roll_centre_vertical_m); }},
    {"roll_centre_lateral_m", [](const Cycle& c) { return number(c.outputs.roll_centre_lateral_m); }},
    {"roll_stiffness_deviation_nmprad", [](const Cycle& c) { return number(c.outputs.roll_stiffness_deviation_nmprad); }},
    {"roll_damping_deviation_nmsprad", [](const Cycle& c) { return number(c.outputs.roll_damping_deviation_nmsprad); }},
    {"disturbance_nm", [](const Cycle& c) { return number(c.outputs.disturbance_nm); }},
    {"roll_centre_deviation_m", [](const Cycle& c) { return number(c.outputs.roll_centre_deviation_m); }},
    {"observed_roll_angle_deg", [](const Cycle& c) { return degrees(c.outputs.observed_roll_angle_rad); }},
    {"observed_bank_angle_deg", [](const Cycle& c) { return degrees(c.outputs.observed_bank_angle_rad); }},
    {"rsi_extended", [](const Cycle& c) { return number(c.outputs.rsi_extended); }},
    {"load_transfer_ratio", [](const Cycle& c) { return number(c.outputs.load_transfer_ratio); }},
    {"predicted_load_transfer_ratio", [](const Cycle& c) { return number(c.outputs.predicted_load_transfer_ratio); }},
    {"predicted_rsi", [](const Cycle& c) { return number(c.outputs.predicted_rsi); }},
    {"static_stability_level", [](const Cycle& c) { return number(c.outputs.static_stability_level); }},
    {"dynamic_stability_index", [](const Cycle& c) { return number(c.outputs.dynamic_stability_index); }},
    {"dynamic_stability_index_late", [](const Cycle& c) { return number(c.outputs.dynamic_stability_index_late); }},
    {"energy_margin", [](const Cycle& c) { return number(c.outputs.energy_margin); }},
    {"rollover_index", [](const Cycle& c) { return number(c.outputs.rollover_index); }},
    {"time_to_rollover_s", [](const Cycle& c) { return number(c.outputs.time_to_rollover_s); }},
    {"roll_source_number", [](const Cycle& c) { return static_cast<double>(c.outputs.roll_source); }},
    {"roll_sensor_disagrees", [](const Cycle& c) { return static_cast<double>(c.outputs.roll_sensor_disagrees); }},
    {"estimate_frozen", [](const Cycle& c) { return static_cast<double>(c.outputs.estimate_frozen); }},
};
// clang-format on

constexpr const char* word_columns[] = {"state", "side"};

}  // namespace

std::vector<std::string> indices_csv_columns() {
    std::vector<std::string> names;
    for (const NumberColumn& column : number_columns) {
        names.emplace_back(column.name);
    }
    names.insert(names.end(), std::begin(word_columns), std::end(word_columns));
    return names;
}

std::string indices_csv(const DriveReplay& replay) {
    std::string text;
    for (const std::string& name : indices_csv_columns()) {
        text += text.empty() ? name : "," + name;
    }
    text += '\n';
    for (const ReplayCycle& cycle : replay.cycles) {
        for (const NumberColumn& column : number_columns) {
            const double value = column.value(cycle);
            if (std::isfinite(value)) {
                fmt::format_to(std::back_inserter(text), "{:.9g}", value);
            }
            text += ',';
        }
        fmt::format_to(std::back_inserter(text), "{},{}\n", to_string(cycle.ecu.state),
                       to_string(cycle.ecu.side));
    }
    return text;
}

std::string warnings_csv(const DriveReplay& replay) {
    std::string text = "time_s,state,side\n";
    const EcuOutput* previous = nullptr;
    for (const ReplayCycle& cycle : replay.cycles) {
        if (previous == nullptr || previous->state != cycle.ecu.state || previous->side != cycle.ecu.side) {
            fmt::format_to(std::back_inserter(text), "{:.9g},{},{}\n", cycle.sample.time_s,
                           to_string(cycle.ecu.state), to_string(cycle.ecu.side));
        }
        previous = &cycle.ecu;
    }
    return text;
}

}  // namespace sil
