// Summary: the result of a run in one small JSON file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sil/results/events.hpp"
#include "sil/results/versions.hpp"

namespace sil {

struct Summary {
    std::string manoeuvre;
    std::string vehicle;
    bool mirrored{false};
    bool lock_step{false};
    bool in_process{false};
    std::uint64_t seed{0U};
    std::string noise;           // name of the sensors' preset: "none", "noise"
    double bias_g{0.0};          // of the accelerometers
    double quantisation_g{0.0};  // of the accelerometers
    Versions versions;
    RunEvents events;
    std::uint64_t frames_sent{0U};      // by the simulator
    std::uint64_t frames_received{0U};  // by the simulator, from the ECU
    // By the names that a calibration knows the indicators by. Empty: not known, for frames carry neither
    // every index nor the calibration that the levels need.
    std::vector<std::pair<std::string, std::optional<double>>> index_times_s{};
};

// A JSON object with these keys, always all of them, in this order:
//   manoeuvre, vehicle, mirrored, lock_step, seed, noise, bias_g, quantisation_g,
//   versions {component, git_revision, compiler},
//   warning_time_s, warning_side ("left", "right"), warning_ay_g, one_wheel_lift_time_s,
//   two_wheel_lift_time_s, ssf_crossing_time_s, lead_time_s, max_ay_g, final_roll_deg, frames_sent,
//   frames_received, in_process, front_axle_lift_time_s, rear_axle_lift_time_s, max_load_transfer_ratio,
//   index_times_s {published, bank_free, ... as the calibration's warning_indicator}, falling_side,
//   side_at_lift_off, wrong_side_duration_s, load_transfer_band, warnings, advisories, warning_duration_s,
//   advisory_duration_s, unavailable_duration_s.
// warning_time_s and warning_side are those of the first warning, whatever came of it. lead_time_s and what
// follows index_times_s are the judgement (sil/judge/warning_judgement.hpp): lead_time_s is null unless a
// warning of the falling side is in force at two-wheel lift-off; load_transfer_band is "below 0.7",
// "0.7 to 0.8", "0.8 to 0.9", "0.9 to lift" or "lift"; the start-up is not unavailable.
// index_times_s: when each index was first at the level at which it says "warn" (1, rsi::indicator_level), to
// the cycle; null as a whole unless the run was in process. front_axle_lift and rear_axle_lift are the first
// lift-off of a wheel of that axle, of the true wheel loads, as is max_load_transfer_ratio, a magnitude.
// A value that is missing, or not finite, is null. warning_ay_g and final_roll_deg have a sign (> 0 in a left
// turn), max_ay_g is a magnitude; 1 g = 9.80665 m/s^2. The times are on the simulation's clock.
std::string summary_json(const Summary& summary);

// Writes it atomically. Throws std::runtime_error with the path and the reason.
void write_summary(const Summary& summary, const std::filesystem::path& path);

}  // namespace sil
