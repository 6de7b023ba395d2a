// Firmware CSV: what the firmware computed in every cycle of a run in process, whether or not a frame carries
// it, beside what only the simulation knows.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rsi/types.hpp"
#include "sil/files/csv_writer.hpp"
#include "sil/studies/campaign/indices.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

// Columns: time_s; level_NAME of every index of a campaign (1 where it says "warn"); LTR (26) of the true
// wheel loads of both axles, of the front and of the rear one; the kinematic roll centre's height; every
// number of rsi_outputs, angles in degrees. A value that is not available is an empty cell.
class FirmwareCsvWriter {
 public:
    // `outputs` must outlive the writer. Throws std::runtime_error when the file cannot be written.
    FirmwareCsvWriter(const std::filesystem::path& path, const rsi::Outputs& outputs,
                      const rsi::Parameters& calibration);

    // After each cycle.
    void write(const Truth& truth);

    void close() { file_.close(); }

    // When each index of the firmware was first at level 1, by name.
    const std::vector<std::pair<std::string, std::optional<double>>>& index_times_s() const {
        return index_times_s_;
    }

 private:
    CsvFile file_;
    const rsi::Outputs& outputs_;
    IndexReaders indices_;
    std::vector<std::pair<std::string, std::optional<double>>> index_times_s_{};
};

// Wheel lifts: every stretch of time during which a wheel, or both wheels of a side, carry no load, to the
// millisecond. Columns: what (front_left, ..., left_side, right_side), from_s, to_s; to_s is the run's end
// for what has not come down.
class LiftCsvWriter {
 public:
    explicit LiftCsvWriter(std::filesystem::path path) : path_{std::move(path)} {}

    // At every step of the vehicle.
    void observe(const Truth& truth);

    // Throws std::runtime_error when the file cannot be written.
    void close();

 private:
    static constexpr std::size_t kinds = 6U;  // four wheels, two sides

    std::filesystem::path path_;
    std::string text_{"what,from_s,to_s\n"};
    double latest_s_{0.0};
    std::optional<double> since_s_[kinds]{};
};

}  // namespace sil
