#include "rsi/adaptation/load_split.hpp"

#include "rsi/adaptation/load_bounds.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/square_root.hpp"

namespace rsi {
namespace {

// Plausible range of H over the calibrated one. A mass that needs more contradicts the roll angle and is
// adjusted.
constexpr float least_height_factor = 0.6F;
// The same for a body that is heavier than calibrated.
constexpr float least_height_factor_of_more = 0.9F;
constexpr float largest_height_factor = 1.7F;
// The same, lower bound if the mass is not known.
constexpr float least_assumed_height_factor = 0.93F;
// Lower bound of the validation of the parameters, too.
constexpr float least_cg_height_m = 0.2F;
// Excess that a wrong calibration makes: 10 % of the stiffness, or 5 % of the height.
constexpr float usual_error = 0.1F;
constexpr float clear_excess = 2.0F * usual_error;
// Change of mass that needs no load to be shown: what axle loads and the calibration are wrong by.
constexpr float unshown_mass = 0.04F;
// Mass over moment of the lowest load that is still taken for one: on the floor of a truck.
constexpr float mass_of_low_load = 2.0F;
// Beyond what is admitted: a stiffness that is wrong by 10 % and a load at the roll centre's height together.
constexpr float impossible_mass = 0.25F;

}  // namespace

float excess_beyond_errors(float excess) {
    const float size = absolute(excess);
    const float beyond = larger(size - usual_error, 0.0F) * (clear_excess / (clear_excess - usual_error));
    const float taken = smaller(beyond, size);
    return (excess < 0.0F) ? -taken : taken;
}

float excess_beside_mass(float excess, float by_mass) {
    return by_mass + larger(excess_beyond_errors(excess - by_mass), -absolute(by_mass));
}

float admitted_mass_change(float by_mass, float shown) {
    const float load = mass_of_low_load * excess_beyond_errors(shown);
    return clamp(by_mass, smaller(load, 0.0F) - unshown_mass, larger(load, 0.0F) + unshown_mass);
}

bool contradicts_load(float by_mass, float shown, float deviation) {
    return (deviation < sure_load_deviation) &&
           !is_within_magnitude(by_mass - admitted_mass_change(by_mass, shown), impossible_mass);
}

// Precondition: both factors are above 0.3, so the divisions are safe.
SprungBody with_load(const SprungBody& calibrated, float moment_factor, float mass_factor) {
    const float plausible_mass_factor = clamp(mass_factor, moment_factor / largest_height_factor,
                                              larger(moment_factor / least_height_factor_of_more,
                                                     smaller(moment_factor / least_height_factor, 1.0F)));
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
