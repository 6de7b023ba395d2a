#include "sil/studies/faults/driving_state.hpp"

#include <algorithm>
#include <utility>

#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/everyday_turns.hpp"
#include "sil/world/manoeuvres/mixed_driving.hpp"

namespace sil {
namespace {

constexpr double settled_s = 4.0;                   // from the start to a fault that is not there at once
constexpr double ordinary_s = 8.0 * gentle_turn_s;  // whole turns
constexpr double gathering_speed_s = 8.0;           // straight ahead, before the J-turn
constexpr double ten_minutes_s = 600.0;
constexpr std::uint64_t ordinary_driver = 3U;                 // seed
constexpr double everyday_share = 0.75;                       // of the accelerations of all ordinary drivers
constexpr double reset_s = ordinary_s - gentle_turn_s + 3.0;  // in the last of the turns
static_assert(ordinary_s - settled_s >= 60.0, "a minute");

using Recorded = std::vector<RecordedDrive>;  // one for each set of sensors
using States = std::vector<std::vector<DrivingState>>;

void add(States& states, const Recorded& drives, const DrivingState& like) {
    for (std::size_t index = 0U; index < drives.size(); ++index) {
        DrivingState state = like;
        static_cast<RecordedDrive&>(state) = drives[index];
        state.fault_end = state.samples.size();
        states[index].push_back(std::move(state));
    }
}

DrivingState state(const char* name, const char* description, double fault_begin_s) {
    DrivingState made;
    made.name = name;
    made.description = description;
    made.fault_begin = cycle_count(fault_begin_s);
    return made;
}

// The same without its first cycles.
Recorded cut(Recorded drives, std::size_t cycles) {
    for (RecordedDrive& drive : drives) {
        drive = part_of(drive, cycles, drive.samples.size());
    }
    return drives;
}

Manoeuvre j_turn_after_ordinary_driving() {
    const Manoeuvre gentle = gentle_turns(ordinary_s);
    return with_lead_in(with_lead_in(find_manoeuvre("j-turn-110"), gathering_speed_s), ordinary_s, &gentle);
}

}  // namespace

std::vector<std::vector<DrivingState>> record_states(const VehicleParameters& vehicle,
                                                     const std::vector<SensorOptions>& sensors) {
    const auto record = [&](const Manoeuvre& manoeuvre) {
        return record_drive(vehicle, manoeuvre, {}, sensors);
    };
    States states(sensors.size());
    add(states, record_rest(vehicle, 10.0, sensors),
        state("rest", "the vehicle stands for 10 s; the fault begins after 4 s, and stays", settled_s));
    add(states, record(slow_turns(12.0)),
        state("slow", "slow turns to either side at 12 km/h, for 12 s; the fault begins after 4 s, and stays",
              settled_s));
    add(states, record(with_lead_in(find_manoeuvre("j-turn-110"), settled_s)),
        state("from power-on",
              "the ECU starts, with the fault from its first cycle on; straight ahead for 5 s, then the "
              "J-turn at "
              "110 km/h that ends in a rollover",
              0.0));
    const Recorded minute = record(j_turn_after_ordinary_driving());
    add(states, cut(minute, cycle_count(reset_s)),
        state("after a reset in a turn",
              "the ECU starts, with the fault, in a turn of 0.2 g at 80 km/h, 14 s before that J-turn", 0.0));
    DrivingState long_state = state("a minute of ordinary driving",
                                    "turns of 0.2 g to either side at 80 km/h, then that J-turn; the fault "
                                    "begins after 4 s, 60 s before the "
                                    "last turn ends, and stays",
                                    settled_s);
    long_state.ordinary_end = cycle_count(ordinary_s);
    long_state.with_frame_faults = false;
    add(states, minute, long_state);
    return states;
}

std::vector<std::vector<DrivingState>> record_ten_minutes(const VehicleParameters& vehicle,
                                                          const std::vector<SensorOptions>& sensors) {
    const Manoeuvre j_turn = with_lead_in(find_manoeuvre("j-turn-110"), gathering_speed_s);
    const Manoeuvre ordinary = ordinary_driving(ordinary_driver, ten_minutes_s, everyday_share);
    States states(sensors.size());
    add(states, record_drive(vehicle, j_turn, {}, sensors),
        state("at once", "the ECU starts; straight ahead for 9 s, then the J-turn", 0.0));
    add(states, record_drive(vehicle, with_lead_in(j_turn, ten_minutes_s, &ordinary), {}, sensors),
        state("after ten minutes", "ordinary driving of 10 min, turns up to 0.3 g among it, before the same",
              0.0));
    return states;
}

std::vector<std::vector<DrivingState>> record_drives_of_good_sensors(
    const VehicleParameters& vehicle, const std::vector<SensorOptions>& sensors) {
    States states(sensors.size());
    for (const char* const name :
         {"slalom", "rough-turn", "fishhook-1a", "double-lane-change", "one-sided-bump"}) {
        Manoeuvre manoeuvre = find_manoeuvre(name);
        manoeuvre.duration_s = std::min(manoeuvre.duration_s, 20.0);
        add(states, record_drive(vehicle, manoeuvre, {}, sensors),
            state(name, manoeuvre.description.c_str(), 0.0));
    }
    return states;
}

}  // namespace sil
