// Page recording: what the page shows of a run, row by row as signals.csv has it.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sil/results/diagnostic_codes.hpp"
#include "sil/results/events.hpp"
#include "sil/simulation/ecu_frames.hpp"
#include "sil/world/sensors/sensor_sample.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Its shape, for the picture from behind and for the limits.
struct PageVehicle {
    double track_width_m{0.0};
    double cg_height_m{0.0};
    double wheel_radius_m{0.0};
    double half_width_m{0.0};
    double top_above_cg_m{0.0};
    double bottom_below_cg_m{0.0};
    double mass_kg{0.0};
    double static_stability_factor{0.0};
    double roof_load_kg{0.0};
    double up_below_n{0.0};       // a wheel that carries no more is up
    bool outline_is_known{true};  // or else only track width and CG height are
};

PageVehicle page_vehicle(const VehicleParameters& parameters);

// The columns of signals.csv that the page knows, in its order.
const std::vector<std::string>& page_columns();

struct PageHead {
    std::string title{};
    std::string subtitle{};
    PageVehicle vehicle{};
    std::vector<std::pair<std::string, std::string>> facts{};  // name and value
    std::vector<std::string> columns{page_columns()};
    bool lift_off_is_known{true};        // or else the page says that it is not
    std::vector<std::string> remarks{};  // sentences: what is not known and therefore not shown
};

// Some columns of a CSV file, row by row as JSON arrays. A value that is not available is null.
class PageCells {
 public:
    // Throws std::logic_error when the file has no such column.
    PageCells(const std::vector<std::string>& columns_of_file, const std::vector<std::string>& shown);

    // The row's cells hold neither commas nor quotation marks, and its numbers are JSON's.
    std::string row(const std::string& csv_row) const;

 private:
    struct Place {
        std::size_t index;
        bool is_word;
    };

    std::vector<Place> places_{};
};

// The cells of one row, in which there are neither commas nor quotation marks.
std::vector<std::string> cells_of(const std::string& csv_row);

// The cells of page_columns() in one line of signals.csv.
std::string page_row(const std::string& signal_csv_row);

// One change of what the ECU's frames say of its diagnosis.
struct PageDiagnosis {
    double time_s{0.0};
    rsi::can_dbc::RolloverDiagnosis::Degradation degradation{};
    CodeSets codes{};
};

// As JSON objects: the moments by their names with time_s, ay_g and roll_deg; lead time and falling side; one
// change; a head without rows, to which a live drive adds its own members.
std::string events_json(const RunEvents& events);
std::string judgement_json(const RunEvents& events);
std::string diagnosis_json(const PageDiagnosis& diagnosis);
std::string head_json(const PageHead& head);

// The whole recording as JSON: rows as JSON arrays, each of which stands for `every` cycles.
std::string recording_json(const PageHead& head, const RunEvents& events, std::size_t every,
                           const std::vector<PageDiagnosis>& diagnosis, const std::vector<std::string>& rows);

// Finds the changes, cycle by cycle.
class DiagnosisWatch {
 public:
    // Whether it is another one than before; the first one is.
    bool observe(double time_s, const rsi::can_dbc::RolloverDiagnosis& diagnosis);

    const PageDiagnosis& latest() const { return latest_; }

 private:
    CodeListener listener_{};
    PageDiagnosis latest_{};
    bool heard_{false};
};

class PageRecording {
 public:
    // A long run is thinned out: of twice this many rows every other one stays.
    static constexpr std::size_t longest_rows = 4000U;

    // In every cycle, with the row of signals.csv.
    void cycle(const std::string& signal_csv_row, const EcuFrames& ecu, double time_s);

    // The page's recording; `events` as the run has left them.
    std::string json(const PageHead& head, const RunEvents& events) const;

 private:
    std::vector<std::string> rows_{};
    std::size_t cycles_{0U};
    std::size_t every_{1U};  // how many cycles a row stands for
    DiagnosisWatch watch_{};
    std::vector<PageDiagnosis> diagnosis_{};
};

}  // namespace sil
