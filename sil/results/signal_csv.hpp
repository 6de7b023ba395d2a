// SignalCsvWriter: all signals of a run as comma-separated values, one row per bus cycle.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sil/files/csv_writer.hpp"
#include "sil/results/ecu_output.hpp"
#include "sil/world/sensors/sensor_sample.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

// Names of the columns, in their order: ORIGIN_quantity_UNIT, ORIGIN being true, sensor or ecu. Units are s,
// m, mps, mps2, deg, degps, n, nmprad (N m/rad), nmsprad (N m s/rad); a name without a unit is a ratio or a
// word. Angles are in degrees because people read them, everything else is SI.
std::vector<std::string> signal_csv_columns();

// One line without its end. Numbers have up to nine significant digits, more than any sensor: further ones
// would only be the rounding of sums, as in 3.0299999999999773. A value that is not available is an empty
// field.
std::string signal_csv_row(const Truth& truth, const SensorSample& sample, const EcuOutput& output);

class SignalCsvWriter {
 public:
    // Opens the file and writes the header. Throws std::runtime_error with path and reason.
    explicit SignalCsvWriter(const std::filesystem::path& path);

    // One of signal_csv_row().
    void write(const std::string& row) { file_.write(row); }

    void close() { file_.close(); }

 private:
    CsvFile file_;
};

}  // namespace sil
