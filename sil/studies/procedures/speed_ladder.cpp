#include "sil/studies/procedures/speed_ladder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sil/judge/two_wheel_lift.hpp"
#include "sil/studies/procedures/handwheel_angle.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

ProcedureStep drive_speed(const ProcedureWorld& world, const SpeedLadder& ladder, double speed_mph,
                          double handwheel_rad, bool to_the_right) {
    ProcedureStep step;
    step.series = to_the_right ? "right" : "left";
    step.name = fmt::format("{:g} mph", speed_mph);
    TwoWheelLiftMeasurement measurement{ladder.start_s};
    const StepDrive drive =
        drive_step(world, fmt::format("{}-{:04.1f}-mph", step.series, speed_mph),
                   ladder.manoeuvre(from_mph(speed_mph), handwheel_rad), to_the_right, measurement);
    const std::optional<double> entry = measurement.entry_speed_mps();
    step.figures = {
        {"handwheel_deg", "handwheel", "deg", 0, handwheel_rad * degrees_per_radian},
        {"entry_speed_kmh", "entrance speed", "km/h", 1, entry ? std::optional{*entry * 3.6} : std::nullopt}};
    for (Figure& figure : motion_figures(drive)) {
        if (figure.key != "two_wheel_height_mm") {  // the criterion says it
            step.figures.push_back(std::move(figure));
        }
    }
    step.criteria = {two_wheel_lift_criterion(measurement.height_m(), ladder.source)};
    step.warning = drive.warning;
    return step;
}

std::string side_verdict(const char* series, const std::optional<double>& lift_mph, double last_mph) {
    return lift_mph ? fmt::format("{} first: two-wheel lift at {:g} mph", series, *lift_mph)
                    : fmt::format("{} first: no two-wheel lift up to {:g} mph", series, last_mph);
}

}  // namespace

void TwoWheelLiftMeasurement::step(const Truth& truth) {
    time_s_ = truth.time_s;
    if (!entry_speed_mps_ && time_s_ >= start_s_ - time_rounding_s) {
        entry_speed_mps_ = truth.speed_mps;
    }
    height_m_ = std::max(height_m_, two_wheel_height_m(truth));
    if (!reached_s_ && height_m_ >= two_wheel_lift_m) {
        reached_s_ = time_s_;
    }
}

// By then the lift-off, which the ECU's lead counts to, has lasted long enough to count.
bool TwoWheelLiftMeasurement::finished() const {
    return reached_s_ && time_s_ >= *reached_s_ + TwoWheelLiftObserver::lasting_s;
}

Criterion two_wheel_lift_criterion(double height_m, const std::string& source) {
    return {{"two_wheel_height_mm", "two wheels up", "mm", 1, 1000.0 * height_m},
            Bound::below,
            1000.0 * two_wheel_lift_m,
            source};
}

ProcedureResult run_speed_ladder(const ProcedureWorld& world, const SpeedLadder& ladder) {
    ProcedureResult result;
    const double angle_rad = handwheel_angle_of_both_sides_rad(world.vehicle);
    result.before = {handwheel_figure(angle_rad)};
    for (const bool to_the_right : {false, true}) {
        std::optional<double> lift_mph;
        for (const double speed_mph : ladder.speeds_mph) {
            result.steps.push_back(
                drive_speed(world, ladder, speed_mph, ladder.factor * angle_rad, to_the_right));
            if (world.finished_step) {
                world.finished_step(result.steps.back());
            }
            if (!result.steps.back().met()) {
                lift_mph = speed_mph;
                break;
            }
        }
        const char* series = to_the_right ? "right" : "left";
        result.results.push_back({fmt::format("two_wheel_lift_{}_first_mph", series),
                                  fmt::format("two-wheel lift, {} first", series), "mph", 1, lift_mph});
        result.verdict +=
            (to_the_right ? "; " : "") + side_verdict(series, lift_mph, ladder.speeds_mph.back());
    }
    result.outcome = outcome_of(result.steps);
    result.notes = {
        "The vehicle is driven as its file has it, without the passengers, outriggers and worn-in tyres of "
        "the "
        "real test, and without stability control.",
        "Wheel heights are those of the lowest point of each tyre over the road, as the model has them."};
    return result;
}

}  // namespace sil
