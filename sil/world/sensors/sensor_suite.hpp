// SensorSuite: all sensors of the car together, from the truth to the sample that goes on the bus.
#pragma once

#include "sil/world/sensors/imu.hpp"
#include "sil/world/sensors/roll_sensor.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/sensors/sensor_sample.hpp"
#include "sil/world/sensors/vehicle_motion_sensor.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

class SensorSuite {
 public:
    explicit SensorSuite(const SensorOptions& options);

    // To be called at every step of the simulation (1 ms).
    void observe(const Truth& truth);

    // To be called at every bus cycle (10 ms), after observe() of the same truth: the IMU's mean since the
    // last report, everything else as it is now. The sample bears the truth's time.
    SensorSample report(const Truth& truth);

 private:
    Imu imu_;
    RollSensor roll_;
    VehicleMotionSensor motion_;
    MassSensorOptions mass_;
};

}  // namespace sil
