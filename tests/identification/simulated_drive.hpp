// Simulated drive: what a recorder on board of a simulated vehicle would have written.
#pragma once

#include <functional>
#include <string>

#include "sil/drives/drive.hpp"
#include "sil/identification/vehicle_data.hpp"
#include "sil/sensors/sensor_options.hpp"
#include "sil/vehicle/parameters.hpp"

namespace identification_test {

// Handwheel angle in degrees over the time in seconds.
using Handwheel = std::function<double(double)>;

struct DriveRequest {
    std::string name{};
    double speed_kmh{60.0};
    double duration_s{28.0};
    Handwheel handwheel_deg{};
    bool noise{false};
    std::uint64_t seed{1U};
    bool wheel_loads{true};
    double lateral_bias_g{0.0};
    double roll_bias_deg{0.0};
};

// With the IMU where the vehicle's file has it.
sil::Drive simulate(const sil::VehicleParameters& vehicle, const DriveRequest& request);

// 3 deg/s at 60 km/h from t = 1 s, for 35 s; `side` is 1 to the left and -1 to the right.
DriveRequest slow_ramp(double side = 1.0);
// 250 deg/s to `angle` at 60 km/h at t = 1 s, back at 6 s.
DriveRequest step_steer(double angle_deg = 40.0);
DriveRequest lane_change();

sil::VehicleParameters simulated_vehicle(const std::string& name);
// What its data sheet would say: no roll centre, no inertia.
sil::VehicleData data_sheet_of(const sil::VehicleParameters& vehicle);

}  // namespace identification_test
