// SensorOptions: where the sensors sit and how imperfect they are.
#pragma once

#include <cstdint>

namespace sil {

// One measured quantity, in the unit of the quantity: reported = round((true + bias + noise) / step) * step,
// of so many reports before.
struct ChannelOptions {
    double noise_rms{0.0};          // standard deviation of the white noise on each reported value, >= 0
    double bias{0.0};               // not a number: the sensor reports "not available"
    double quantisation_step{0.0};  // 0: none; the CAN encoding quantises in any case
    unsigned reports_late{0U};      // a report is one bus cycle
    unsigned reports_a_value{1U};   // a slow sensor's value is reported so often
};

// Position in body axes relative to the sprung mass's centre of gravity.
struct MountingPosition {
    double x_m{0.0};  // forward
    double y_m{0.0};  // left
    double z_m{0.0};  // up
};

// By how much a sensor's housing is turned against the body: first about z, then about its new y, then about
// its new x axis.
struct MountingTilt {
    double roll_rad{0.0};
    double pitch_rad{0.0};
    double yaw_rad{0.0};
};

struct ImuOptions {
    MountingPosition position;
    MountingTilt tilt;
    bool averaged{true};  // false: no decimation filter; each report is the value of its instant
    ChannelOptions lateral_acceleration_mps2;
    ChannelOptions vertical_acceleration_mps2;
    ChannelOptions roll_rate_radps;
};

// Reference of a roll angle.
enum class RollReference : std::uint8_t {
    road,     // by the suspension's travel, as few vehicles do
    horizon,  // by an attitude sensor; the road's bank is in it
};

struct RollSensorOptions {
    RollReference reference{RollReference::road};
    ChannelOptions roll_angle_rad;
    bool reports_bank{false};  // most cars have no sensor for the road's bank
    ChannelOptions bank_angle_rad;
};

struct VehicleMotionOptions {
    ChannelOptions speed_mps;
    ChannelOptions yaw_rate_radps;
    ChannelOptions steering_wheel_angle_rad;
};

// Axle loads added up, as trucks and buses have them on the bus. Its error is that of the springs or the air
// it weighs with, and stays as it is over a run.
struct MassSensorOptions {
    bool fitted{false};
    double scale_error{0.0};  // reported = true (1 + scale_error)
};

// By how much such a sensor may be wrong, either way.
inline constexpr double mass_sensor_accuracy = 0.03;

// The default is ideal: at the centre of gravity, no noise, no bias, no quantisation.
struct SensorOptions {
    std::uint64_t seed{1U};  // the same seed gives the same noise, bit for bit
    ImuOptions imu;
    RollSensorOptions roll;
    VehicleMotionOptions motion;
    MassSensorOptions mass;
};

// Remaining bias of the accelerometers, on the lateral and the vertical axis alike.
enum class AccelerometerBias : std::uint8_t {
    none,
    after_zeroing,  // 0.005 g: the ECU has learnt the offset at standstill
    raw,            // 0.03 g: as delivered
};

// Automotive sensors of ordinary quality. Noise, rms: 0.02 g, 0.3 deg/s (roll and yaw), 0.2 deg (roll and
// bank angle), and of the vehicle's motion 0.1 km/h and 0.1 deg at the steering wheel. A mass sensor is not
// fitted, but where one is, it is wrong by a share that the seed decides.
SensorOptions noisy_sensors(std::uint64_t seed, AccelerometerBias bias = AccelerometerBias::none);

}  // namespace sil
