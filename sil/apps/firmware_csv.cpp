#include "sil/apps/firmware_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

#include "rsi/parameters.hpp"
#include "sil/files/whole_file.hpp"
#include "sil/results/indices.hpp"
#include "sil/studies/campaign/indices.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

struct Column {
    const char* name;
    double (*value)(const Truth& truth, const rsi::Outputs& outputs);
};

double number(float value) {
    return static_cast<double>(value);
}

double degrees(float radians) {
    return number(radians) * degrees_per_radian;
}

// clang-format off
constexpr Column columns[] = {
    {"true_load_transfer_ratio", [](const Truth& truth, const rsi::Outputs&) { return true_load_transfer_ratio(truth); }},
    {"true_front_load_transfer_ratio", [](const Truth& truth, const rsi::Outputs&) { return true_load_transfer_ratio(truth, Axle::front); }},
    {"true_rear_load_transfer_ratio", [](const Truth& truth, const rsi::Outputs&) { return true_load_transfer_ratio(truth, Axle::rear); }},
    {"true_kinematic_roll_centre_height_m", [](const Truth& truth, const rsi::Outputs&) { return truth.roll_centre_kinematic_height_m; }},
    {"fixed_model_roll_angle_deg", [](const Truth&, const rsi::Outputs& outputs) { return degrees(outputs.fixed_model_roll_angle_rad); }},
    {"compensated_roll_angle_deg", [](const Truth&, const rsi::Outputs& outputs) { return degrees(outputs.compensated_roll_angle_rad); }},
    {"roll_centre_vertical_m", [](const Truth&, const rsi::Outputs& outputs) { return number(outputs.roll_centre_vertical_m); }},
    {"roll_centre_lateral_m", [](const Truth&, const rsi::Outputs& outputs) { return number(outputs.roll_centre_lateral_m); }},
    {"roll_centre_deviation_m", [](const Truth&, const rsi::Outputs& outputs) { return number(outputs.roll_centre_deviation_m); }},
    {"roll_stiffness_deviation_nmprad", [](const Truth&, const rsi::Outputs& outputs) { return number(outputs.roll_stiffness_deviation_nmprad); }},
    {"roll_damping_deviation_nmsprad", [](const Truth&, const rsi::Outputs& outputs) { return number(outputs.roll_damping_deviation_nmsprad); }},
    {"disturbance_nm", [](const Truth&, const rsi::Outputs& outputs) { return number(outputs.disturbance_nm); }},
};
// clang-format on

constexpr const char* lift_names[] = {"front_left", "front_right", "rear_left",
                                      "rear_right", "left_side",   "right_side"};

}  // namespace

FirmwareCsvWriter::FirmwareCsvWriter(const std::filesystem::path& path, const rsi::Outputs& outputs,
                                     const rsi::Parameters& calibration)
    : path_{path},
      file_{path, std::ios::binary | std::ios::trunc},
      outputs_{outputs},
      calibration_{calibration} {
    if (!file_) {
        throw std::runtime_error(
            fmt::format("cannot write {}; check that the folder may be written", path_.string()));
    }
    std::string header{"time_s"};
    for (const Index& index : campaign_indices()) {
        header += ",level_" + index.name;
    }
    for (const Column& column : columns) {
        header += std::string{","} + column.name;
    }
    file_ << header << '\n';
    for (const char* name : rsi::indicator_choices) {
        index_times_s_.emplace_back(name, std::nullopt);
    }
}

void FirmwareCsvWriter::write(const Truth& truth) {
    std::string line = fmt::format("{:.9g}", truth.time_s);
    const auto add = [&line](double value) {
        line += ',';
        if (std::isfinite(value)) {
            fmt::format_to(std::back_inserter(line), "{:.7g}", value);
        }
    };
    const IndexSample sample{outputs_, truth, calibration_};
    for (std::size_t i = 0U; i < campaign_indices().size(); ++i) {
        const double level = campaign_indices()[i].level(sample);
        add(level);
        if (i < index_times_s_.size() && level >= 1.0 && !index_times_s_[i].second) {
            index_times_s_[i].second = truth.time_s;
        }
    }
    for (const Column& column : columns) {
        add(column.value(truth, outputs_));
    }
    file_ << line << '\n';
}

void FirmwareCsvWriter::close() {
    file_.close();
    if (!file_) {
        throw std::runtime_error(fmt::format("cannot finish {}: is the disk full?", path_.string()));
    }
}

void LiftCsvWriter::observe(const Truth& truth) {
    latest_s_ = truth.time_s;
    bool lifted[kinds];
    for (int wheel = 0; wheel < wheel_count; ++wheel) {
        lifted[wheel] = has_lifted(truth, static_cast<Wheel>(wheel));
    }
    lifted[4] = left_side_has_lifted(truth);
    lifted[5] = right_side_has_lifted(truth);
    for (std::size_t i = 0U; i < kinds; ++i) {
        if (lifted[i] && !since_s_[i]) {
            since_s_[i] = truth.time_s;
        } else if (!lifted[i] && since_s_[i]) {
            text_ += fmt::format("{},{:.9g},{:.9g}\n", lift_names[i], *since_s_[i], truth.time_s);
            since_s_[i].reset();
        }
    }
}

void LiftCsvWriter::close() {
    for (std::size_t i = 0U; i < kinds; ++i) {
        if (since_s_[i]) {
            text_ += fmt::format("{},{:.9g},{:.9g}\n", lift_names[i], *since_s_[i], latest_s_);
        }
    }
    write_file_atomically(path_, text_);
}

}  // namespace sil
