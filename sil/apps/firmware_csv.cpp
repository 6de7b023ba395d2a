#include "sil/apps/firmware_csv.hpp"

#include "rsi/parameters.hpp"
#include "sil/files/csv_writer.hpp"
#include "sil/files/file_io.hpp"
#include "sil/results/indices.hpp"
#include "sil/results/output_columns.hpp"
#include "sil/studies/campaign/indices.hpp"

namespace sil {
namespace {

constexpr CsvColumn<Truth> truth_columns[] = {
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

std::string firmware_csv_header() {
    CsvRow row;
    row.text("time_s");
    for (const Index& index : campaign_indices()) {
        row.text("level_" + index.name);
    }
    row.names(truth_columns);
    for (const OutputColumn& column : output_columns()) {
        row.text(column.name);
    }
    return row.line();
}

std::string lift_row(const char* what, double from_s, double to_s) {
    return CsvRow{}.text(what).number(from_s, 9).number(to_s, 9).line() + "\n";
}

}  // namespace

FirmwareCsvWriter::FirmwareCsvWriter(const std::filesystem::path& path, const rsi::Outputs& outputs,
                                     const rsi::Parameters& calibration)
    : file_{path, firmware_csv_header()}, outputs_{outputs}, indices_{calibration} {
    for (const char* name : rsi::indicator_choices) {
        index_times_s_.emplace_back(name, std::nullopt);
    }
}

void FirmwareCsvWriter::write(const Truth& truth) {
    constexpr int digits = 7;  // a float has no more
    CsvRow row;
    row.number(truth.time_s, 9);
    const IndexSample sample{outputs_, truth};
    for (std::size_t i = 0U; i < campaign_indices().size(); ++i) {
        const double level = indices_.level(i, sample);
        row.number(level, digits);
        if (i < index_times_s_.size() && level >= 1.0 && !index_times_s_[i].second) {
            index_times_s_[i].second = truth.time_s;
        }
    }
    row.numbers(truth_columns, truth, digits);
    for (const OutputColumn& column : output_columns()) {
        row.number(column.value(outputs_), digits);
    }
    file_.write(row.line());
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
            text_ += lift_row(lift_names[i], *since_s_[i], truth.time_s);
            since_s_[i].reset();
        }
    }
}

void LiftCsvWriter::close() {
    for (std::size_t i = 0U; i < kinds; ++i) {
        if (since_s_[i]) {
            text_ += lift_row(lift_names[i], *since_s_[i], latest_s_);
        }
    }
    write_file_atomically(path_, text_);
}

}  // namespace sil
