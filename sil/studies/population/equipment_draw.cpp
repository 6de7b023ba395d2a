// Equipment draw: steering, driveline, hull and sensor place.
#include "sil/studies/population/vehicle_draft.hpp"

namespace sil {

void draw_equipment(VehicleDraft& draft) {
    VehicleParameters& v = draft.vehicle;
    const double height = v.geometry.cg_height_m;
    v.steering.ratio = draft.within(Quantity::steering_ratio, &VehicleClass::steering_ratio);
    v.steering.lag_s = draft.within(Quantity::steering_lag, &VehicleClass::steering_lag_s);
    v.steering.compliance_radpn =
        draft.within(Quantity::steering_compliance, &VehicleClass::compliance_understeer_s2pm) * g_mps2 /
        (2.0 * draft.front_wheel_n());
    DrivelineParameters& d = v.driveline;
    d.front_drive_share = draft.within(Quantity::front_drive, &VehicleClass::front_drive_share);
    d.drive_force_limit_n = 3.0 * draft.mass_kg;
    d.engine_braking_n = 0.28 * draft.mass_kg;
    d.differential_damping_nmsprad = 5.0e-3 * draft.mass_kg;
    // Full braking is 0.9 g, two thirds of it in front.
    d.front_brake_nm = 0.3 * g_mps2 * draft.mass_kg * v.geometry.wheel_radius_m;
    d.rear_brake_nm = 0.5 * d.front_brake_nm;
    v.aerodynamics.drag_area_m2 = draft.within(Quantity::drag_area, &VehicleClass::drag_area_m2);
    HullParameters& hull = v.hull;
    hull.half_length_m =
        0.5 * draft.wheelbase_m * draft.within(Quantity::length, &VehicleClass::length_over_wheelbase);
    hull.half_width_m = 0.59 * v.geometry.track_width_m;
    hull.top_above_cg_m = draft.within(Quantity::body_height, &VehicleClass::body_height_m) - height;
    hull.bottom_below_cg_m = height - 0.6 * v.geometry.wheel_radius_m;
    v.imu_mount.x_m =
        draft.wheelbase_m * draft.within(Quantity::imu_forward, &VehicleClass::imu_forward_of_wheelbase);
    v.imu_mount.y_m = draft.within(Quantity::imu_left, &VehicleClass::imu_left_m);
    v.imu_mount.z_m = draft.within(Quantity::imu_height, &VehicleClass::imu_height_m) - height;
}

}  // namespace sil
