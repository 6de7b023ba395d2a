// FMVSS 126 (49 CFR 571.126) S5.2, S7.6 and S7.9; UN R140 and UN GTR 8 have the same test.
#include "sil/studies/procedures/sine_with_dwell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/simulation/pace.hpp"
#include "sil/studies/procedures/catalogue.hpp"
#include "sil/studies/procedures/handwheel_angle.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/rule_book.hpp"

namespace sil {
namespace {

constexpr double first_factor = 1.5;                  // S7.9.3
constexpr double factor_step = 0.5;                   // S7.9.3
constexpr double last_factor = 6.5;                   // S7.9.4
constexpr double responsive_from = 5.0;               // S5.2.3
constexpr double beginning_of_steer_deg = 5.0;        // S7.11.6
constexpr double displaced_after_s = 1.07;            // S5.2.3
constexpr double first_share_after_s = 1.0;           // S5.2.1
constexpr double second_share_after_s = 1.75;         // S5.2.2
constexpr double first_share_limit = 35.0;            // S5.2.1, per cent
constexpr double second_share_limit = 20.0;           // S5.2.2
constexpr double displacement_of_the_light_m = 1.83;  // S5.2.3
constexpr double displacement_of_the_heavy_m = 1.52;
constexpr double heavy_above_kg = 3500.0;
constexpr double heaviest_kg = 4536.0;  // S3: the standard ends here
constexpr double no_peak_within = 0.02;
constexpr double step_s = 0.001;

}  // namespace

std::vector<double> sine_with_dwell_amplitudes_deg(double a_deg) {
    const double smallest_last = SineWithDwell::smallest_last_amplitude_rad * degrees_per_radian;
    const double largest = SineWithDwell::largest_amplitude_rad * degrees_per_radian;
    const double last = std::min(largest, std::max(last_factor * a_deg, smallest_last));
    std::vector<double> amplitudes;
    for (double factor = first_factor; factor * a_deg < last - 1.0e-9; factor += factor_step) {
        amplitudes.push_back(factor * a_deg);
    }
    amplitudes.push_back(last);
    return amplitudes;
}

void SineWithDwellMeasurement::step(const Truth& truth) {
    wheels_are_up_ = two_wheels_have_lifted(truth);
    const double time_s = truth.time_s;
    const auto has_come = [time_s](double moment_s) { return time_s >= moment_s - 0.5 * step_s; };
    if (!entry_speed_mps_ && has_come(SineWithDwell::start_s)) {
        entry_speed_mps_ = truth.speed_mps;
    }
    if (!begin_s_ && truth.steering_wheel_angle_rad * degrees_per_radian >= beginning_of_steer_deg) {
        begin_s_ = time_s;
        begin_y_m_ = truth.position_y_m;
    }
    if (begin_s_ && !displacement_m_ && has_come(*begin_s_ + displaced_after_s)) {
        displacement_m_ = truth.position_y_m - begin_y_m_;
    }
    const double yaw_rate = -truth.angular_velocity_radps[2];  // to the right, as the second half steers
    if (has_come(SineWithDwell::sign_change_s)) {
        follow_peak(yaw_rate);
    }
    if (!yaw_rate_after_1_00_s_ && has_come(SineWithDwell::completion_s + first_share_after_s)) {
        yaw_rate_after_1_00_s_ = yaw_rate;
    }
    if (!yaw_rate_after_1_75_s_ && has_come(SineWithDwell::completion_s + second_share_after_s)) {
        yaw_rate_after_1_75_s_ = yaw_rate;
    }
}

bool SineWithDwellMeasurement::finished() const {
    return yaw_rate_after_1_75_s_ && !wheels_are_up_;
}

void SineWithDwellMeasurement::follow_peak(double yaw_rate_radps) {
    if (peak_is_over_) {
        return;
    }
    largest_yaw_rate_radps_ = std::max(largest_yaw_rate_radps_, yaw_rate_radps);
    peak_is_over_ =
        largest_yaw_rate_radps_ > 0.0 && yaw_rate_radps < (1.0 - no_peak_within) * largest_yaw_rate_radps_;
}

std::optional<double> SineWithDwellMeasurement::peak_yaw_rate_radps() const {
    return largest_yaw_rate_radps_ > 0.0 ? std::optional{largest_yaw_rate_radps_} : std::nullopt;
}

std::optional<double> SineWithDwellMeasurement::share(const std::optional<double>& yaw_rate_radps) const {
    const std::optional<double> peak = peak_yaw_rate_radps();
    return yaw_rate_radps && peak ? std::optional{100.0 * *yaw_rate_radps / *peak} : std::nullopt;
}

std::vector<Criterion> sine_with_dwell_criteria(const SineWithDwellMeasurement& measurement, double mass_kg,
                                                bool from_5_a_on) {
    const double displacement_limit =
        mass_kg > heavy_above_kg ? displacement_of_the_heavy_m : displacement_of_the_light_m;
    return {{{"yaw_share_1_00_s_pc", "yaw rate after 1.00 s", "%", 1, measurement.share_after_1_00_s()},
             Bound::at_most,
             first_share_limit,
             "FMVSS 126 S5.2.1"},
            {{"yaw_share_1_75_s_pc", "yaw rate after 1.75 s", "%", 1, measurement.share_after_1_75_s()},
             Bound::at_most,
             second_share_limit,
             "FMVSS 126 S5.2.2"},
            {{"displacement_m", "displaced after 1.07 s", "m", 2, measurement.displacement_m()},
             Bound::at_least,
             displacement_limit,
             "FMVSS 126 S5.2.3",
             from_5_a_on}};
}

namespace {

ProcedureStep drive_amplitude(const ProcedureWorld& world, double amplitude_deg, double a_deg,
                              bool to_the_right, bool& overturned) {
    ProcedureStep step;
    step.series = to_the_right ? "right" : "left";
    step.name = fmt::format("{:.0f} deg", amplitude_deg);
    SineWithDwellMeasurement measurement;
    const StepDrive drive =
        drive_step(world, fmt::format("{}-{:03.0f}-deg", step.series, amplitude_deg),
                   sine_with_dwell(amplitude_deg / degrees_per_radian), to_the_right, measurement);
    overturned = !drive.completed;
    const std::optional<double> entry = measurement.entry_speed_mps();
    const std::optional<double> peak = measurement.peak_yaw_rate_radps();
    step.figures = {
        {"amplitude_deg", "handwheel", "deg", 1, amplitude_deg},
        {"times_a", "times A", "", 2, amplitude_deg / a_deg},
        {"entry_speed_kmh", "entrance speed", "km/h", 1, entry ? std::optional{*entry * 3.6} : std::nullopt},
        {"peak_yaw_rate_degps", "peak yaw rate", "deg/s", 1,
         peak ? std::optional{*peak * degrees_per_radian} : std::nullopt}};
    for (Figure& figure : motion_figures(drive)) {
        step.figures.push_back(std::move(figure));
    }
    step.criteria = sine_with_dwell_criteria(measurement, total_mass_kg(world.vehicle),
                                             amplitude_deg >= responsive_from * a_deg - 1.0e-9);
    step.warning = drive.warning;
    return step;
}

ProcedureResult run_sine_with_dwell(const ProcedureWorld& world) {
    ProcedureResult result;
    const double mass_kg = total_mass_kg(world.vehicle);
    // S7.6.1: rounded to a tenth of a degree.
    const double a_deg =
        0.1 * std::round(10.0 * degrees_per_radian * handwheel_angle_of_both_sides_rad(world.vehicle));
    result.before = {handwheel_figure(a_deg / degrees_per_radian), {"mass_kg", "mass", "kg", 0, mass_kg}};
    std::size_t overturns = 0U;
    for (const bool to_the_right : {false, true}) {
        bool overturned = false;
        for (const double amplitude_deg : sine_with_dwell_amplitudes_deg(a_deg)) {
            result.steps.push_back(drive_amplitude(world, amplitude_deg, a_deg, to_the_right, overturned));
            if (world.finished_step) {
                world.finished_step(result.steps.back());
            }
            if (overturned) {
                ++overturns;
                break;
            }
        }
    }
    result.outcome = outcome_of(result.steps);
    const auto failed = std::count_if(result.steps.begin(), result.steps.end(),
                                      [](const ProcedureStep& step) { return !step.met(); });
    result.verdict = failed == 0 ? fmt::format("all {} runs stay within the limits", result.steps.size())
                                 : fmt::format("{} of {} runs miss a limit", failed, result.steps.size());
    if (overturns > 0U) {
        result.verdict += fmt::format("; the vehicle overturns in {}, which end{} {} series", overturns,
                                      overturns == 1U ? "s" : "", overturns == 1U ? "its" : "their");
    }
    result.notes = {
        "The simulated vehicles have no electronic stability control, which this test is for: it judges the "
        "bare vehicle.",
        "The vehicle's file has no gross vehicle mass; the mass of the simulated vehicle takes its place.",
        "The displacement is that of the centre of gravity; the rule integrates an acceleration twice."};
    if (mass_kg > heaviest_kg) {
        result.notes.push_back(
            fmt::format("The rule ends at {:.0f} kg; this vehicle is heavier.", heaviest_kg));
    }
    return result;
}

}  // namespace

Procedure sine_with_dwell_procedure() {
    return {"sine-with-dwell",
            "0.7 Hz with 500 ms of dwell at 80 km/h, amplitudes from 1.5 A to 6.5 A or 270 degrees, both "
            "directions",
            {"FMVSS 126 (49 CFR 571.126) S5.2, S7.6, S7.9, S7.11", "UN R140, UN GTR 8: the same test"},
            run_sine_with_dwell};
}

}  // namespace sil
