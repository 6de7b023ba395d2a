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

enum class RollSource : std::uint8_t { none = 0, sensor = 1, observer = 2 };  // of the roll angle in use

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
    double roll_centre_deviation_m{not_available};  // standard deviation of the vertical movement

    double predicted_load_transfer_ratio{not_available};
    double predicted_rsi{not_available};
    double load_transfer_ratio{not_available};
    double extended_rsi{not_available};
    double published_rsi{not_available};
    double bank_free_rsi{not_available};
    double dynamic_stability_index{not_available};
    double energy_margin{not_available};
    double rollover_index{not_available};
    double time_to_rollover_s{not_available};

    double observed_roll_angle_rad{not_available};
    double observed_bank_angle_rad{not_available};
    RollSource roll_source{RollSource::none};
    bool roll_sensor_disagrees{false};
    bool estimate_frozen{false};
};

}  // namespace sil
