// Row: header and values side by side, so that they cannot drift apart.
#include "sil/studies/campaign/row.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "sil/studies/campaign/indices.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

// Takes one cell after the other and keeps either the names or the values.
class Cells {
 public:
    explicit Cells(bool names) : names_{names} {}

    void text(const std::string& name, const std::string& value) {
        line_ += line_.empty() ? "" : ",";
        line_ += names_ ? name : value;
    }
    void count(const std::string& name, std::uint64_t value) { text(name, fmt::format("{}", value)); }
    // As many digits as a float has.
    void number(const std::string& name, double value) { text(name, fmt::format("{:.9g}", value)); }
    void time(const std::string& name, const std::optional<double>& value) {
        const double time_s = value.value_or(std::numeric_limits<double>::quiet_NaN());
        text(name, std::isfinite(time_s) ? fmt::format("{:.3f}", time_s) : "");
    }

    const std::string& line() const { return line_; }

 private:
    bool names_;
    std::string line_;
};

void put_draw(Cells& cells, const CampaignRow& row) {
    const RunDraw& draw = row.draw;
    cells.count("run", draw.number);
    cells.text("vehicle", row.vehicle);
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
    cells.time("warning_time_s", row.warning_time_s);
    std::optional<double> lead_s;
    if (row.warning_time_s && outcome.two_wheel_lift_time_s) {
        lead_s = *outcome.two_wheel_lift_time_s - *row.warning_time_s;
    }
    cells.time("lead_time_s", lead_s);
}

void put_indices(Cells& cells, const CampaignRow& row) {
    static const IndexPeaks nothing;
    const std::vector<Index>& indices = campaign_indices();
    for (std::size_t i = 0U; i < indices.size(); ++i) {
        const IndexPeaks& peaks = i < row.indices.size() ? row.indices[i] : nothing;
        const std::string name = indices[i].name;
        cells.number(name + "_peak", peaks.whole);
        cells.number(name + "_peak_100ms_before", peaks.before_100ms);
        cells.time(name + "_time_s", peaks.first_time_s);
    }
}

std::string line_of(const CampaignRow& row, bool names) {
    Cells cells{names};
    put_draw(cells, row);
    put_outcome(cells, row);
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
