#include "sil/studies/procedures/handwheel_angle.hpp"

#include "sil/units.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {

double handwheel_angle_of_both_sides_rad(const VehicleParameters& vehicle) {
    return 0.5 * (handwheel_angle_at_0_3_g_rad(vehicle) + handwheel_angle_at_0_3_g_rad(vehicle, true));
}

Figure handwheel_figure(double angle_rad) {
    return {"handwheel_at_0_3_g_deg", "handwheel angle of 0.3 g, A", "deg", 1,
            angle_rad * degrees_per_radian};
}

}  // namespace sil
