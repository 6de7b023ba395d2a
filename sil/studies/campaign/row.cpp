// Row: header and values side by side, so that they cannot drift apart.
#include "sil/studies/campaign/row.hpp"

#include "sil/files/csv_writer.hpp"
#include "sil/results/diagnostic_codes.hpp"
#include "sil/studies/campaign/indices.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

// Takes one cell after the other and keeps either the names or the values.
class Cells {
 public:
    explicit Cells(bool names) : names_{names} {}

    void text(const std::string& name, const std::string& value) { row_.text(names_ ? name : value); }
    void count(const std::string& name, std::uint64_t value) { names_ ? row_.text(name) : row_.count(value); }
    // As many digits as a float has.
    void number(const std::string& name, double value) { names_ ? row_.text(name) : row_.number(value, 9); }
    void time(const std::string& name, const std::optional<double>& value) {
        names_ ? row_.text(name) : row_.fixed(value, 3);
    }

    const std::string& line() const { return row_.line(); }

 private:
    bool names_;
    CsvRow row_{};
};

void put_draw(Cells& cells, const CampaignRow& row) {
    const RunDraw& draw = row.draw;
    cells.count("run", draw.number);
    cells.text("vehicle", row.vehicle);
    cells.text("class", row.in_class);
    cells.text("manoeuvre", row.manoeuvre);
    cells.count("mirrored", draw.mirrored ? 1U : 0U);
    cells.number("speed_kmh", row.speed_kmh);
    cells.number("speed_factor", draw.speed_factor);
    cells.number("steering_factor", draw.steering_factor);
    cells.number("friction_factor", draw.friction_factor);
    cells.number("load_share", draw.load_share);
    cells.number("load_height_factor", draw.load_height_factor);
    cells.number("cg_height_error", draw.cg_height_error);
    cells.number("stiffness_error", draw.stiffness_error);
    cells.number("mass_error", draw.mass_error);
    cells.number("mass_sensor_error", draw.mass_sensor_error);
    cells.number("lateral_bias_g", draw.lateral_bias_g);
    cells.number("vertical_bias_g", draw.vertical_bias_g);
    cells.count("sensor_seed", draw.sensor_seed);
}

void put_outcome(Cells& cells, const CampaignRow& row) {
    const Outcome& outcome = row.outcome;
    cells.time("one_wheel_lift_time_s", outcome.one_wheel_lift_time_s);
    cells.time("two_wheel_lift_time_s", outcome.two_wheel_lift_time_s);
    cells.time("brief_two_wheel_lift_time_s", outcome.brief_two_wheel_lift_time_s);
    cells.number("largest_ltr", outcome.largest_ltr);
    cells.number("largest_ltr_before_lift", outcome.largest_ltr_before_lift);
    cells.number("largest_ay_g", outcome.largest_lateral_acceleration_mps2 / g_mps2);
    cells.number("largest_roll_deg", outcome.largest_roll_angle_rad * degrees_per_radian);
    cells.count("rolled_over", outcome.rolled_over ? 1U : 0U);
    cells.time("end_time_s", outcome.end_time_s);
    cells.number("distance_m", outcome.distance_m);
}

void put_judgement(Cells& cells, const CampaignRow& row) {
    const WarningJudgement& judgement = row.judgement;
    const auto side = [](WarningSide value) { return value == WarningSide::none ? "" : to_string(value); };
    cells.time("warning_time_s", row.warning_time_s);
    cells.text("falling_side", side(judgement.falling_side));
    cells.text("side_at_lift_off", side(judgement.side_at_lift_off));
    cells.time("lead_time_s", judgement.lead_s);
    cells.time("wrong_side_duration_s", judgement.wrong_side_s);
    cells.count("warnings", judgement.warnings);
    cells.count("advisories", judgement.advisories);
    cells.time("warning_duration_s", judgement.warning_s);
    cells.time("advisory_duration_s", judgement.advisory_s);
    cells.time("unavailable_duration_s", judgement.unavailable_s);
    cells.text("diagnostic_codes", code_names(row.codes));
}

void put_indices(Cells& cells, const CampaignRow& row) {
    static const IndexScore nothing;
    const std::vector<Index>& indices = campaign_indices();
    for (std::size_t i = 0U; i < indices.size(); ++i) {
        const IndexScore& score = i < row.indices.size() ? row.indices[i] : nothing;
        const std::string name = indices[i].name;
        cells.number(name + "_threshold", score.threshold);
        cells.number(name + "_threshold_100ms", score.threshold_100ms);
        cells.number(name + "_threshold_200ms", score.threshold_200ms);
        cells.time(name + "_lead_time_s", score.lead_s);
    }
}

std::string line_of(const CampaignRow& row, bool names) {
    Cells cells{names};
    put_draw(cells, row);
    put_outcome(cells, row);
    put_judgement(cells, row);
    put_indices(cells, row);
    return cells.line();
}

}  // namespace

std::string row_header() {
    return line_of({}, true);
}

std::string row_line(const CampaignRow& row) {
    return line_of(row, false);
}

}  // namespace sil
