// Load split: divides a change of m_s H into mass and height of the sprung body.
#pragma once

#include "rsi/model/vehicle.hpp"

namespace rsi {

// A calibration with another roll stiffness or height than the vehicle's, and leaf springs that stick, make
// the body roll as another load would. The part of an excess of m_s H that is taken for a load: none below
// what such errors make, all from twice as much on.
float excess_beyond_errors(float excess);

// The same beside a known mass, which makes an excess of `by_mass` at the height of the calibrated CG: the
// errors count from there. A body that rolls less than its mass says has not become light at once: as much as
// the mass has changed may be missing, no more.
float excess_beside_mass(float excess, float by_mass);

// Change of the sprung mass, as a share, that is used of one that is received: as far as driving shows a load
// that can be it. `shown`: the excess that driving has shown. A load that is shown admits twice as much, as
// low as it may lie; a body that rolls as calibrated admits no more than the calibration's errors.
float admitted_mass_change(float by_mass, float shown);

// Driving has shown the load, `deviation` being small, and it cannot be that of the received mass: a trailer
// is in it, or it is wrong. None of it is used then.
bool contradicts_load(float by_mass, float shown, float deviation);

// `moment_factor`: m_s H over the calibrated one; `mass_factor`: m_s over the calibrated one. H follows from
// both, within plausible bounds, to which a contradicting mass is adjusted: a heavier body is hardly lower,
// so a mass that says so has a trailer in it, or is wrong. The inertia grows with m_s H.
SprungBody with_load(const SprungBody& calibrated, float moment_factor, float mass_factor);

// Mass factor if only m_s H is known: sqrt(moment_factor), so that mass and height share the change equally;
// a roof load raises the height more, a full cabin the mass. H is not assumed much lower than calibrated: an
// emptied truck has lost mass, and assuming a low CG delays the warning.
float assumed_mass_factor(float moment_factor);

}  // namespace rsi
