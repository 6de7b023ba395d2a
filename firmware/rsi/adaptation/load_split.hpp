// Load split: what a load does to the body, from what it does to m_s H and from the vehicle's mass if that is
// known.
#pragma once

#include "rsi/model/vehicle.hpp"

namespace rsi {

// `moment_factor`: m_s H over the calibrated one; `mass_factor`: m_s over it. H takes the rest, within what a
// load can do to it; a mass that asks for more is not used as it is. The inertia grows with m_s H.
SprungBody with_load(const SprungBody& calibrated, float moment_factor, float mass_factor);

// The mass's share where only m_s H is known: half and half in the logarithm, sqrt(moment_factor). A roof
// rack does more to the height, a full cabin to the mass. But H is not taken to be much lower than
// calibrated: a truck that has been emptied has lost mass, and assuming a low CG delays the warning.
float assumed_mass_factor(float moment_factor);

}  // namespace rsi
