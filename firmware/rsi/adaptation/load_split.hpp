// Load split: divides a change of m_s H into mass and height of the sprung body.
#pragma once

#include "rsi/model/vehicle.hpp"

namespace rsi {

// `moment_factor`: m_s H over the calibrated one; `mass_factor`: m_s over the calibrated one. H follows from
// both, within plausible bounds, to which a contradicting mass is adjusted. The inertia grows with m_s H.
SprungBody with_load(const SprungBody& calibrated, float moment_factor, float mass_factor);

// Mass factor if only m_s H is known: sqrt(moment_factor), so that mass and height share the change equally;
// a roof load raises the height more, a full cabin the mass. H is not assumed much lower than calibrated: an
// emptied truck has lost mass, and assuming a low CG delays the warning.
float assumed_mass_factor(float moment_factor);

}  // namespace rsi
