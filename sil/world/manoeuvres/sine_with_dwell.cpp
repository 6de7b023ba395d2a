// Sine with dwell after FMVSS 126: one period of 0.7 Hz with 500 ms at its second peak, at 80 km/h, coasting;
// the amplitude is that of the standard's last run.
#include <algorithm>
#include <cmath>

#include "sil/units.hpp"
#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {
namespace {

constexpr double start_s = 2.0;
constexpr double frequency_hz = 0.7;
constexpr double second_peak_s = 0.75 / frequency_hz;
constexpr double period_s = 1.0 / frequency_hz;
constexpr double dwell_s = 0.5;
constexpr double smallest_amplitude_rad = from_degrees(270.0);
constexpr double largest_amplitude_rad = from_degrees(300.0);

double sine_with_dwell_part(double since_s) {
    const double without_dwell_s =
        since_s < second_peak_s ? since_s : std::max(second_peak_s, since_s - dwell_s);
    return since_s < 0.0 || without_dwell_s > period_s ? 0.0
                                                       : std::sin(2.0 * pi * frequency_hz * without_dwell_s);
}

}  // namespace

Manoeuvre sine_with_dwell() {
    Manoeuvre manoeuvre;
    manoeuvre.name = "sine-with-dwell";
    manoeuvre.description =
        "sine with dwell at 80 km/h, throttle released: 0.7 Hz, 500 ms, 270 to 300 degrees (FMVSS 126)";
    manoeuvre.duration_s = 8.0;
    manoeuvre.initial_speed_mps = from_kmh(80.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = [](const VehicleParameters& parameters) {
        const double amplitude_rad = std::clamp(6.5 * handwheel_angle_at_0_3_g_rad(parameters),
                                                smallest_amplitude_rad, largest_amplitude_rad);
        return open_loop([amplitude_rad](double time_s) {
            return DriverCommand{amplitude_rad * sine_with_dwell_part(time_s - start_s),
                                 time_s < start_s ? SpeedPolicy::held : SpeedPolicy::off_throttle};
        })(parameters);
    };
    return manoeuvre;
}

}  // namespace sil
