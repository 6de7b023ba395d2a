#include "sil/studies/campaign/drawn_run.hpp"

#include <algorithm>
#include <cmath>

#include "rsi/model/critical_roll_angle.hpp"
#include "rsi/model/vehicle_lengths.hpp"
#include "sil/files/parameter_field.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/slow_turn.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/mixed_driving.hpp"
#include "sil/world/sensors/sensor_sample.hpp"
#include "sil/world/vehicle/load.hpp"

namespace sil {
namespace {

constexpr float least_damping_time_s = 1.01F * 0.005F;  // c_f / K_f that the component admits, and a little

float with_error(double truth, double error) {
    return static_cast<float>(truth * (1.0 + error));
}

float admitted(float rsi::Parameters::* member, float value) {
    const rsi::ParameterField& field = parameter_field(member);
    return std::clamp(value, field.minimum, field.maximum);
}

// A slow turn at the printed threshold, (23): from it `identify` writes the references of the rollover index.
struct SlowTurn {
    double angle_rad;
    double acceleration_mps2;
};

SlowTurn at_threshold(const rsi::Parameters& calibration) {
    const double angle_rad = static_cast<double>(rsi::critical_roll_angle_rad(calibration));
    const RollLengths lengths{static_cast<double>(calibration.track_width_m),
                              static_cast<double>(calibration.sprung_cg_height_m),
                              static_cast<double>(rsi::roll_arm_m(calibration))};
    return {angle_rad, acceleration_at_threshold_mps2(lengths, angle_rad)};
}

// A wrong height or stiffness makes wrong references of the rollover index.
void carry_into_references(rsi::Parameters& mistaken, const rsi::Parameters& calibration) {
    const SlowTurn wrong = at_threshold(mistaken);
    const SlowTurn right = at_threshold(calibration);
    const auto scale = [&mistaken](float rsi::Parameters::* reference, double factor) {
        if (std::isfinite(factor)) {
            mistaken.*reference =
                admitted(reference, static_cast<float>(static_cast<double>(mistaken.*reference) * factor));
        }
    };
    scale(&rsi::Parameters::rollover_index_roll_angle_rad, wrong.angle_rad / right.angle_rad);
    scale(&rsi::Parameters::rollover_index_acceleration_mps2,
          wrong.acceleration_mps2 / right.acceleration_mps2);
}

// Mass and CG height are the calibration's, as the run's load and manoeuvre change those of the vehicle as
// built, and wrong by the drawn shares: whatever the load changes is a part of the error and not on top of
// it. Unless the settings say that the load is unknown.
rsi::Parameters mistaken(const rsi::Parameters& given, const VehicleParameters& as_built,
                         const VehicleParameters& truth, const CampaignSpread& spread, const RunDraw& draw) {
    rsi::Parameters calibration = given;
    const double mass_factor = spread.load_is_known ? truth.mass.sprung_kg / as_built.mass.sprung_kg : 1.0;
    const double height_factor =
        spread.load_is_known ? truth.geometry.cg_height_m / as_built.geometry.cg_height_m : 1.0;
    calibration.sprung_mass_kg =
        with_error(static_cast<double>(given.sprung_mass_kg) * mass_factor, draw.mass_error);
    calibration.sprung_cg_height_m =
        with_error(static_cast<double>(given.sprung_cg_height_m) * height_factor, draw.cg_height_error);
    // The whole curve of the roll stiffness by the same share, as far as the component admits it.
    for (float rsi::Parameters::* const coefficient :
         {&rsi::Parameters::roll_stiffness_nmprad, &rsi::Parameters::roll_stiffness_cubic_nmprad3,
          &rsi::Parameters::roll_stiffness_quintic_nmprad5}) {
        calibration.*coefficient = admitted(
            coefficient, with_error(static_cast<double>(calibration.*coefficient), draw.stiffness_error));
    }
    // `identify` writes the least damping that the component admits where it finds less; it grows with the
    // stiffness.
    calibration.roll_damping_nmsprad =
        std::max(calibration.roll_damping_nmsprad, least_damping_time_s * calibration.roll_stiffness_nmprad);
    carry_into_references(calibration, given);
    return calibration;
}

}  // namespace

SensorOptions drawn_sensors(const CampaignSettings& settings, const RunDraw& draw,
                            const VehicleParameters& vehicle) {
    const CampaignSpread& spread = settings.spread;
    SensorFlaws flaws;
    flaws.noise = spread.sensor_noise;
    flaws.attitude_sensor = spread.attitude_sensor;
    flaws.mass_sensor = settings.vehicles[draw.vehicle].mass_sensor;
    flaws.seed = draw.sensor_seed;
    SensorOptions sensors = mounted_sensors(vehicle, flaws);
    sensors.imu.lateral_acceleration_mps2.bias = draw.lateral_bias_g * g_mps2;
    sensors.imu.vertical_acceleration_mps2.bias = draw.vertical_bias_g * g_mps2;
    const auto& tilt = draw.housing_tilt_deg;
    sensors.imu.tilt = {tilt[0] / degrees_per_radian, tilt[1] / degrees_per_radian,
                        tilt[2] / degrees_per_radian};
    // The calibration has the place that the vehicle's data have.
    sensors.imu.position.x_m += draw.lever_arm_error_m[0];
    sensors.imu.position.y_m += draw.lever_arm_error_m[1];
    sensors.imu.position.z_m += draw.lever_arm_error_m[2];
    sensors.mass.scale_error = draw.mass_sensor_error;
    if (!spread.steering_sensor) {
        sensors.motion.steering_wheel_angle_rad.bias = SensorSample::not_available;
    }
    if (!spread.roll_sensor) {
        sensors.roll.roll_angle_rad.bias = SensorSample::not_available;
    }
    return sensors;
}

DrawnRun drawn_run(const CampaignSettings& settings, const RunDraw& draw, const VehicleParameters& vehicle,
                   const rsi::Parameters& calibration, const Manoeuvre& manoeuvre) {
    DrawnRun run;
    run.draw = draw;
    run.manoeuvre = manoeuvre;
    run.options.steering_factor = draw.steering_factor;
    // Random drivers are redrawn each run and target an acceleration, not an angle.
    if (manoeuvre.name == ordinary_driving_name) {
        run.manoeuvre = ordinary_driving(draw.sensor_seed, ordinary_driving_s, draw.steering_factor);
        run.options.steering_factor = 1.0;
    }
    // The rate is that of the hands, which the factor on the angle must not change.
    if (draw.handwheel_rate_degps > 0.0 && manoeuvre.make_driver_at_rate &&
        run.options.steering_factor > 0.0) {
        run.manoeuvre.make_driver =
            at_rate(manoeuvre.make_driver_at_rate,
                    from_degrees(draw.handwheel_rate_degps) / run.options.steering_factor);
    }
    run.vehicle = vehicle;
    // The manoeuvre's changes to the vehicle belong to the truth that load and errors are counted from.
    if (manoeuvre.adapt_vehicle) {
        run.vehicle = manoeuvre.adapt_vehicle(run.vehicle);
        run.manoeuvre.adapt_vehicle = {};
    }
    run.vehicle = with_load(run.vehicle, draw.load_share * run.vehicle.mass.sprung_kg,
                            draw.load_height_factor * run.vehicle.geometry.cg_height_m);
    run.vehicle = with_friction(run.vehicle, draw.friction_factor);
    run.calibration = mistaken(calibration, vehicle, run.vehicle, settings.spread, draw);
    run.options.mirrored = draw.mirrored;
    run.options.road_seed = draw.sensor_seed;
    run.options.speed_factor = draw.speed_factor;
    run.options.duration_s = settings.manoeuvres[draw.manoeuvre].duration_s;
    run.sensors = drawn_sensors(settings, draw, run.vehicle);
    return run;
}

}  // namespace sil
