// Prepared drive: a drive's signals freed of offsets, filtered alike, carried to the sprung mass's centre of
// gravity, and cut where the first wheel lifts or, where nothing shows that, where one may have.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sil/studies/drives/drive.hpp"
#include "sil/studies/identification/drive_signals.hpp"
#include "sil/studies/identification/vehicle_data.hpp"

namespace sil {

struct PreparationOptions {
    double filter_lag_s{0.03};
    double until_s{1.0e9};  // on the drive's clock; what comes later is not used
    // Without wheel loads: |A/N| stays below this share of c_w / (2 h), where both inner wheels lift. The
    // first of them may lift before.
    double lift_share{0.85};
};

// One sample. Letters are those of docs/theory.md.
struct RollSample {
    double time_s;
    double parallel_mps2;     // A
    double normal_mps2;       // N
    double overturning_mps2;  // f = A + N tan phi
    double roll_angle_rad;
    double roll_rate_radps;
    double roll_acceleration_radps2;
    double yaw_rate_radps;            // NaN where the drive has none
    double speed_mps;                 // NaN where the drive has none
    double steering_wheel_angle_rad;  // NaN where the drive has none
    double load_moment_nm;            // c_w/2 (F_zR - F_zL), NaN where the drive has no wheel loads
};

// Means over the straight start, already taken off the samples.
struct SensorOffsets {
    bool known{false};      // false: the drive does not start straight
    std::string judged_by;  // the signal that tells straight from turn
    double straight_s{0.0};
    double lateral_mps2{0.0};
    double roll_angle_rad{0.0};
    double roll_rate_radps{0.0};
    double yaw_rate_radps{0.0};
    double steering_wheel_angle_rad{0.0};
    double load_moment_nm{0.0};
};

struct PreparedDrive {
    std::string name;
    std::vector<RollSample> samples;
    SensorOffsets offsets;
    std::optional<double> cut_s;       // nothing later was used
    std::string cut_reason;            // in words, empty when nothing was cut
    bool cut_by_load_transfer{false};  // where a wheel lifts or is near it
    bool has_wheel_loads{false};
    bool has_steering{false};  // steering, speed and yaw rate
    double largest_parallel_mps2{0.0};
    double largest_roll_angle_rad{0.0};
};

// Throws IdentificationError when the drive has no roll angle or too few samples before the first lift.
PreparedDrive prepare_drive(const Drive& drive, const VehicleData& vehicle,
                            const PreparationOptions& options);

}  // namespace sil
