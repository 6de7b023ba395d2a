// Scenario: vehicles, weights and the events of a run.
#include "scenario.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/support/nominal_roll_model.hpp"

namespace scenario {
namespace {

constexpr double pi = 3.14159265358979323846;

// Model (1) with an explicit Euler step, and the threshold (22) with c_rc from (6). Bank is positive when the
// left side is up, so that it acts as a lateral acceleration to the left does.
class PublishedIndicator {
 public:
    explicit PublishedIndicator(const sil::VehicleParameters& parameters)
        : parameters_{parameters}, model_{rsi_test::nominal_roll_model(parameters.name)} {}

    double advance(const sil::Truth& truth, double step_s) {
        const double height = parameters_.geometry.cg_height_m;
        const double lever = height - model_.roll_centre_height_m;
        const double a_y = truth.lateral_acceleration_mps2;
        const double sine = std::sin(truth.bank_angle_rad);
        const double cosine = std::cos(truth.bank_angle_rad);
        const double along = a_y * cosine + sil::gravity_mps2 * sine;
        const double across = sil::gravity_mps2 * cosine - a_y * sine;
        const double moment = parameters_.mass.sprung_kg * lever * (along + across * std::tan(roll_));
        roll_ += step_s * (moment - model_.stiffness_nmprad * roll_) / model_.damping_nmsprad;
        const double side = a_y >= 0.0 ? 1.0 : -1.0;
        const double level =
            (0.5 * parameters_.geometry.track_width_m - side * lever * std::tan(roll_)) / height;
        const double bank = -side * std::tan(truth.bank_angle_rad);
        const double threshold = (bank + level) / (1.0 - bank * level);
        return std::abs(a_y) / (sil::gravity_mps2 * threshold);
    }

 private:
    const sil::VehicleParameters& parameters_;
    rsi_test::NominalRollModel model_;
    double roll_{0.0};
};

}  // namespace

double load_transfer(const sil::Truth& truth) {
    const auto& load = truth.wheel_load_n;
    const double left = load[sil::front_left] + load[sil::rear_left];
    const double right = load[sil::front_right] + load[sil::rear_right];
    return std::abs(right - left) / std::max(1.0, left + right);
}

sil::VehicleParameters large_suv() {
    return sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml");
}

sil::VehicleParameters ordinary_suv() {
    return sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/ordinary_suv.toml");
}

sil::VehicleParameters van() {
    return sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/van.toml");
}

sil::VehicleParameters symmetric(sil::VehicleParameters parameters) {
    parameters.rear_suspension.panhard_slope = 0.0;
    parameters.rear_suspension.panhard_length_m = 1.0e12;
    return parameters;
}

sil::VehicleParameters undamped(sil::VehicleParameters parameters) {
    for (sil::SpringDamperParameters* unit :
         {&parameters.front_suspension.spring_damper, &parameters.rear_suspension.spring_damper}) {
        unit->damper_bump_nspm = 0.0;
        unit->damper_rebound_nspm = 0.0;
    }
    parameters.tyre.vertical_damping_nspm = 0.0;
    return parameters;
}

sil::VehicleParameters twisting(sil::VehicleParameters parameters, double torsion_nmprad) {
    parameters.rear_suspension.frame_torsion_nmprad = torsion_nmprad;
    parameters.rear_suspension.frame_damping_nmsprad = 1000.0;
    parameters.rear_suspension.frame_rear_share = 0.5;
    return parameters;
}

sil::Manoeuvre manoeuvre(double speed_kmh, double duration_s,
                         std::function<sil::DriverCommand(double)> command) {
    sil::Manoeuvre result;
    result.name = "test";
    result.duration_s = duration_s;
    result.initial_speed_mps = sil::from_kmh(speed_kmh);
    result.make_road = sil::flat_road();
    result.make_driver = sil::open_loop(std::move(command));
    return result;
}

double front_axle_weight_n(const sil::VehicleParameters& p) {
    const double share =
        p.geometry.rear_axle_to_cg_m / (p.geometry.front_axle_to_cg_m + p.geometry.rear_axle_to_cg_m);
    return sil::gravity_mps2 * (p.mass.sprung_kg * share + 2.0 * p.mass.front_unsprung_kg);
}

double rear_axle_weight_n(const sil::VehicleParameters& p) {
    return sil::gravity_mps2 * sil::total_mass_kg(p) - front_axle_weight_n(p);
}

double total_cg_height_m(const sil::VehicleParameters& p) {
    const double front_wheel_height =
        p.geometry.wheel_radius_m - 0.5 * front_axle_weight_n(p) / p.tyre.vertical_stiffness_npm;
    const double rear_wheel_height =
        p.geometry.wheel_radius_m - 0.5 * rear_axle_weight_n(p) / p.tyre.vertical_stiffness_npm;
    return (p.mass.sprung_kg * p.geometry.cg_height_m + 2.0 * p.mass.front_unsprung_kg * front_wheel_height +
            p.mass.rear_axle_kg * rear_wheel_height) /
           sil::total_mass_kg(p);
}

Outcome drive(const sil::VehicleParameters& parameters, const sil::Manoeuvre& manoeuvre,
              sil::RunOptions options) {
    sil::ManoeuvreRun run{parameters, manoeuvre, options};
    PublishedIndicator indicator{run.vehicle().parameters()};
    Outcome outcome;
    while (!run.finished()) {
        run.step();
        const sil::Truth& truth = run.truth();
        const double ay_g = std::abs(truth.lateral_acceleration_mps2) / sil::gravity_mps2;
        const double rsi = indicator.advance(truth, options.step_s);
        const bool one = std::any_of(truth.wheel_load_n.begin(), truth.wheel_load_n.end(),
                                     [](double load_n) { return load_n <= 0.0; });
        const bool two = two_wheels_have_lifted(truth);
        outcome.largest_ay_g = std::max(outcome.largest_ay_g, ay_g);
        outcome.largest_roll_deg =
            std::max(outcome.largest_roll_deg, std::abs(truth.roll_angle_rad) * 180.0 / pi);
        outcome.largest_load_transfer = std::max(outcome.largest_load_transfer, load_transfer(truth));
        if (outcome.two_wheel_lift_s == not_yet) {
            outcome.largest_ay_until_lift_g = std::max(outcome.largest_ay_until_lift_g, ay_g);
            outcome.largest_rsi = std::max(outcome.largest_rsi, rsi);
        }
        if (one && outcome.one_wheel_lift_s == not_yet) {
            outcome.one_wheel_lift_s = truth.time_s;
        }
        if (two && outcome.two_wheel_lift_s == not_yet) {
            outcome.two_wheel_lift_s = truth.time_s;
            outcome.two_wheel_lift_ay_g = ay_g;
            outcome.two_wheel_lift_horizon_deg = std::abs(truth.roll_to_horizon_rad) * 180.0 / pi;
        }
        if (rsi >= 1.0 && outcome.rsi_crossing_s == not_yet) {
            outcome.rsi_crossing_s = truth.time_s;
            outcome.rsi_crossing_ay_g = ay_g;
        }
        if (ay_g >= sil::static_stability_factor(run.vehicle().parameters()) &&
            outcome.ssf_crossing_s == not_yet) {
            outcome.ssf_crossing_s = truth.time_s;
        }
    }
    outcome.final_ay_g = run.truth().lateral_acceleration_mps2 / sil::gravity_mps2;
    outcome.final_roll_deg = run.truth().roll_angle_rad * 180.0 / pi;
    return outcome;
}

}  // namespace scenario
