#include "rsi/adaptation/load_split.hpp"

#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/square_root.hpp"

namespace rsi {
namespace {

// Plausible range of H over the calibrated one. A mass that needs more contradicts the roll angle and is
// adjusted.
constexpr float least_height_factor = 0.6F;
constexpr float largest_height_factor = 1.7F;
// The same, lower bound if the mass is not known.
constexpr float least_assumed_height_factor = 0.93F;
// Lower bound of the validation of the parameters, too.
constexpr float least_cg_height_m = 0.2F;

}  // namespace

// Precondition: both factors are above 0.5, so the divisions are safe.
SprungBody with_load(const SprungBody& calibrated, float moment_factor, float mass_factor) {
    const float plausible_mass_factor =
        clamp(mass_factor, moment_factor / largest_height_factor, moment_factor / least_height_factor);
    const float height_factor = moment_factor / plausible_mass_factor;
    SprungBody loaded;
    loaded.mass_kg = plausible_mass_factor * calibrated.mass_kg;
    loaded.roll_arm_m = height_factor * calibrated.roll_arm_m;
    // A load does not move the roll centre.
    loaded.cg_height_m =
        larger(calibrated.cg_height_m + (height_factor - 1.0F) * calibrated.roll_arm_m, least_cg_height_m);
    loaded.roll_inertia_kgm2 = moment_factor * calibrated.roll_inertia_kgm2;
    return loaded;
}

float assumed_mass_factor(float moment_factor) {
    return moment_factor / larger(square_root(moment_factor), least_assumed_height_factor);
}

}  // namespace rsi
