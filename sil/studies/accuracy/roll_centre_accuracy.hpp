// Roll-centre accuracy: how far the estimates of a drive are from the truth (24), and what they claim.
#pragma once

#include <vector>

#include "sil/studies/accuracy/recorded_drive.hpp"

namespace sil::accuracy {

// Over the cycles in which (24) is defined: all wheels touch, |F_y| of at least 6 kN.
struct RollCentreAccuracy {
    int cycles{0};
    double constant_rms_m{0.0};           // error of the nominal height
    double estimate_rms_m{0.0};           // error of h_frc + dh
    double within_three_deviations{0.0};  // share of the cycles
    double normalised_square{0.0};        // mean of (error / deviation)^2
    // Over all cycles before the body has rolled by 0.2 rad.
    double compensated_roll_rms_deg{0.0};
};

RollCentreAccuracy roll_centre_accuracy(const std::vector<Cycle>& cycles, const rsi::Parameters& parameters);

// The calibration that belongs to the drive's vehicle: that of its name, with the CG where the manoeuvre has
// put it, and a straight stiffness curve where the manoeuvre has taken the stops away.
rsi::Parameters calibration_of(const RecordedDrive& drive, rsi_estimator estimator);

}  // namespace sil::accuracy
