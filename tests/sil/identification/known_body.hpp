// Known body: a drive computed from the roll equation itself, with parameters that are known exactly.
#pragma once

#include <functional>

#include "sil/studies/drives/drive.hpp"
#include "sil/studies/identification/vehicle_data.hpp"

namespace identification_test {

struct KnownBody {
    double sprung_mass_kg{1900.0};
    double unsprung_mass_kg{280.0};
    double sprung_cg_height_m{0.85};
    double unsprung_cg_height_m{0.36};
    double track_width_m{1.62};
    double roll_centre_height_m{0.18};
    double stiffness_nmprad{88.0e3};
    double stiffness_cubic_nmprad3{9.0e5};
    double stiffness_quintic_nmprad5{0.0};
    double damping_nmsprad{4200.0};
    double inertia_kgm2{720.0};
    double wheelbase_m{2.8};
    double steering_ratio{17.5};
    double understeer_gradient_s2pm{0.0021};
    double speed_mps{20.0};
    double imu_x_m{0.4};
    double imu_y_m{0.1};
    double imu_z_m{-0.3};

    double moment_nm(double roll_angle_rad) const;
};

struct Recording {
    bool wheel_loads{true};
    bool steering{true};
    bool motion{true};  // speed and yaw rate
    double lateral_offset_mps2{0.0};
    double roll_offset_rad{0.0};
    double roll_rate_offset_radps{0.0};
    std::function<double(double)> demand_mps2{};    // demand of the steering; empty: the motion itself
    std::function<double(double)> bank_rad{};       // left side up is positive, slow; empty: level
    std::function<double(double)> sideslip_mps2{};  // the part of the lateral acceleration that turns nothing
    bool roll_against_gravity{false};               // as an attitude sensor gives the roll angle
};

// `lateral_mps2` is what the path asks for over the time: A where the road is level.
sil::Drive drive_of(const KnownBody& body, double duration_s,
                    const std::function<double(double)>& lateral_mps2, const Recording& recording = {});

// To `largest` and back to zero, to both sides, each within 30 s.
sil::Drive ramp_of(const KnownBody& body, double largest_mps2, const Recording& recording = {});
// Two steps of 3 m/s^2, smooth within 0.2 s.
sil::Drive steps_of(const KnownBody& body, const Recording& recording = {});

// All that a data sheet says, without roll centre and inertia.
sil::VehicleData data_sheet_of(const KnownBody& body);

}  // namespace identification_test
