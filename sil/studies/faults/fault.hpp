// Fault: what goes wrong with one input, with the bus or with the ECU's processor.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sil {

enum class FaultKind : std::uint8_t {
    none,

    // Faults of a signal: the frame that carries it is protected as ever.
    frozen,         // the value of the fault's first cycle stays
    offset,         // by `magnitude`, which has a sign
    drift,          // by `magnitude` a second, likewise
    noise,          // white, `magnitude` rms
    sign_flip,      //
    saturated,      // at an end of the signal's range: the lower one when `magnitude` is negative
    not_available,  // its code
    out_of_range,   // a code beyond the signal's range
    gain,           // times `magnitude`
    noise_alone,    // a dead sensor: noise around zero, `magnitude` rms
    // Faults of a frame, after its protection.
    lost,            //
    delayed,         // by `magnitude` milliseconds: a gap at first, then each frame late
    bad_crc,         //
    counter_stands,  // each frame with the counter of the fault's first one, and a right CRC
    counter_jumps,   // six on with each frame, and a right CRC
    swapped,         // identifiers exchanged with the next sensor frame's
    doubled,         // each frame twice
    wrong_length,    // one byte short
    // A second sender, whose frames have a right CRC and a right counter; `magnitude` says of what kind its
    // content is (faulty_bus.cpp).
    sender_before,   // its frame comes just before the genuine one, with the same counter
    sender_after,    // just after it, with the next counter
    sender_tenfold,  // ten frames a cycle, with a counter of their own
    flood_foreign,   // `magnitude` frames a cycle of an identifier that the ECU does not receive
    flood_own,       // `magnitude` damaged frames a cycle with the identifier of Imu
    bus_off,         // of the ECU's controller
    error_passive,   // the same
    clock_jump,      // of the ECU's clock, once, by `magnitude` milliseconds
    process_stop,    // the ECU computes nothing for `magnitude` milliseconds, then goes on
    // A housing that is turned about its x axis, or its z axis, by `magnitude`: sets of sensors
    // (turned_housings.hpp)
    turned_about_x,
    turned_about_z,
};

enum class FaultPlace : std::uint8_t {
    lateral_acceleration,
    vertical_acceleration,
    roll_rate,
    roll_angle,
    bank_angle,
    speed,
    yaw_rate,
    steering_wheel_angle,
    vehicle_mass,
    imu_frame,
    roll_angle_frame,
    vehicle_motion_frame,
    all_sensor_frames,
    warning_frame,  // of the ECU itself
    bus,
    processor,
    // Signals that share a housing, a supply, a connector.
    inertial_signals,
    motion_signals,
    all_signals,
};

struct Fault {
    FaultKind kind{};
    FaultPlace place{};
    double magnitude{0.0};  // in the unit that the kind names; of a signal in that of SensorSample
};

const char* to_string(FaultKind kind);
const char* to_string(FaultPlace place);

// "offset, +2 m/s^2": kind and magnitude as text.
std::string describe(const Fault& fault);

// "offset, ±2 m/s^2": the same of all of in_each_sign().
std::string describe_each_sign(const Fault& fault);

constexpr bool is_signal_fault(FaultKind kind) {
    return kind > FaultKind::none && kind <= FaultKind::noise_alone;
}

constexpr bool is_second_sender(FaultKind kind) {
    return kind >= FaultKind::sender_before && kind <= FaultKind::sender_tenfold;
}

// The fault, and where its error can have either sign, with the other one too.
std::vector<Fault> in_each_sign(const Fault& fault);

// Every fault of the matrix, in its order; of those with a sign only the positive ones.
const std::vector<Fault>& all_faults();

// Those of the vehicle's mass, which few vehicles have on the bus: in every matrix.
const std::vector<Fault>& mass_faults();

// For the matrix of states: of signals that fail together. Gains stand for a supply, missing values for a
// connector.
const std::vector<Fault>& coupled_faults();

// Tolerances of good sensors, for the matrix of states: small offsets and gains, one signal at a time.
const std::vector<Fault>& tolerances();

// The further ones that the matrix of states has: gains, dead sensors, large offsets, second senders.
const std::vector<Fault>& further_faults();

}  // namespace sil
