// SensorSample: what the car's sensors report at one instant, ready to be encoded into CAN frames.
#pragma once

#include <limits>

namespace sil {

// Signs are ISO 8855. A value that is not available is NaN.
struct SensorSample {
    static constexpr double not_available = std::numeric_limits<double>::quiet_NaN();

    double time_s{not_available};

    // Specific force at the IMU's mounting point along the body's y and z axes; (0, +9.81) at rest and level.
    double lateral_acceleration_mps2{not_available};
    double vertical_acceleration_mps2{not_available};
    double roll_rate_radps{not_available};  // about the body's x axis

    double roll_angle_rad{not_available};  // body relative to the road, or to the horizon
    double bank_angle_rad{not_available};  // road, > 0 when the left side is up

    double speed_mps{not_available};       // never negative
    double yaw_rate_radps{not_available};  // about the body's z axis
    double steering_wheel_angle_rad{not_available};

    double vehicle_mass_kg{not_available};  // with what it carries, where control units know it
};

}  // namespace sil
