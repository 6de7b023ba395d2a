// Row: the largest of a run and its lift-offs; every column's name, unit, meaning and value side by side, so
// that they cannot drift apart.
#include "sil/studies/campaign/row.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sil/files/csv_writer.hpp"
#include "sil/results/diagnostic_codes.hpp"
#include "sil/results/indices.hpp"
#include "sil/studies/campaign/fingerprint.hpp"
#include "sil/studies/campaign/indices.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr const char* no_unit = "";

// Takes one cell after the other.
class Cells {
 public:
    void text(const std::string& name, const std::string& meaning, const std::string& value) {
        columns_.push_back({name, RowColumn::Kind::text, no_unit, meaning});
        row_.text(value);
    }
    void count(const std::string& name, const std::string& meaning, std::uint64_t value) {
        columns_.push_back({name, RowColumn::Kind::count, no_unit, meaning});
        row_.count(value);
    }
    void yes_or_no(const std::string& name, const std::string& meaning, bool value) {
        columns_.push_back({name, RowColumn::Kind::yes_or_no, no_unit, meaning});
        row_.count(value ? 1U : 0U);
    }
    // As many digits as a float has.
    void number(const std::string& name, const char* unit, const std::string& meaning, double value) {
        columns_.push_back({name, RowColumn::Kind::number, unit, meaning});
        row_.number(value, 9);
    }
    void time(const std::string& name, const std::string& meaning, const std::optional<double>& value) {
        columns_.push_back({name, RowColumn::Kind::number, "s", meaning});
        row_.fixed(value, 3);
    }

    const std::string& line() const { return row_.line(); }
    const std::vector<RowColumn>& columns() const { return columns_; }

 private:
    std::vector<RowColumn> columns_{};
    CsvRow row_{};
};

void put_draw(Cells& cells, const CampaignRow& row) {
    const RunDraw& draw = row.draw;
    cells.count("run", "number of the run; with the settings it determines everything drawn", draw.number);
    cells.text("vehicle", "name of the vehicle's file", row.vehicle);
    cells.text("class", "class of the vehicle, as the settings say; may be empty", row.in_class);
    cells.text("manoeuvre", "what was driven", row.manoeuvre);
    cells.yes_or_no("mirrored", "left and right are exchanged", draw.mirrored);
    cells.number("speed_kmh", "km/h", "speed at the beginning, drawn", row.speed_kmh);
    cells.number("speed_factor", no_unit, "drawn factor on the manoeuvre's speed", draw.speed_factor);
    cells.number("steering_factor", no_unit, "drawn factor on the manoeuvre's handwheel angle",
                 draw.steering_factor);
    cells.number("friction_factor", no_unit, "drawn factor on the friction of all tyres",
                 draw.friction_factor);
    cells.number("load_share", no_unit, "drawn load over the sprung mass", draw.load_share);
    cells.number("load_height_factor", no_unit, "drawn height of the load over that of the sprung CG",
                 draw.load_height_factor);
    cells.number("cg_height_error", no_unit,
                 "the firmware gets the calibration's CG height times 1 plus this", draw.cg_height_error);
    cells.number("stiffness_error", no_unit, "the same for the roll stiffness", draw.stiffness_error);
    cells.number("mass_error", no_unit, "the same for the sprung mass", draw.mass_error);
    cells.number("mass_sensor_error", no_unit, "the same for the mass that is on the bus",
                 draw.mass_sensor_error);
    cells.number("lateral_bias_g", "g", "drawn offset of the lateral accelerometer", draw.lateral_bias_g);
    cells.number("vertical_bias_g", "g", "drawn offset of the vertical accelerometer", draw.vertical_bias_g);
    cells.count("sensor_seed", "seed of the sensors' noise and of a rough road", draw.sensor_seed);
}

void put_outcome(Cells& cells, const CampaignRow& row) {
    const Outcome& outcome = row.outcome;
    cells.time("one_wheel_lift_time_s", "when a wheel first carries no load; empty: never",
               outcome.one_wheel_lift_time_s);
    cells.time("two_wheel_lift_time_s",
               "when both wheels of a side first carry no load for at least 50 ms; empty: never",
               outcome.two_wheel_lift_time_s);
    cells.time("brief_two_wheel_lift_time_s", "when they first do so more briefly before that; empty: never",
               outcome.brief_two_wheel_lift_time_s);
    cells.number("largest_ltr", no_unit, "largest load transfer ratio of the true wheel loads, |LTR|",
                 outcome.largest_ltr);
    cells.number("largest_ltr_before_lift", no_unit, "the same before any wheel has lifted",
                 outcome.largest_ltr_before_lift);
    cells.number("largest_ay_g", "g", "largest horizontal lateral acceleration of the CG",
                 outcome.largest_lateral_acceleration_mps2 / g_mps2);
    cells.number("largest_roll_deg", "deg", "largest roll angle relative to the road",
                 outcome.largest_roll_angle_rad * degrees_per_radian);
    cells.yes_or_no("rolled_over", "the roll angle went beyond any way back", outcome.rolled_over);
    cells.time("end_time_s", "when the run ends", outcome.end_time_s);
    cells.number("distance_m", "m", "way driven", outcome.distance_m);
}

void put_judgement(Cells& cells, const CampaignRow& row) {
    const WarningJudgement& judgement = row.judgement;
    const auto side = [](WarningSide value) { return value == WarningSide::none ? "" : to_string(value); };
    cells.time("warning_time_s", "when the firmware first warns; empty: never", row.warning_time_s);
    cells.text("falling_side", "side to which the vehicle falls as two wheels lift; empty: none does",
               side(judgement.falling_side));
    cells.text("side_at_lift_off", "side that the warning in force then names; empty: none is in force",
               side(judgement.side_at_lift_off));
    cells.time("lead_time_s",
               "for how long it has then been in force with the falling side; empty: missed, or no lift-off",
               judgement.lead_s);
    cells.time("wrong_side_duration_s", "how long a warning named the side that carries less",
               judgement.wrong_side_s);
    cells.count("warnings", "how often a warning began", judgement.warnings);
    cells.count("advisories", "how often an advisory began", judgement.advisories);
    cells.time("warning_duration_s", "how long there was a warning", judgement.warning_s);
    cells.time("advisory_duration_s", "how long there was an advisory", judgement.advisory_s);
    cells.time("unavailable_duration_s", "how long the firmware made no statement, but for the start-up",
               judgement.unavailable_s);
    cells.text("diagnostic_codes", "that the firmware confirmed, between semicolons", code_names(row.codes));
    cells.count("interventions", "how often the settings' intervention began; 0 without one",
                row.interventions);
    cells.time("intervention_duration_s", "for how long it had an effect", row.intervention_s);
}

void put_indices(Cells& cells, const CampaignRow& row) {
    static const IndexScore nothing;
    const std::vector<Index>& indices = campaign_indices();
    for (std::size_t i = 0U; i < indices.size(); ++i) {
        const IndexScore& score = i < row.indices.size() ? row.indices[i] : nothing;
        const std::string& name = indices[i].name;
        cells.number(
            name + "_threshold", no_unit,
            "largest threshold at which the index " + name +
                " warns: as two wheels lift of the falling side, without lift-off at all; 0: at none",
            score.threshold);
        cells.number(name + "_threshold_100ms", no_unit, "the same, at least 0.1 s before lift-off",
                     score.threshold_100ms);
        cells.number(name + "_threshold_200ms", no_unit, "the same, at least 0.2 s before lift-off",
                     score.threshold_200ms);
        cells.time(name + "_lead_time_s", "lead_time_s of the index with its threshold at 1", score.lead_s);
    }
}

Cells cells_of(const CampaignRow& row) {
    Cells cells;
    put_draw(cells, row);
    put_outcome(cells, row);
    put_judgement(cells, row);
    put_indices(cells, row);
    cells.text(row_check_name, "fingerprint of the row before it: any other text was not written so",
               fingerprint_of(cells.line()));
    return cells;
}

const char* to_string(RowColumn::Kind kind) {
    switch (kind) {
        case RowColumn::Kind::text:
            return "text";
        case RowColumn::Kind::count:
            return "count";
        case RowColumn::Kind::yes_or_no:
            return "yes_or_no";
        case RowColumn::Kind::number:
            return "number";
    }
    return "";
}

}  // namespace

void OutcomeObserver::observe(const Truth& truth) {
    const auto& loads = truth.wheel_load_n;
    if (!outcome_.one_wheel_lift_time_s &&
        std::any_of(loads.begin(), loads.end(), [](double load_n) { return load_n <= 0.0; })) {
        outcome_.one_wheel_lift_time_s = truth.time_s;
    }
    const double ltr = std::abs(true_load_transfer_ratio(truth));
    if (std::isfinite(ltr)) {
        outcome_.largest_ltr = std::max(outcome_.largest_ltr, ltr);
        if (!outcome_.one_wheel_lift_time_s) {
            outcome_.largest_ltr_before_lift = std::max(outcome_.largest_ltr_before_lift, ltr);
        }
    }
    outcome_.largest_lateral_acceleration_mps2 =
        std::max(outcome_.largest_lateral_acceleration_mps2, std::abs(truth.lateral_acceleration_mps2));
    outcome_.largest_roll_angle_rad =
        std::max(outcome_.largest_roll_angle_rad, std::abs(truth.roll_angle_rad));
    outcome_.rolled_over = outcome_.largest_roll_angle_rad > rolled_over_rad;
    outcome_.distance_m += truth.speed_mps * (truth.time_s - outcome_.end_time_s);
    outcome_.end_time_s = truth.time_s;
    lift_.observe({truth.time_s, truth.lateral_acceleration_mps2, truth.roll_angle_rad},
                  left_side_has_lifted(truth), right_side_has_lifted(truth));
    if (lift_.lift_off()) {
        outcome_.two_wheel_lift_time_s = lift_.lift_off()->moment.time_s;
    }
    outcome_.brief_two_wheel_lift_time_s = lift_.brief_time_s();
}

bool OutcomeObserver::settled() const {
    return outcome_.rolled_over ||
           (outcome_.two_wheel_lift_time_s &&
            outcome_.end_time_s - *outcome_.two_wheel_lift_time_s > settled_after_lift_s);
}

std::vector<RowColumn> row_columns() {
    return cells_of({}).columns();
}

std::string row_columns_json() {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const RowColumn& column : row_columns()) {
        json.push_back({{"name", column.name},
                        {"kind", to_string(column.kind)},
                        {"unit", column.unit},
                        {"meaning", column.meaning}});
    }
    return json.dump(1) + "\n";
}

std::string row_header() {
    CsvRow row;
    for (const RowColumn& column : row_columns()) {
        row.text(column.name);
    }
    return row.line();
}

std::string row_line(const CampaignRow& row) {
    return cells_of(row).line();
}

}  // namespace sil
