// Campaign: a row of each run, made by as many threads as wanted.
#include "sil/studies/campaign/campaign.hpp"

#include <fmt/format.h>

#include <exception>
#include <optional>
#include <stdexcept>

#include "sil/files/csv_writer.hpp"
#include "sil/files/file_io.hpp"
#include "sil/files/parameter_section_file.hpp"
#include "sil/results/indices.hpp"
#include "sil/studies/campaign/campaign_folder.hpp"
#include "sil/studies/campaign/campaign_part.hpp"
#include "sil/studies/campaign/row_file.hpp"
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
    {"road_parallel_force_mps2", [](const Moment& now) { return as_double(now.outputs.road_parallel_force_mps2); }},
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

// `traces`: their folder.
MadeRow drive_with_trace(const CampaignWorld& world, std::uint64_t number,
                         const std::filesystem::path& traces) {
    try {
        RunTrace trace;
        const CampaignRow row = world.run(number, &trace);
        trace.write(traces, row);
        return {row_line(row), row.outcome.end_time_s};
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("run {}: {}", number, error.what()));
    }
}

void refuse_rows_without_traces(const RowFile& file, const std::filesystem::path& traces) {
    for (const std::uint64_t number : file.finished_runs()) {
        if (!std::filesystem::exists(trace_file(traces, number))) {
            throw InputError(fmt::format("{}: run {} was driven without a trace; use another output folder",
                                         traces.parent_path().string(), number));
        }
    }
}

// The rows of a folder of parts are not in one file.
void refuse_parts(const std::filesystem::path& output) {
    if (!parts_of(output).empty()) {
        throw InputError(fmt::format(
            "{} holds parts of a campaign; go on with `rsi-sil campaign part`, report on them with "
            "`rsi-sil campaign report`, or use another output folder",
            output.string()));
    }
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

RowWork campaign_work(const CampaignWorld& world, std::uint64_t count, unsigned jobs) {
    RowWork work{count, jobs};
    work.make_together = [&world](const NextRow& next, const RowTaker& take) {
        world.run_together(next, [&take](const CampaignRow& row) {
            return take(row.draw.number, {row_line(row), row.outcome.end_time_s});
        });
    };
    return work;
}

RowProgress run_campaign(const CampaignWorld& world, const std::filesystem::path& output, unsigned jobs,
                         const std::atomic<bool>& stop, const RowListener& listener, bool with_traces) {
    refuse_parts(output);
    const CampaignFolder folder{output, world.settings()};
    RowFile file{folder.rows(), row_header()};
    const std::filesystem::path traces = with_traces ? output / "traces" : std::filesystem::path{};
    if (with_traces) {
        refuse_rows_without_traces(file, traces);
        make_folder(traces);
    }
    RowWork work = campaign_work(world, world.settings().runs, jobs);
    if (with_traces) {
        work = {world.settings().runs, jobs};
        work.make = [&](std::uint64_t number) { return drive_with_trace(world, number, traces); };
    }
    return make_rows(file, work, stop, listener);
}

}  // namespace sil
