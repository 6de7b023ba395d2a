// Steady circle after ISO 4138, method 1 (constant radius) with discrete speeds: the driver keeps a circle of
// 100 m, each time faster, until it cannot be kept or two wheels lift. The standard sets no limits.
#include "sil/studies/procedures/steady_circle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sil/studies/procedures/catalogue.hpp"
#include "sil/studies/procedures/handwheel_angle.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/path_follower.hpp"
#include "sil/world/manoeuvres/steady_steering.hpp"

namespace sil {
namespace {

constexpr double radius_m = 100.0;              // ISO 4138: the standard radius
constexpr double acceleration_step_mps2 = 0.5;  // ISO 4138: no larger increments
constexpr double first_acceleration_mps2 = 0.5;
constexpr double last_acceleration_mps2 = 12.0;  // no tyre holds more
constexpr double fit_from_mps2 = 1.0;
constexpr double fit_to_mps2 = 4.0;
constexpr double on_circle_within = 0.02;
constexpr double start_s = 1.0;
constexpr double entry_s = 3.0;
constexpr double duration_s = 18.0;
constexpr double correction_time_s = 0.8;
constexpr double largest_handwheel_rad = from_degrees(540.0);

// Turns in for what a linear vehicle would need and corrects what comes out otherwise.
class CircleDriver final : public CopiedDriver<CircleDriver> {
 public:
    CircleDriver(SteadySteering steering, double acceleration_mps2, double speed_mps)
        : steering_{steering}, acceleration_mps2_{acceleration_mps2}, speed_mps_{speed_mps} {}

    DriverCommand command(const Truth& truth) override {
        const double step_s = truth.time_s - last_time_s_;
        last_time_s_ = truth.time_s;
        const double share = ramp_and_hold(truth.time_s, start_s, 1.0 / entry_s, 1.0);
        if (truth.time_s > start_s + entry_s) {
            const double speed_mps = std::max(1.0, truth.speed_mps);
            const double missing_mps2 = speed_mps * (speed_mps / radius_m - truth.angular_velocity_radps[2]);
            correction_rad_ += steering_.handwheel_rad(missing_mps2, speed_mps_) * step_s / correction_time_s;
        }
        const double angle_rad =
            share * steering_.handwheel_rad(acceleration_mps2_, speed_mps_) + correction_rad_;
        return {std::clamp(angle_rad, -largest_handwheel_rad, largest_handwheel_rad), SpeedPolicy::held};
    }

 private:
    SteadySteering steering_;
    double acceleration_mps2_;
    double speed_mps_;
    double last_time_s_{0.0};
    double correction_rad_{0.0};
};

Manoeuvre circle(double acceleration_mps2, double understeer_s2pm) {
    const double speed_mps = std::sqrt(acceleration_mps2 * radius_m);
    Manoeuvre manoeuvre;
    manoeuvre.duration_s = duration_s;
    manoeuvre.initial_speed_mps = speed_mps;
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = [=](const VehicleParameters& vehicle) {
        return std::make_unique<CircleDriver>(SteadySteering{vehicle, understeer_s2pm}, acceleration_mps2,
                                              speed_mps);
    };
    return manoeuvre;
}

template <typename Value>
std::optional<double> in(const std::optional<SteadyTurn>& turn, Value value) {
    return turn ? std::optional<double>{value(*turn)} : std::nullopt;
}

struct Circle {
    ProcedureStep step{};
    std::optional<SteadyTurn> turn{};  // empty: not kept
};

Circle drive_circle(const ProcedureWorld& world, double acceleration_mps2, double understeer_s2pm,
                    bool to_the_right) {
    Circle result;
    ProcedureStep& step = result.step;
    step.series = to_the_right ? "right" : "left";
    step.name = fmt::format("{:.1f} m/s^2", acceleration_mps2);
    SteadyTurnMeasurement measurement{duration_s};
    const StepDrive drive = drive_step(world, fmt::format("{}-{:04.1f}-mps2", step.series, acceleration_mps2),
                                       circle(acceleration_mps2, understeer_s2pm), to_the_right, measurement);
    const std::optional<SteadyTurn> turn = measurement.mean();
    step.figures = {
        {"speed_kmh", "speed", "km/h", 1, in(turn, [](const SteadyTurn& t) { return 3.6 * t.speed_mps; })},
        {"lateral_acceleration_mps2", "lateral acceleration", "m/s^2", 2,
         in(turn, [](const SteadyTurn& t) { return t.lateral_acceleration_mps2; })},
        {"radius_m", "radius", "m", 1, in(turn, [](const SteadyTurn& t) { return 1.0 / t.curvature_pm; })},
        {"handwheel_deg", "handwheel", "deg", 1,
         in(turn, [](const SteadyTurn& t) { return t.handwheel_rad * degrees_per_radian; })},
        {"sideslip_deg", "sideslip", "deg", 2,
         in(turn, [](const SteadyTurn& t) { return t.sideslip_rad * degrees_per_radian; })},
        {"roll_deg", "roll", "deg", 2,
         in(turn, [](const SteadyTurn& t) { return t.roll_rad * degrees_per_radian; })},
        {"largest_ltr", "largest |LTR|", "", 2, drive.warning.largest_load_transfer_ratio}};
    step.warning = drive.warning;
    if (is_on_circle(turn, radius_m)) {
        result.turn = turn;
    }
    return result;
}

struct Series {
    std::vector<SteadyTurn> turns{};
    std::string end{};
};

Series drive_series(const ProcedureWorld& world, double understeer_s2pm, bool to_the_right,
                    ProcedureResult& result) {
    Series series;
    for (double wanted = first_acceleration_mps2; wanted <= last_acceleration_mps2;
         wanted += acceleration_step_mps2) {
        Circle circle = drive_circle(world, wanted, understeer_s2pm, to_the_right);
        result.steps.push_back(circle.step);
        if (world.finished_step) {
            world.finished_step(circle.step);
        }
        if (circle.step.warning.lifted) {
            series.end = fmt::format("two wheels lift at {:.1f} m/s^2", wanted);
            return series;
        }
        if (!circle.turn) {
            series.end = fmt::format("the circle is not kept at {:.1f} m/s^2", wanted);
            return series;
        }
        series.turns.push_back(*circle.turn);
    }
    series.end = fmt::format("nothing ends it up to {:.1f} m/s^2", last_acceleration_mps2);
    return series;
}

void add_results(const VehicleParameters& vehicle, const Series& series, const std::string& side,
                 ProcedureResult& result) {
    const auto per_g = [](const std::optional<double>& slope) {
        return slope ? std::optional{*slope * g_mps2 * degrees_per_radian} : std::nullopt;
    };
    std::optional<double> understeer = per_g(gradient(series.turns, &SteadyTurn::handwheel_rad));
    if (understeer) {
        *understeer /= vehicle.steering.ratio;
    }
    const auto add = [&](const char* key, const char* name, const char* unit, int decimals,
                         const std::optional<double>& value) {
        result.results.push_back(
            {fmt::format("{}_{}", side, key), fmt::format("{}, {}", name, side), unit, decimals, value});
    };
    add("understeer_degpg", "understeer gradient", "deg/g", 2, understeer);
    add("roll_gradient_degpg", "roll gradient", "deg/g", 2,
        per_g(gradient(series.turns, &SteadyTurn::roll_rad)));
    add("sideslip_gradient_degpg", "sideslip gradient", "deg/g", 2,
        per_g(gradient(series.turns, &SteadyTurn::sideslip_rad)));
    std::optional<double> largest;
    for (const SteadyTurn& turn : series.turns) {
        largest = std::max(largest.value_or(0.0), turn.lateral_acceleration_mps2);
    }
    add("largest_acceleration_mps2", "largest lateral acceleration held", "m/s^2", 2, largest);
}

ProcedureResult run_steady_circle(const ProcedureWorld& world) {
    ProcedureResult result;
    const double angle_rad = handwheel_angle_of_both_sides_rad(world.vehicle);
    const double understeer_s2pm = understeer_gradient_s2pm(world.vehicle, angle_rad);
    for (const bool to_the_right : {false, true}) {
        const std::string side = to_the_right ? "right" : "left";
        const Series series = drive_series(world, understeer_s2pm, to_the_right, result);
        add_results(world.vehicle, series, side, result);
        result.verdict += fmt::format("{}{}: {}", to_the_right ? "; " : "", side, series.end);
    }
    result.outcome = ProcedureOutcome::measured;
    result.notes = {
        "The standard sets no limits. Gradients are those of the line through the turns from 1 to 4 m/s^2.",
        "The driver keeps the curvature of the circle, not a line on the road."};
    return result;
}

}  // namespace

void SteadyTurnMeasurement::step(const Truth& truth) {
    lifted_ = lifted_ || two_wheel_height_m(truth) > 0.05;
    if (truth.time_s < from_s_) {
        return;
    }
    count_ += 1.0;
    sum_.speed_mps += truth.speed_mps;
    sum_.lateral_acceleration_mps2 += truth.lateral_acceleration_mps2;
    sum_.curvature_pm += truth.angular_velocity_radps[2] / std::max(1.0, truth.speed_mps);
    sum_.handwheel_rad += truth.steering_wheel_angle_rad;
    sum_.sideslip_rad += std::atan2(truth.lateral_velocity_mps, std::max(1.0, truth.speed_mps));
    sum_.roll_rad += truth.roll_angle_rad;
}

std::optional<SteadyTurn> SteadyTurnMeasurement::mean() const {
    if (lifted_ || count_ == 0.0) {
        return std::nullopt;
    }
    SteadyTurn mean = sum_;
    for (double SteadyTurn::* value :
         {&SteadyTurn::speed_mps, &SteadyTurn::lateral_acceleration_mps2, &SteadyTurn::curvature_pm,
          &SteadyTurn::handwheel_rad, &SteadyTurn::sideslip_rad, &SteadyTurn::roll_rad}) {
        mean.*value /= count_;
    }
    return mean;
}

bool is_on_circle(const std::optional<SteadyTurn>& turn, double circle_radius_m) {
    return turn && std::abs(turn->curvature_pm * circle_radius_m - 1.0) <= on_circle_within;
}

std::optional<double> gradient(const std::vector<SteadyTurn>& turns, double SteadyTurn::* quantity) {
    double count = 0.0;
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    for (const SteadyTurn& turn : turns) {
        const double a = turn.lateral_acceleration_mps2;
        if (a >= 0.95 * fit_from_mps2 && a <= 1.05 * fit_to_mps2) {
            count += 1.0;
            x += a;
            y += turn.*quantity;
            xx += a * a;
            xy += a * turn.*quantity;
        }
    }
    const double spread = count * xx - x * x;
    return count >= 2.0 && spread > 0.0 ? std::optional{(count * xy - x * y) / spread} : std::nullopt;
}

Procedure steady_circle_procedure() {
    return {
        "steady-circle",
        "a circle of 100 m in steps of 0.5 m/s^2, both directions, until it is not kept or two wheels lift",
        {"ISO 4138:2021, method 1 (constant radius), 8.3 and 8.4"},
        run_steady_circle};
}

}  // namespace sil
