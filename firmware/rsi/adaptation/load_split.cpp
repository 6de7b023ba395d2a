#include "rsi/adaptation/load_split.hpp"

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/square_root.hpp"

namespace rsi {
namespace {

// A mass that asks for more contradicts the roll angle: it is not that of this vehicle.
constexpr float least_height_factor = 0.6F;
constexpr float largest_height_factor = 1.7F;
// Share of H if the mass is not known.
constexpr float least_assumed_height_factor = 0.93F;
// As the calibrations'.
constexpr float least_cg_height_m = 0.2F;

}  // namespace

// Both factors are above 0.5.
SprungBody with_load(const SprungBody& calibrated, float moment_factor, float mass_factor) {
    const float plausible_mass_factor =
        clamp(mass_factor, moment_factor / largest_height_factor, moment_factor / least_height_factor);
    const float height_factor = moment_factor / plausible_mass_factor;
    SprungBody loaded;
    loaded.mass_kg = plausible_mass_factor * calibrated.mass_kg;
    loaded.roll_arm_m = height_factor * calibrated.roll_arm_m;
    // The roll centre stays.
    loaded.cg_height_m =
        larger(calibrated.cg_height_m + (height_factor - 1.0F) * calibrated.roll_arm_m, least_cg_height_m);
    loaded.roll_inertia_kgm2 = moment_factor * calibrated.roll_inertia_kgm2;
    return loaded;
}

float assumed_mass_factor(float moment_factor) {
    return moment_factor / larger(square_root(moment_factor), least_assumed_height_factor);
}

}  // namespace rsi
