// Rule book: manoeuvres of rule books, with speeds, angles and sizes of the caller's.
#pragma once

#include <array>
#include <cstdint>

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

// Fishhook of NHTSA: the reversal begins a fixed time after the first ramp (1a), or when the body has stopped
// rolling (1b).
enum class FishhookReversal : std::uint8_t { after_a_fixed_dwell, at_small_roll_rate };

// Factor on the handwheel angle that gives 0.3 g.
inline constexpr double fishhook_amplitude_factor = 6.5;

Manoeuvre fishhook(FishhookReversal reversal, double speed_mps, double amplitude_rad);

// Sine with dwell of FMVSS 126 and UN R140.
struct SineWithDwell {
    static constexpr double frequency_hz = 0.7;
    static constexpr double dwell_s = 0.5;
    static constexpr double smallest_last_amplitude_rad = from_degrees(270.0);  // of a series' last run
    static constexpr double largest_amplitude_rad = from_degrees(300.0);

    // On the clock of the run.
    static constexpr double start_s = 2.0;
    static constexpr double sign_change_s = start_s + 0.5 / frequency_hz;           // of the handwheel
    static constexpr double completion_s = start_s + 1.0 / frequency_hz + dwell_s;  // it is back at zero
};

Manoeuvre sine_with_dwell(double amplitude_rad);

// Lane-change track of ISO 3888-2 (obstacle avoidance): three lanes between cones.
struct LaneSection {
    double begin_m{0.0};
    double end_m{0.0};
    double right_m{0.0};  // edges, y to the left
    double left_m{0.0};
};

// Sections 1, 3 and 5, between which the cones leave the vehicle free for 13.5 and 12.5 m. Section 1 is
// centred on the x axis and begins at x = `begin_m`; section 5 is centred on it too; section 3 lies to the
// left, one metre from edge to edge. Widths follow from the vehicle's width b: 1.1 b + 0.25, b + 1, and
// 1.3 b + 0.25 but at least 3 m.
std::array<LaneSection, 3> lane_change_track(double begin_m, double vehicle_width_m);

}  // namespace sil
