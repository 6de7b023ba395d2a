// Recorded drive: what the sensors report in a drive without faults. The ECU only warns, so no answer of its
// changes the drive: one recording serves every fault.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/sensors/sensor_sample.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

inline constexpr std::uint64_t recording_noise_seed = 5U;
inline constexpr double recorded_roll_rad = 1.2;  // beyond it the vehicle has rolled over
inline constexpr int recorded_steps = 10;         // a cycle

struct RecordedDrive {
    std::vector<SensorSample> samples{};  // one a cycle
    // True load transfer ratio in each cycle, > 0 when the right wheels carry more; -1 or 1 when the others
    // carry nothing.
    std::vector<double> load_transfer{};
    std::optional<std::size_t> two_wheel_lift{};  // cycle in which both wheels of a side have lifted
};

// When a fault begins and ends in it.
struct FaultedDrive : RecordedDrive {
    std::size_t fault_begin{0U};  // cycle
    std::size_t fault_end{0U};    // cycle after the last one; samples.size() when the drive ends first
    // An intermittent fault, in cycles: it is there for `fault_burst` of each `fault_period`; 0: all the
    // time.
    std::size_t fault_period{0U};
    std::size_t fault_burst{0U};

    bool has_fault(std::size_t cycle) const {
        const bool in_time = cycle >= fault_begin && cycle < fault_end;
        return in_time && (fault_period == 0U || (cycle - fault_begin) % fault_period < fault_burst);
    }
};

// The number of cycles in that time.
std::size_t cycle_count(double seconds);

// Noisy sensors of ordinary quality, one of the bank and one of the mass.
SensorOptions recording_sensors(const VehicleParameters& vehicle);

// One recording for each set of sensors, all of the same drive. Ends when the manoeuvre does or the vehicle
// has rolled over.
std::vector<RecordedDrive> record_drive(const VehicleParameters& vehicle, const Manoeuvre& manoeuvre,
                                        const RunOptions& options, const std::vector<SensorOptions>& sensors);

// The tyre model needs a rolling wheel, so a vehicle at rest is written down instead of driven.
std::vector<RecordedDrive> record_rest(const VehicleParameters& vehicle, double duration_s,
                                       const std::vector<SensorOptions>& sensors);

// Without its cycles before `begin` and from `end` on.
RecordedDrive part_of(const RecordedDrive& drive, std::size_t begin, std::size_t end);

// The first seconds as `lead_in` is driven, or straight ahead at the manoeuvre's speed where there is none;
// then the manoeuvre.
Manoeuvre with_lead_in(const Manoeuvre& manoeuvre, double lead_in_s, const Manoeuvre* lead_in = nullptr);

}  // namespace sil
