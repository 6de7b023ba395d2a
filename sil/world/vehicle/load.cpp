// Load: two bodies become one; Steiner's theorem about the new common CG.
#include "sil/world/vehicle/load.hpp"

#include <stdexcept>
#include <string>

namespace sil {

VehicleParameters with_load(VehicleParameters parameters, double added_mass_kg, double height_m) {
    const double mass = parameters.mass.sprung_kg;
    const double total = mass + added_mass_kg;
    if (!(total > 0.0)) {
        throw std::invalid_argument("The load leaves no sprung mass. Take away less than " +
                                    std::to_string(mass) + " kg.");
    }
    const double above_cg = height_m - parameters.geometry.cg_height_m;
    const double rise = added_mass_kg * above_cg / total;
    const double inertia = mass * added_mass_kg / total * above_cg * above_cg;
    parameters.mass.sprung_kg = total;
    parameters.geometry.cg_height_m += rise;
    parameters.inertia.sprung_roll_kgm2 += inertia;
    parameters.inertia.sprung_pitch_kgm2 += inertia;
    if (!(parameters.inertia.sprung_roll_kgm2 > 0.0) || !(parameters.geometry.cg_height_m > 0.0)) {
        throw std::invalid_argument(
            "The load that is taken away holds more inertia than the body has. Take it from nearer the CG.");
    }
    parameters.hull.top_above_cg_m -= rise;
    parameters.hull.bottom_below_cg_m += rise;
    parameters.imu_mount.z_m -= rise;
    return parameters;
}

VehicleParameters with_friction(VehicleParameters parameters, double factor) {
    if (!(factor > 0.0)) {
        throw std::invalid_argument("A friction factor must be above 0.");
    }
    parameters.tyre.friction *= factor;
    return parameters;
}

}  // namespace sil
