#include "rsi/adaptation/load_adaptation.hpp"

#include "rsi/adaptation/load_split.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi {
namespace {

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
    weigh_mass();
}

// Keeps the last mass while none is available. A change of mass is assumed at the height of the body's CG
// until driving shows otherwise. The first mass corrects the calibration's; a clearly different later one is
// a change of load where the vehicle stands. One that changes while it drives does not change what is learnt.
void LoadAdaptation::follow_mass(const Constants& constants, float vehicle_mass_kg) {
    const float factor = (vehicle_mass_kg - constants.unsprung_mass_kg) / constants.calibrated.mass_kg;
    if (is_within(factor, least_mass_factor, largest_mass_factor)) {
        const float change = factor - learnt_at_mass_factor_;
        if (!mass_known_) {
            regression_.expect_change(change);
            learnt_at_mass_factor_ = factor;
        } else if (stop_.is_standing() && !is_within_magnitude(change, clear_change_of_mass)) {
            regression_.add_load(change);
            learnt_at_mass_factor_ = factor;
        } else {
            // Same load, or a vehicle that drives: the learnt excess stays.
        }
        mass_factor_ = factor;
        mass_known_ = true;
    }
}

// A mass that driving does not confirm, or refutes, leaves the body as it is without one.
void LoadAdaptation::weigh_mass() {
    const float by_mass = mass_factor_ - 1.0F;
    const float shown = regression_.excess() - regression_.assumed_excess();
    const bool refuted = contradicts_load(by_mass, shown, regression_.excess_deviation());
    used_mass_change_ = refuted ? 0.0F : admitted_mass_change(by_mass, shown);
    used_excess_ = is_within_magnitude(by_mass - used_mass_change_, 0.0F) ? regression_.excess() : shown;
    mass_is_used_ = mass_known_ && !refuted;
}

// Starts from the excess that the received mass suggests.
void LoadAdaptation::reset_learnt() {
    regression_.reset();
    regression_.expect_change(mass_factor_ - 1.0F);
    learnt_at_mass_factor_ = mass_factor_;
    weigh_mass();
}

// The load may have changed.
void LoadAdaptation::doubt() {
    regression_.doubt(accepted_mass_change());
}

SprungBody LoadAdaptation::body(const Constants& constants) const {
    const float excess = mass_is_used_ ? excess_beside_mass(used_excess_, used_mass_change_)
                                       : excess_beyond_errors(used_excess_);
    const float moment_factor =
        smaller(1.0F + constants.used_share * excess, constants.largest_moment_factor);
    const float mass_factor =
        mass_is_used_ ? 1.0F + constants.used_share * used_mass_change_ : assumed_mass_factor(moment_factor);
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
    weigh_mass();
    return restored;
}

}  // namespace rsi
