#include "rsi/adaptation/load_adaptation.hpp"

#include "rsi/adaptation/load_split.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

// Plausible range of the sprung mass over the calibrated one: from an emptied truck to a load of twice the
// sprung mass. A mass outside is ignored.
constexpr float least_mass_factor = 0.6F;
constexpr float largest_mass_factor = 3.0F;
// Least ratio of roll stiffness to the overturning stiffness m_s g H: at 1 the body would tip over on its
// springs.
constexpr float least_stiffness_reserve = 1.1F;
constexpr float largest_load_margin = 0.1F;
// Share of the calibrated sprung mass: smaller changes are fuel or measurement noise.
constexpr float clear_change_of_mass = 0.05F;

}  // namespace

LoadAdaptation::Constants::Constants(const Parameters& parameters)
    : calibrated(calibrated_body(parameters)),
      moment_arm_inverse(1.0F / calibrated.moment_arm_kgm()),  // validated: above 0
      unsprung_mass_kg(parameters.unsprung_mass_kg),
      used_share(parameters.load_adaptation),
      margin(used_share * parameters.load_margin),
      // The validation of the parameters makes it 1.2 / 1.1 or more.
      largest_moment_factor(parameters.roll_stiffness_nmprad /
                            (least_stiffness_reserve * gravity_mps2 * calibrated.moment_arm_kgm())),
      regression(parameters) {}

void LoadAdaptation::update(const Constants& constants, const Inputs& inputs, const RollMotion& motion,
                            const TransferredLoad& load, bool measured_angle) {
    follow_mass(constants, inputs.vehicle_mass_kg);
    if (stop_.begins(inputs.speed_mps)) {
        doubt();
    }
    if (measured_angle && !stop_.is_standing()) {
        if (!regression_.update(constants.regression, motion, load)) {
            reset_learnt();
        }
    } else {
        regression_.pass_time();
    }
}

// Keeps the last mass while none is available. A change of mass is assumed at the height of the body's CG
// until driving shows otherwise. The first mass corrects the calibration's; a clearly different later one is
// a change of load.
void LoadAdaptation::follow_mass(const Constants& constants, float vehicle_mass_kg) {
    const float factor = (vehicle_mass_kg - constants.unsprung_mass_kg) / constants.calibrated.mass_kg;
    if (is_within(factor, least_mass_factor, largest_mass_factor)) {
        const float change = factor - learnt_at_mass_factor_;
        if (!mass_known_) {
            regression_.expect_change(change);
            learnt_at_mass_factor_ = factor;
        } else if (!is_within_magnitude(change, clear_change_of_mass)) {
            regression_.add_load(change);
            learnt_at_mass_factor_ = factor;
        } else {
            // Same load: the learnt excess stays.
        }
        mass_factor_ = factor;
        mass_known_ = true;
    }
}

// Starts from the excess that the received mass suggests.
void LoadAdaptation::reset_learnt() {
    regression_.reset();
    regression_.expect_change(mass_factor_ - 1.0F);
}

// The load may have changed.
void LoadAdaptation::doubt() {
    regression_.doubt(mass_factor_ - 1.0F);
}

SprungBody LoadAdaptation::body(const Constants& constants) const {
    const float by_mass = mass_factor_ - 1.0F;
    const float excess = mass_known_ ? excess_beside_mass(regression_.excess(), by_mass)
                                     : excess_beyond_errors(regression_.excess());
    const float moment_factor =
        smaller(1.0F + constants.used_share * excess, constants.largest_moment_factor);
    const float mass_factor = mass_known_ ? known_mass_factor(constants) : assumed_mass_factor(moment_factor);
    return with_load(constants.calibrated, moment_factor, mass_factor);
}

float LoadAdaptation::level_weight(const Constants& constants) const {
    return 1.0F + smaller(constants.margin * regression_.excess_deviation(), largest_load_margin);
}

bool LoadAdaptation::restore(const LearntLoad& learnt, bool doubted) {
    const bool restored = regression_.restore(learnt);
    if (restored && doubted) {
        doubt();
    }
    return restored;
}

}  // namespace rsi
