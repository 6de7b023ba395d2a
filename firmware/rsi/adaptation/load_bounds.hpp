// Load bounds: plausible range of a learnt load, for the estimator and for the output check.
#pragma once

namespace rsi {

// Load excess: share by which m_s H exceeds the calibrated one.
inline constexpr float least_load_excess = -0.6F;  // of a truck that has been emptied
inline constexpr float largest_load_excess = 1.0F;
// A load beyond this one is no reason to take a roll sensor for good: one of wrong scale teaches a load, too.
inline constexpr float largest_taught_load = 0.3F;
// Standard deviation of the excess before anything is learnt: loads add up to 20 % to a car's m_s H, 100 % to
// a truck's.
inline constexpr float largest_load_excess_deviation = 0.25F;
// Below it the excess is the result of minutes of driving. A sensor that has just failed looks like a load,
// but not like one that is known so well.
inline constexpr float sure_load_deviation = 0.06F;
// Plausible range of the sprung mass over the calibrated one: from an emptied truck to a load of twice the
// sprung mass.
inline constexpr float least_mass_factor = 0.6F;
inline constexpr float largest_mass_factor = 3.0F;

}  // namespace rsi
