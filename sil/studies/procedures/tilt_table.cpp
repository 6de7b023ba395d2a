// Tilt table: the vehicle stands, and the table under it tilts sideways until the wheels of the high side
// lift. ISO 16333 takes the tangent of that angle for the steady rollover threshold in g; UN R111 asks for 23
// degrees.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "sil/judge/two_wheel_lift.hpp"
#include "sil/studies/procedures/catalogue.hpp"
#include "sil/studies/procedures/step_drive.hpp"
#include "sil/studies/procedures/tilt_table.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double still_s = 2.0;  // the ECU starts up
constexpr double rate_radps = from_degrees(0.25);
constexpr double largest_angle_rad = from_degrees(50.0);
constexpr double stop_against_sliding = 4.0;  // times the tyres' friction
constexpr double limit_deg = 23.0;            // UN R111, 5.3.1 and annex 3

// Turns about the x axis, the left side up. The driver's clock moves it.
class TiltingTable final : public Road {
 public:
    explicit TiltingTable(std::shared_ptr<const double> angle_rad) : angle_rad_{std::move(angle_rad)} {}

    RoadPoint at(double /*x_m*/, double y_m) const noexcept override {
        RoadPoint point;
        point.height_m = std::tan(*angle_rad_) * y_m;
        point.normal = {0.0, -std::sin(*angle_rad_), std::cos(*angle_rad_)};
        point.friction_factor = stop_against_sliding;
        return point;
    }

 private:
    std::shared_ptr<const double> angle_rad_;
};

class TableOperator final : public CopiedDriver<TableOperator> {
 public:
    explicit TableOperator(std::shared_ptr<double> angle_rad) : angle_rad_{std::move(angle_rad)} {}

    DriverCommand command(const Truth& truth) override {
        *angle_rad_ = ramp_and_hold(truth.time_s, still_s, rate_radps, largest_angle_rad);
        DriverCommand command;
        command.brake = 1.0;  // else the vehicle would roll off as its wheels lift
        return command;
    }

 private:
    std::shared_ptr<double> angle_rad_;
};

// To be driven once: road and driver share the angle.
Manoeuvre tilting() {
    const auto angle_rad = std::make_shared<double>(0.0);
    Manoeuvre manoeuvre;
    manoeuvre.duration_s = still_s + largest_angle_rad / rate_radps;
    manoeuvre.make_road = [angle_rad](std::uint64_t) { return std::make_unique<TiltingTable>(angle_rad); };
    manoeuvre.make_driver = [angle_rad](const VehicleParameters&) {
        return std::make_unique<TableOperator>(angle_rad);
    };
    return manoeuvre;
}

ProcedureStep tilt(const ProcedureWorld& world, bool left_low) {
    ProcedureStep step;
    step.series = left_low ? "left" : "right";
    step.name = fmt::format("{} side low", step.series);
    TiltMeasurement measurement;
    const StepDrive drive = drive_step(world, step.series + "-side-low", tilting(), left_low, measurement);
    const auto degrees = [](double angle_rad) { return angle_rad * degrees_per_radian; };
    const double angle_rad = measurement.two_wheel_angle_rad().value_or(measurement.angle_rad());
    const std::optional<double> first_rad = measurement.one_wheel_angle_rad();
    step.figures = {{"one_wheel_angle_deg", "one wheel lifts at", "deg", 2,
                     first_rad ? std::optional{degrees(*first_rad)} : std::nullopt},
                    {"threshold_g", "steady rollover threshold", "g", 3, std::tan(angle_rad)},
                    {"roll_deg", "roll on the table", "deg", 2, degrees(measurement.roll_rad())},
                    {"largest_ltr", "largest |LTR|", "", 2, drive.warning.largest_load_transfer_ratio}};
    step.criteria = {tilt_criterion(angle_rad)};
    step.warning = drive.warning;
    return step;
}

ProcedureResult run_tilt_table(const ProcedureWorld& world) {
    ProcedureResult result;
    result.before = {{"static_stability_factor", "static stability factor of the sprung mass", "", 3,
                      static_stability_factor(world.vehicle)}};
    double smallest_deg = 90.0;
    for (const bool left_low : {false, true}) {
        result.steps.push_back(tilt(world, left_low));
        smallest_deg = std::min(smallest_deg, *result.steps.back().criteria.front().measured.value);
        if (world.finished_step) {
            world.finished_step(result.steps.back());
        }
    }
    const double threshold_g = std::tan(smallest_deg / degrees_per_radian);
    result.results = {{"smaller_angle_deg", "smaller tilt angle at two-wheel lift", "deg", 2, smallest_deg},
                      {"smaller_threshold_g", "smaller steady rollover threshold", "g", 3, threshold_g}};
    result.outcome = outcome_of(result.steps);
    const bool lifted = std::any_of(result.steps.begin(), result.steps.end(),
                                    [](const ProcedureStep& step) { return step.warning.lifted; });
    result.verdict =
        fmt::format("{} {:.1f} degrees, {:.2f} g; UN R111 asks for {:.0f} degrees",
                    lifted ? "two wheels of a side lift at" : "no two wheels of a side lift up to",
                    smallest_deg, threshold_g, limit_deg);
    result.notes = {
        "UN R111 holds for laden tank vehicles, ISO 16333 for heavy vehicles and buses; other vehicles are "
        "tilted to compare.",
        "A high friction stands for the step that keeps the tyres from sliding; the brakes are on. The "
        "vehicle "
        "still creeps and turns by some degrees, and the angle is that across it.",
        "The ECU receives no bank and assumes a level road, on which the vehicle would be turning: "
        "its "
        "answer is shown, and is not what it is made for."};
    return result;
}

}  // namespace

void TiltMeasurement::step(const Truth& truth) {
    // Bank of the road under the vehicle, the left side up.
    angle_rad_ = truth.bank_angle_rad;
    time_s_ = truth.time_s;
    const bool any = std::any_of(truth.wheel_load_n.begin(), truth.wheel_load_n.end(),
                                 [](double load_n) { return load_n <= 0.0; });
    if (any && !one_wheel_angle_rad_) {
        one_wheel_angle_rad_ = angle_rad_;
    }
    if (!two_wheel_angle_rad_) {
        roll_rad_ = truth.roll_angle_rad;
        if (left_side_has_lifted(truth)) {
            two_wheel_angle_rad_ = angle_rad_;
            lifted_s_ = time_s_;
        }
    }
}

bool TiltMeasurement::finished() const {
    return two_wheel_angle_rad_ && time_s_ >= lifted_s_ + 2.0 * TwoWheelLiftObserver::lasting_s;
}

Criterion tilt_criterion(double angle_rad) {
    return {{"two_wheel_angle_deg", "two wheels lift at", "deg", 2, angle_rad * degrees_per_radian},
            Bound::at_least,
            limit_deg,
            "UN R111, 5.3.1 and annex 3"};
}

Procedure tilt_table_procedure() {
    return {
        "tilt-table",
        "the vehicle stands on a table that tilts by 0.25 degrees/s, to either side, until both wheels of "
        "the high side lift",
        {"ISO 16333:2011", "UN R111, 5.3.1 and annex 3"},
        run_tilt_table};
}

}  // namespace sil
