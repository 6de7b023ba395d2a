#include "sil/apps/firmware_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

#include "rsi/parameters.hpp"
#include "sil/files/whole_file.hpp"
#include "sil/results/indices.hpp"
#include "sil/results/output_columns.hpp"
#include "sil/studies/campaign/indices.hpp"

namespace sil {
namespace {

struct TruthColumn {
    const char* name;
    double (*value)(const Truth& truth);
};

constexpr TruthColumn truth_columns[] = {
    {"true_load_transfer_ratio", [](const Truth& truth) { return true_load_transfer_ratio(truth); }},
    {"true_front_load_transfer_ratio",
     [](const Truth& truth) { return true_load_transfer_ratio(truth, Axle::front); }},
    {"true_rear_load_transfer_ratio",
     [](const Truth& truth) { return true_load_transfer_ratio(truth, Axle::rear); }},
    {"true_kinematic_roll_centre_height_m",
     [](const Truth& truth) { return truth.roll_centre_kinematic_height_m; }},
};

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
    for (const TruthColumn& column : truth_columns) {
        header += std::string{","} + column.name;
    }
    for (const OutputColumn& column : output_columns()) {
        header += "," + column.name;
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
    for (const TruthColumn& column : truth_columns) {
        add(column.value(truth));
    }
    for (const OutputColumn& column : output_columns()) {
        add(column.value(outputs_));
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
