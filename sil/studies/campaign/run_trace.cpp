#include "sil/studies/campaign/run_trace.hpp"

#include <fmt/format.h>

#include <optional>

#include "sil/files/csv_writer.hpp"
#include "sil/files/file_io.hpp"
#include "sil/files/parameter_section_file.hpp"
#include "sil/results/indices.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

struct Moment {
    const rsi::Inputs& inputs;
    const rsi::Outputs& outputs;
    const Truth& truth;
};

double as_double(float value) {
    return static_cast<double>(value);
}

double lifted_wheels(const Truth& truth, Wheel front, Wheel rear) {
    return (has_lifted(truth, front) ? 1.0 : 0.0) + (has_lifted(truth, rear) ? 1.0 : 0.0);
}

// clang-format off
constexpr CsvColumn<Moment> trace_columns[] = {
    {"time_s", [](const Moment& now) { return now.truth.time_s; }},
    {"lateral_acceleration_mps2", [](const Moment& now) { return as_double(now.inputs.lateral_specific_force_mps2); }},
    {"vertical_acceleration_mps2", [](const Moment& now) { return as_double(now.inputs.vertical_specific_force_mps2); }},
    {"roll_rate_degps", [](const Moment& now) { return as_double(now.inputs.roll_rate_radps) * degrees_per_radian; }},
    {"roll_angle_deg", [](const Moment& now) { return as_double(now.inputs.roll_angle_rad) * degrees_per_radian; }},
    {"bank_angle_deg", [](const Moment& now) { return as_double(now.inputs.bank_angle_rad) * degrees_per_radian; }},
    {"speed_mps", [](const Moment& now) { return as_double(now.inputs.speed_mps); }},
    {"yaw_rate_degps", [](const Moment& now) { return as_double(now.inputs.yaw_rate_radps) * degrees_per_radian; }},
    {"steering_wheel_angle_deg", [](const Moment& now) { return as_double(now.inputs.steering_wheel_angle_rad) * degrees_per_radian; }},
    {"vehicle_mass_kg", [](const Moment& now) { return as_double(now.inputs.vehicle_mass_kg); }},
    {"load_transfer_ratio", [](const Moment& now) { return as_double(now.outputs.load_transfer_ratio); }},
    {"predicted_load_transfer_ratio", [](const Moment& now) { return as_double(now.outputs.predicted_load_transfer_ratio); }},
    {"opposite_load_transfer_ratio", [](const Moment& now) { return as_double(now.outputs.opposite_load_transfer_ratio); }},
    {"true_load_transfer_ratio", [](const Moment& now) { return true_load_transfer_ratio(now.truth); }},
    {"true_lifted_left", [](const Moment& now) { return lifted_wheels(now.truth, front_left, rear_left); }},
    {"true_lifted_right", [](const Moment& now) { return lifted_wheels(now.truth, front_right, rear_right); }},
};
// clang-format on

std::string lift_remark(const char* name, const std::optional<double>& time_s) {
    return time_s ? fmt::format("# {}: {:.3f}\n", name, *time_s) : fmt::format("# {}: none\n", name);
}

}  // namespace

std::filesystem::path trace_file(const std::filesystem::path& traces, std::uint64_t number) {
    return traces / fmt::format("{}.csv", number);
}

void RunTrace::begin(const InProcessRun& run, const DrawnRun& drawn) {
    run_ = &run;
    calibration_ = calibration_toml(drawn.calibration);
    lines_ = CsvRow{}.names(trace_columns).text("state").text("side").line() + "\n";
}

void RunTrace::cycle(const Truth& truth, const SensorSample&, const EcuFrames& ecu, const RunEvents&) {
    constexpr int digits = 7;  // a float has no more
    CsvRow row;
    row.numbers(trace_columns, Moment{run_->inputs(), run_->outputs(), truth}, digits);
    row.text(to_string(ecu.output().state())).text(to_string(ecu.output().side()));
    lines_ += row.line() + "\n";
}

void RunTrace::write(const std::filesystem::path& traces, const CampaignRow& row) const {
    const std::filesystem::path file = trace_file(traces, row.draw.number);
    write_file_atomically(std::filesystem::path{file}.replace_extension("toml"), calibration_);
    write_file_atomically(file, lift_remark("one_wheel_lift_time_s", row.outcome.one_wheel_lift_time_s) +
                                    lift_remark("two_wheel_lift_time_s", row.outcome.two_wheel_lift_time_s) +
                                    lines_);
}

}  // namespace sil
