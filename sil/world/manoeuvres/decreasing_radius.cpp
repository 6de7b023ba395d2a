// Decreasing radius: an exit ramp that tightens, from 110 m to 45 m within 30 m of way. The driver sees that
// late and releases the throttle as the bend begins to tighten.
#include "sil/world/manoeuvres/path_driver.hpp"

namespace sil {

Manoeuvre decreasing_radius() {
    constexpr double wide_pm = 1.0 / 110.0;
    constexpr double tight_pm = 1.0 / 45.0;
    constexpr double before_tightening_m = 30.0 + 20.0 + 50.0;
    Manoeuvre manoeuvre;
    manoeuvre.name = "decreasing-radius";
    manoeuvre.description =
        "exit ramp at 65 km/h that tightens from 110 m to 45 m, throttle released too late";
    manoeuvre.duration_s = 13.0;
    manoeuvre.initial_speed_mps = from_kmh(65.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.asks_for_handwheel_angle = true;
    static const auto driver = path_driving(Course{}
                                                .straight(30.0)
                                                .bend(20.0, 0.0, wide_pm)
                                                .bend(50.0, wide_pm, wide_pm)
                                                .bend(30.0, wide_pm, tight_pm)
                                                .bend(110.0, tight_pm, tight_pm)
                                                .bend(20.0, tight_pm, 0.0)
                                                .straight(60.0),
                                            0.8, before_tightening_m);
    manoeuvre.make_driver = driver;
    return manoeuvre;
}

}  // namespace sil
