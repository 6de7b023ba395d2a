// Load fit: the roll centre's height from wheel loads, and with it the absolute size of moments.
#pragma once

#include <optional>
#include <vector>

#include "sil/identification/prepared_drive.hpp"
#include "sil/identification/roll_fit.hpp"

namespace sil {

// c_w/2 (F_zR - F_zL) = m_s (h - H) A + m_u h_u (A + H phi'') + m_s H f - Ixx phi'', with Ixx/H from the roll
// fit: the moment about the road. Linear in H.
struct LoadFit {
    Estimate arm_m;                     // H; the deviation contains 1 % of uncertainty of the CG's height
    Estimate free_cg_height_m;          // h as the loads alone would have it, fitted together with H
    double condition_number{};          // of that second fit
    double roll_centre_height_m{};      // h - H
    double lateral_share_kgm{};         // alpha = m_s h_rc + m_u h_u
    std::vector<DriveResidual> drives;  // in N m
};

// Uses the drives that have wheel loads; nothing when none has.
std::optional<LoadFit> fit_loads(const VehicleData& vehicle, const RollFit& roll,
                                 const std::vector<PreparedDrive>& drives);

}  // namespace sil
