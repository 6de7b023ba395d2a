#include "tests/identification/simulated_drive.hpp"

#include <algorithm>
#include <cmath>

#include "sil/manoeuvres/manoeuvre_run.hpp"
#include "sil/sensors/sensor_suite.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/units.hpp"
#include "sil/vehicle/parameter_file.hpp"

namespace identification_test {
namespace {

constexpr int steps_a_cycle = 10;

sil::DriveSample recorded(const sil::SensorSample& sensors, const sil::Truth& truth, const DriveRequest& request) {
    sil::DriveSample sample;
    sample.time_s = sensors.time_s;
    sample.speed_mps = sensors.speed_mps;
    sample.lateral_specific_force_mps2 =
        sensors.lateral_acceleration_mps2 + request.lateral_bias_g * sil::g_mps2;
    sample.vertical_specific_force_mps2 = sensors.vertical_acceleration_mps2;
    sample.roll_rate_radps = sensors.roll_rate_radps;
    sample.yaw_rate_radps = sensors.yaw_rate_radps;
    sample.roll_angle_rad = sensors.roll_angle_rad + request.roll_bias_deg / sil::degrees_per_radian;
    sample.steering_wheel_angle_rad = sensors.steering_wheel_angle_rad;
    if (request.wheel_loads) {
        sample.wheel_load_n = truth.wheel_load_n;
    }
    return sample;
}

sil::SensorOptions sensors_of(const sil::VehicleParameters& vehicle, const DriveRequest& request) {
    sil::SensorFlaws flaws;
    flaws.noise = request.noise;
    flaws.seed = request.seed;
    return sil::mounted_sensors(vehicle, flaws);
}

}  // namespace

sil::Drive simulate(const sil::VehicleParameters& vehicle, const DriveRequest& request) {
    sil::Manoeuvre manoeuvre;
    manoeuvre.duration_s = request.duration_s;
    manoeuvre.initial_speed_mps = sil::from_kmh(request.speed_kmh);
    manoeuvre.make_road = sil::flat_road();
    manoeuvre.make_driver = sil::open_loop([handwheel_deg = request.handwheel_deg](double time_s) {
        return sil::DriverCommand{sil::from_degrees(handwheel_deg(time_s))};
    });
    sil::ManoeuvreRun run{vehicle, manoeuvre};
    sil::SensorSuite sensors{sensors_of(vehicle, request)};
    sil::Drive drive;
    drive.name = request.name;
    for (int step = 1; !run.finished(); ++step) {
        run.step();
        sensors.observe(run.truth());
        if (step % steps_a_cycle == 0) {
            drive.samples.push_back(recorded(sensors.report(run.truth()), run.truth(), request));
        }
    }
    return drive;
}

DriveRequest slow_ramp(double side) {
    DriveRequest request;
    request.name = side > 0.0 ? "slow_ramp_left" : "slow_ramp_right";
    request.duration_s = 35.0;
    request.handwheel_deg = [side](double time_s) { return side * 3.0 * std::max(time_s - 1.0, 0.0); };
    return request;
}

DriveRequest step_steer(double angle_deg) {
    DriveRequest request;
    request.name = "step_steer";
    request.duration_s = 12.0;
    request.handwheel_deg = [angle_deg](double time_s) {
        return std::clamp(250.0 * (time_s - 1.0), 0.0, angle_deg) -
               std::clamp(250.0 * (time_s - 6.0), 0.0, angle_deg);
    };
    return request;
}

DriveRequest lane_change() {
    DriveRequest request;
    request.name = "lane_change";
    request.duration_s = 8.0;
    request.handwheel_deg = [](double time_s) {
        constexpr double pi = 3.14159265358979323846;
        return 40.0 * std::sin(2.0 * pi * std::clamp(0.5 * (time_s - 1.0), 0.0, 1.0));
    };
    return request;
}

sil::VehicleParameters simulated_vehicle(const std::string& name) {
    return sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/" + name + ".toml");
}

sil::VehicleData data_sheet_of(const sil::VehicleParameters& vehicle) {
    sil::VehicleData data;
    data.name = vehicle.name;
    data.total_mass_kg = sil::total_mass_kg(vehicle);
    data.sprung_mass_kg = vehicle.mass.sprung_kg;
    data.unsprung_mass_kg = data.total_mass_kg - data.sprung_mass_kg;
    data.sprung_cg_height_m = vehicle.geometry.cg_height_m;
    data.unsprung_cg_height_m = vehicle.geometry.wheel_radius_m;
    data.track_width_m = vehicle.geometry.track_width_m;
    data.wheelbase_m = vehicle.geometry.front_axle_to_cg_m + vehicle.geometry.rear_axle_to_cg_m;
    data.steering_ratio = vehicle.steering.ratio;
    data.imu_x_m = vehicle.imu_mount.x_m;
    data.imu_y_m = vehicle.imu_mount.y_m;
    data.imu_z_m = vehicle.imu_mount.z_m;
    return data;
}

}  // namespace identification_test
