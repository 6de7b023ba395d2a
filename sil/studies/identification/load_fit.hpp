// Load fit: the roll centre's height from wheel loads, and with it the absolute size of moments.
#pragma once

#include <optional>
#include <vector>

#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/roll_fit.hpp"

namespace sil {

// In a slow turn the loads balance what tips the vehicle over:
//     c_w/2 (F_zR - F_zL) = (m_s h + m_u h_u) A + H m_s N tan phi
// with the body's CG moving sideways by H tan phi. This H is the effective one, tyres included: with it the
// component's load transfer alpha A + M(phi) + c phi', alpha = m_s h_rc + m_u h_u, is that of the wheels.
//
// If that asks for a roll centre below the road or higher than any suspension has it, something else moves
// the CG sideways with the force: tyres that give way and loads that sway do, at once and not with the roll
// angle. A higher CG acts so in the component, a lower roll centre does not: its share would lag by the
// body's roll. Therefore the nearest roll centre is taken, with the CG height that the loads then speak for,
// unless the user wants to keep the given one, or it would have to change so much that rather a datum is
// wrong.
struct LoadFit {
    double roll_centre_at_given_height_m{};  // h_rc with the CG height of the vehicle data
    double deviation_m{};                    // of it, for a CG height known to 1 %
    double suspension_roll_centre_m{};       // the same without the tyres' roll: about h_rc of equation (24)
    double roll_centre_height_m{};           // given to the component
    double agreeing_cg_height_m{};           // by the loads with that roll centre
    double cg_height_m{};                    // given to the component
    bool contradicts_data{false};            // the CG height would have to change by more than 15 %
};

// Less than half of the last of three decimals is no height: it would be printed as a negative zero.
inline double shown_height_m(double height_m) {
    return height_m < 0.0 && height_m > -0.0005 ? 0.0 : height_m;
}

// Uses the ramps that have wheel loads; nothing when none has.
std::optional<LoadFit> fit_loads(const VehicleData& vehicle, const std::vector<PreparedDrive>& ramps,
                                 bool keep_cg_height);

// How the component's load transfer ratio, 2/(m N c_w) [alpha A + M(phi) + c phi'], differs from that of the
// wheels; one entry for each drive that has wheel loads, in units of the ratio.
std::vector<DriveResidual> load_transfer_residuals(const VehicleData& vehicle, const RollFit& roll,
                                                   const std::vector<PreparedDrive>& drives);

// alpha A + M(phi) + c phi', N m.
double component_load_moment_nm(const VehicleData& vehicle, const RollFit& roll, const RollSample& sample);

}  // namespace sil
