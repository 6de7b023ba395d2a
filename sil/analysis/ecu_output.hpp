// EcuOutput: what the ECU's frames said, decoded, in SI units.
#pragma once

#include <cstdint>
#include <limits>

namespace sil {

// The numbers are those of the signals State and Side in the frame RolloverWarning.
enum class WarningState : std::uint8_t { unavailable = 0, ready = 1, advisory = 2, warning = 3 };
enum class WarningSide : std::uint8_t {
    none = 0,
    left = 1,
    right = 2
};  // towards which the vehicle would fall

// "unavailable", "ready", ... ; "none", "left", "right".
const char* to_string(WarningState state);
const char* to_string(WarningSide side);

// A value that the frame called "not available", or that has never been received, is NaN.
struct EcuOutput {
    static constexpr double not_available = std::numeric_limits<double>::quiet_NaN();

    WarningState state{WarningState::unavailable};
    WarningSide side{WarningSide::none};
    double roll_stability_indicator{not_available};
    double lateral_acceleration_mps2{not_available};
    double lateral_acceleration_threshold_mps2{not_available};

    double roll_centre_vertical_movement_m{not_available};
    double roll_centre_lateral_movement_m{not_available};
    double roll_stiffness_deviation_nmprad{not_available};
    double roll_damping_deviation_nmsprad{not_available};
};

}  // namespace sil
