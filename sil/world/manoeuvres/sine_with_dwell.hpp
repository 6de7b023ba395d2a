// Sine with dwell: that of FMVSS 126 and UN R140, with an amplitude of the caller's.
#pragma once

#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

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

}  // namespace sil
