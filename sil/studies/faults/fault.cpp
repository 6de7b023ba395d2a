// The faults of the matrix: every kind at every place where it can happen.
#include "sil/studies/faults/fault.hpp"

#include <fmt/format.h>

#include <array>

#include "sil/studies/faults/sensor_signal.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr std::array signal_kinds{FaultKind::frozen,        FaultKind::offset,      FaultKind::drift,
                                  FaultKind::noise,         FaultKind::sign_flip,   FaultKind::saturated,
                                  FaultKind::not_available, FaultKind::out_of_range};

constexpr std::array sensor_frames{FaultPlace::imu_frame, FaultPlace::roll_angle_frame,
                                   FaultPlace::vehicle_motion_frame};

struct FrameFault {
    FaultKind kind;
    double magnitude;
};
constexpr std::array frame_faults{
    FrameFault{FaultKind::lost, 0.0},           FrameFault{FaultKind::delayed, 20.0},
    FrameFault{FaultKind::delayed, 100.0},      FrameFault{FaultKind::bad_crc, 0.0},
    FrameFault{FaultKind::counter_stands, 0.0}, FrameFault{FaultKind::counter_jumps, 0.0},
    FrameFault{FaultKind::swapped, 0.0},        FrameFault{FaultKind::doubled, 0.0},
    FrameFault{FaultKind::wrong_length, 0.0}};

constexpr std::array other_faults{Fault{FaultKind::lost, FaultPlace::all_sensor_frames, 0.0},
                                  Fault{FaultKind::bad_crc, FaultPlace::all_sensor_frames, 0.0},
                                  Fault{FaultKind::flood_foreign, FaultPlace::bus, 40.0},
                                  Fault{FaultKind::flood_foreign, FaultPlace::bus, 100.0},
                                  Fault{FaultKind::flood_own, FaultPlace::bus, 40.0},
                                  Fault{FaultKind::flood_own, FaultPlace::bus, 100.0},
                                  Fault{FaultKind::error_passive, FaultPlace::bus, 0.0},
                                  Fault{FaultKind::bus_off, FaultPlace::bus, 0.0},
                                  Fault{FaultKind::clock_jump, FaultPlace::processor, 1000.0},
                                  Fault{FaultKind::clock_jump, FaultPlace::processor, -1000.0},
                                  Fault{FaultKind::process_stop, FaultPlace::processor, 20.0},
                                  Fault{FaultKind::process_stop, FaultPlace::processor, 200.0},
                                  Fault{FaultKind::process_stop, FaultPlace::processor, 2000.0}};

constexpr std::array gains{0.0, 0.2, 0.5, 0.8, 1.25, 2.0, 3.0};

constexpr std::array mass_gains{0.7, 0.8, 1.2, 1.3, 1.6, 2.0};

// A supply that fails: off, too low or too high for sensors whose output follows it.
constexpr std::array supply_gains{0.0, 0.8, 0.9, 1.1, 1.25};

// Tolerances of good sensors: share of the matrix' offset, and gains.
constexpr double offset_tolerance = 0.25;
constexpr std::array gain_tolerances{0.95, 1.05};

// Factor on the matrix' offset: the largest is about the end of the sensor's range.
constexpr std::array offset_shares{2.0, 4.0, 8.0};

constexpr std::array second_senders{FaultKind::sender_before, FaultKind::sender_after,
                                    FaultKind::sender_tenfold};

double magnitude_of(FaultKind kind, const SensorSignal& signal) {
    switch (kind) {
        case FaultKind::offset:
            return signal.offset * signal.unit_si;
        case FaultKind::drift:
            return signal.drift_ps * signal.unit_si;
        case FaultKind::noise:
            return signal.noise * signal.unit_si;
        case FaultKind::saturated:
            return 1.0;
        default:
            return 0.0;
    }
}

// A speed has no sign on the bus, and most vehicles have no bank sensor whose code could be missed.
bool can_happen(FaultKind kind, FaultPlace place) {
    return !(kind == FaultKind::sign_flip && place == FaultPlace::speed);
}

std::vector<Fault> make_all() {
    std::vector<Fault> all;
    for (const FaultKind kind : signal_kinds) {
        for (const SensorSignal& signal : sensor_signals) {
            if (can_happen(kind, signal.place)) {
                all.push_back({kind, signal.place, magnitude_of(kind, signal)});
            }
        }
    }
    for (const FrameFault& fault : frame_faults) {
        for (const FaultPlace frame : sensor_frames) {
            all.push_back({fault.kind, frame, fault.magnitude});
        }
    }
    all.insert(all.end(), other_faults.begin(), other_faults.end());
    return all;
}

std::vector<Fault> make_further() {
    std::vector<Fault> all;
    for (const SensorSignal& signal : sensor_signals) {
        for (const double gain : gains) {
            all.push_back({FaultKind::gain, signal.place, gain});
        }
        all.push_back({FaultKind::noise_alone, signal.place, signal.own_noise * signal.unit_si});
    }
    for (const SensorSignal& signal : sensor_signals) {
        for (const double share : offset_shares) {
            all.push_back({FaultKind::offset, signal.place, share * signal.offset * signal.unit_si});
        }
    }
    for (const FaultKind kind : second_senders) {
        for (const FaultPlace frame : sensor_frames) {
            all.push_back({kind, frame, 1.0});
        }
    }
    all.push_back({FaultKind::sender_before, FaultPlace::warning_frame, 1.0});
    all.push_back({FaultKind::sender_tenfold, FaultPlace::warning_frame, 1.0});
    return all;
}

std::vector<Fault> make_mass_faults() {
    std::vector<Fault> all;
    const FaultPlace mass = mass_signal.place;
    for (const FaultKind kind : {FaultKind::frozen, FaultKind::offset, FaultKind::drift, FaultKind::noise,
                                 FaultKind::saturated, FaultKind::not_available, FaultKind::out_of_range}) {
        all.push_back({kind, mass, magnitude_of(kind, mass_signal)});
    }
    for (const double gain : mass_gains) {
        all.push_back({FaultKind::gain, mass, gain});
    }
    return all;
}

std::vector<Fault> make_coupled() {
    std::vector<Fault> all;
    for (const FaultPlace place :
         {FaultPlace::inertial_signals, FaultPlace::motion_signals, FaultPlace::all_signals}) {
        all.push_back({FaultKind::not_available, place, 0.0});
        all.push_back({FaultKind::frozen, place, 0.0});
        for (const double gain : supply_gains) {
            all.push_back({FaultKind::gain, place, gain});
        }
    }
    return all;
}

std::vector<Fault> make_tolerances() {
    std::vector<Fault> all;
    for (const SensorSignal& signal : sensor_signals) {
        all.push_back({FaultKind::offset, signal.place, offset_tolerance * signal.offset * signal.unit_si});
        for (const double gain : gain_tolerances) {
            all.push_back({FaultKind::gain, signal.place, gain});
        }
    }
    return all;
}

}  // namespace

const std::vector<Fault>& mass_faults() {
    static const std::vector<Fault> all = make_mass_faults();
    return all;
}

const std::vector<Fault>& coupled_faults() {
    static const std::vector<Fault> all = make_coupled();
    return all;
}

const std::vector<Fault>& tolerances() {
    static const std::vector<Fault> all = make_tolerances();
    return all;
}

const std::vector<Fault>& all_faults() {
    static const std::vector<Fault> all = make_all();
    return all;
}

const std::vector<Fault>& further_faults() {
    static const std::vector<Fault> all = make_further();
    return all;
}

std::vector<Fault> in_each_sign(const Fault& fault) {
    // A saturated speed has one end: the lower one is a vehicle at rest.
    const bool has_sign = fault.kind == FaultKind::turned_about_x ||
                          fault.kind == FaultKind::turned_about_z || fault.kind == FaultKind::offset ||
                          fault.kind == FaultKind::drift || is_second_sender(fault.kind) ||
                          (fault.kind == FaultKind::saturated && fault.place != FaultPlace::speed &&
                           fault.place != FaultPlace::vehicle_mass);
    if (!has_sign) {
        return {fault};
    }
    return {fault, {fault.kind, fault.place, -fault.magnitude}};
}

const char* to_string(FaultKind kind) {
    constexpr std::array names{"none",
                               "frozen",
                               "offset",
                               "drift",
                               "noise burst",
                               "sign flip",
                               "saturated",
                               "not available",
                               "code out of range",
                               "gain",
                               "noise without signal",
                               "lost",
                               "delayed",
                               "bad CRC",
                               "counter stands",
                               "counter jumps",
                               "identifier of the next frame",
                               "doubled",
                               "wrong DLC",
                               "second sender before",
                               "second sender after",
                               "second sender tenfold",
                               "foreign frames",
                               "damaged Imu frames",
                               "bus-off",
                               "error-passive",
                               "clock jump",
                               "process stopped",
                               "turned about x",
                               "turned about z"};
    return names[static_cast<std::size_t>(kind)];
}

const char* to_string(FaultPlace place) {
    constexpr std::array names{"lateral acceleration",
                               "vertical acceleration",
                               "roll rate",
                               "roll angle",
                               "bank angle",
                               "speed",
                               "yaw rate",
                               "steering wheel angle",
                               "vehicle mass",
                               "Imu",
                               "RollAngle",
                               "VehicleMotion",
                               "all sensor frames",
                               "RolloverWarning",
                               "bus",
                               "processor",
                               "inertial signals",
                               "motion signals",
                               "all signals"};
    return names[static_cast<std::size_t>(place)];
}

std::string describe(const Fault& fault) {
    const std::string name = to_string(fault.kind);
    const SensorSignal* const signal = find_signal(fault.place);
    switch (fault.kind) {
        case FaultKind::offset:
            return fmt::format("{}, {:+.3g} {}", name, fault.magnitude / signal->unit_si, signal->unit);
        case FaultKind::gain:
            return fmt::format("{}, {:.3g}", name, fault.magnitude);
        case FaultKind::sender_before:
        case FaultKind::sender_after:
        case FaultKind::sender_tenfold:
            return name + (fault.magnitude < 0.0 ? ", calm" : ", alarming");
        case FaultKind::noise:
        case FaultKind::noise_alone:
            return fmt::format("{}, {:.3g} {} rms", name, fault.magnitude / signal->unit_si, signal->unit);
        case FaultKind::drift:
            return fmt::format("{}, {:+.3g} {} a second", name, fault.magnitude / signal->unit_si,
                               signal->unit);
        case FaultKind::saturated:
            return name + (fault.magnitude < 0.0 ? ", lower end" : ", upper end");
        case FaultKind::turned_about_x:
        case FaultKind::turned_about_z:
            return fmt::format("{}, {:+.3g} deg", name, fault.magnitude * degrees_per_radian);
        case FaultKind::delayed:
        case FaultKind::clock_jump:
        case FaultKind::process_stop:
            return fmt::format("{}, {:.0f} ms", name, fault.magnitude);
        case FaultKind::flood_foreign:
        case FaultKind::flood_own:
            return fmt::format("{}, {:.0f} a cycle", name, fault.magnitude);
        default:
            return name;
    }
}

std::string describe_each_sign(const Fault& fault) {
    std::string text = describe(fault);
    if (in_each_sign(fault).size() == 1U) {
        return text;
    }
    if (fault.kind == FaultKind::saturated) {
        return std::string{to_string(fault.kind)} + ", either end";
    }
    if (is_second_sender(fault.kind)) {
        return std::string{to_string(fault.kind)} + ", alarming or calm";
    }
    return text.replace(text.find('+'), 1U, "\u00B1");
}

}  // namespace sil
