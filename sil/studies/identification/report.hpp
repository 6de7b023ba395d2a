// Report: the result of an identification for a reader, and its signals for pictures.
#pragma once

#include <string>
#include <vector>

#include "sil/studies/identification/identification.hpp"

namespace sil {

// Values with standard errors, residuals of every drive, warnings.
std::string identification_report(const Identification& result);

// Fit at one sample; NaN if it is not known.
struct FittedSample {
    double moment_nm{};         // m_s H f, measured
    double fitted_moment_nm{};  // M + c phi' + Ixx phi'', with the offset of the drive
    double static_moment_nm{};  // the measured one without what moving adds
    double fitted_load_moment_nm{};
    double yaw_acceleration_mps2{};       // r V
    double steering_acceleration_mps2{};  // asked for by the steering
    double predicted_roll_angle_rad{};    // predicted_roll_angles_rad
    double response_mps2{};               // sil::response_mps2
};

struct FittedDrive {
    const PreparedDrive* drive;  // of the identification
    bool dynamic;
    std::vector<FittedSample> fitted;  // one a sample of the drive
};

// Ramps first.
std::vector<FittedDrive> fitted_drives(const Identification& result);

// One row a sample: measured and fitted moments, residuals, load moments, lateral acceleration asked for by
// the steering, predicted roll angle and response. Drives one after the other.
std::string fit_csv(const Identification& result);

struct StiffnessPoint {
    double roll_angle_rad;
    double moment_nm;
    double linear_moment_nm;  // of the linear part
};

// Up to a little beyond rollover, to both sides.
std::vector<StiffnessPoint> stiffness_curve(const Identification& result);

// The stiffness curve: roll angle in degrees, moment, moment of the linear part.
std::string curve_csv(const Identification& result);

// Names and numbers that the pictures show, as gnuplot definitions.
std::string fit_marks(const Identification& result);

}  // namespace sil
