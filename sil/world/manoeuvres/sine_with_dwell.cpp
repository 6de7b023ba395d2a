// Sine with dwell after FMVSS 126: one period of 0.7 Hz with 500 ms at its second peak, at 80 km/h, coasting;
// the amplitude is that of the standard's last run.
#include <algorithm>
#include <cmath>
#include <utility>

#include "sil/units.hpp"
#include "sil/world/manoeuvres/rule_book.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {
namespace {

constexpr double frequency_hz = SineWithDwell::frequency_hz;
constexpr double second_peak_s = 0.75 / frequency_hz;
constexpr double period_s = 1.0 / frequency_hz;

double sine_with_dwell_part(double since_s) {
    const double without_dwell_s =
        since_s < second_peak_s ? since_s : std::max(second_peak_s, since_s - SineWithDwell::dwell_s);
    return since_s < 0.0 || without_dwell_s > period_s ? 0.0
                                                       : std::sin(2.0 * pi * frequency_hz * without_dwell_s);
}

Manoeuvre sine_with_dwell(std::function<double(const VehicleParameters&)> amplitude_rad) {
    Manoeuvre manoeuvre;
    manoeuvre.duration_s = 8.0;
    manoeuvre.initial_speed_mps = from_kmh(80.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = [amplitude_rad = std::move(amplitude_rad)](const VehicleParameters& parameters) {
        return open_loop([amplitude = amplitude_rad(parameters)](double time_s) {
            return DriverCommand{
                amplitude * sine_with_dwell_part(time_s - SineWithDwell::start_s),
                time_s < SineWithDwell::start_s ? SpeedPolicy::held : SpeedPolicy::off_throttle};
        })(parameters);
    };
    return manoeuvre;
}

}  // namespace

Manoeuvre sine_with_dwell(double amplitude_rad) {
    return sine_with_dwell([amplitude_rad](const VehicleParameters&) { return amplitude_rad; });
}

Manoeuvre sine_with_dwell() {
    Manoeuvre manoeuvre = sine_with_dwell([](const VehicleParameters& parameters) {
        return std::clamp(6.5 * handwheel_angle_at_0_3_g_rad(parameters),
                          SineWithDwell::smallest_last_amplitude_rad, SineWithDwell::largest_amplitude_rad);
    });
    manoeuvre.asks_for_handwheel_angle = true;
    manoeuvre.name = "sine-with-dwell";
    manoeuvre.description =
        "sine with dwell at 80 km/h, throttle released: 0.7 Hz, 500 ms, 270 to 300 degrees (FMVSS 126)";
    return manoeuvre;
}

}  // namespace sil
