// Energy stored in a suspension spring and its stops.
#include "sil/world/vehicle/suspension.hpp"

namespace sil {

double SpringDamper::stored_energy_j(double jounce_m) const {
    double energy = preload_n_ * jounce_m + 0.5 * parameters_.spring_npm * jounce_m * jounce_m;
    if (jounce_m > parameters_.jounce_clearance_m) {
        const double beyond = jounce_m - parameters_.jounce_clearance_m;
        energy += parameters_.jounce_stop_npm2 * beyond * beyond * beyond / 3.0;
    } else if (jounce_m < -parameters_.rebound_clearance_m) {
        const double beyond = -jounce_m - parameters_.rebound_clearance_m;
        energy += parameters_.rebound_stop_npm2 * beyond * beyond * beyond / 3.0;
    }
    return energy;
}

}  // namespace sil
