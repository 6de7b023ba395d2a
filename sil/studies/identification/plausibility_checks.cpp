#include "sil/studies/identification/plausibility_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/studies/identification/admitted_range.hpp"
#include "sil/studies/identification/identification.hpp"
#include "sil/studies/identification/roll_reference.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double weak_share = 0.5;  // of what the rule of thumb leaves open
// Shares of the rule of thumb; the fitted inertia of a body on its tyres is rather smaller than that of a
// rigid one.
constexpr double least_inertia_share = 0.4;
constexpr double largest_inertia_share = 1.3;
// Radius of gyration over track width, of bodies that are given: beyond the largest scatter of vehicles.
constexpr double least_gyration_share = 0.25;
constexpr double largest_gyration_share = 0.65;
// Share by which a CG height measured on scales may be off.
constexpr double unseen_share = 0.05;
// s^2/m: heavy vehicles have up to half of it.
constexpr double largest_understeer_gradient = 0.015;

class Warnings {
 public:
    explicit Warnings(const Identification& result) : result_{result} {}

    std::vector<std::string> all() {
        about_vehicle();
        about_curve();
        about_dynamics();
        about_roll_centre();
        about_steering();
        about_response();
        about_roll_reference();
        about_offsets();
        about_sensors();
        about_admitted_ranges();
        return std::move(warnings_);
    }

 private:
    template <typename... Values>
    void warn(fmt::format_string<Values...> text, Values&&... values) {
        warnings_.push_back(fmt::format(text, std::forward<Values>(values)...));
    }

    void about_vehicle() {
        for (const std::string& assumption : result_.vehicle.assumptions) {
            warn("{}", assumption);
        }
    }

    void about_curve() {
        double reach_mps2 = 0.0, reach_rad = 0.0;
        for (const PreparedDrive& ramp : result_.ramps) {
            reach_mps2 = std::max(reach_mps2, ramp.largest_parallel_mps2);
            reach_rad = std::max(reach_rad, ramp.largest_roll_angle_rad);
        }
        const double lift_g = static_stability_factor(result_.vehicle);
        if (reach_mps2 / g_mps2 < 0.6 * lift_g) {
            warn(
                "the ramp reaches only {:.2f} g and {:.1f} deg of roll: the stiffness beyond is "
                "extrapolated, nearly as a line; steer on to {:.2f} g for the whole curve",
                reach_mps2 / g_mps2, reach_rad * degrees_per_radian, 0.8 * lift_g);
        }
        about_extrapolation();
        if (result_.roll.curve_flattened) {
            warn(
                "the stiffness curve that fits best would fall before the vehicle rolls over; it was held "
                "back");
        }
        if (result_.roll.curve_limited) {
            warn(
                "the stiffness curve that fits best has coefficients beyond what the component admits; a "
                "straighter one was fitted that stays within");
        }
        const DriveResidual& ramp = result_.roll.drives.front();
        if (ramp.r_squared < 0.98) {
            warn(
                "{}: the model explains only {:.1f} % of the ramp: check the roll angle's and the "
                "accelerometer's signs and units, and that the road is level",
                ramp.name, 100.0 * ramp.r_squared);
        }
        if (result_.roll.stiffness_nmprad.value <
            1.2 * result_.vehicle.sprung_mass_kg * g_mps2 * result_.roll.arm_m) {
            warn(
                "the fitted stiffness does not hold the body up, and the component will refuse it: check "
                "masses, CG height and the sign of the roll angle");
        }
    }

    void about_extrapolation() {
        const RollFit& roll = result_.roll;
        if (roll.curve_held) {
            warn(
                "the drives show the stiffness up to {:.1f} deg of roll, and what fits best there would "
                "run away beyond, before {:.1f} deg, where the component still needs it: its slope is "
                "held between {:.2g} and {:.2g} times that at the end of the data. A ramp that goes further "
                "would show it",
                roll.data_end_rad * degrees_per_radian, roll.needed_up_to_rad * degrees_per_radian,
                1.0 / roll.largest_slope_share, roll.largest_slope_share);
        }
    }

    void about_dynamics() {
        const RollFit& roll = result_.roll;
        if (!result_.vehicle.roll_inertia_kgm2 &&
            roll.inertia_kgm2.deviation > weak_share * roll.inertia_kgm2.prior_deviation) {
            warn(
                "Ixx is weakly excited: the rule of thumb has a large part in it; a faster step steer would "
                "show it");
        }
        about_inertia();
        if (roll.damping_nmsprad.deviation > weak_share * roll.damping_nmsprad.prior_deviation) {
            warn(
                "the damping is weakly excited: the rule of thumb has a large part in it; a step steer shows "
                "it");
        }
        const double share = roll.dynamic_stiffness_difference_nmprad.value / roll.stiffness_nmprad.value;
        if (std::abs(share) > 0.05) {
            warn(
                "in the dynamic drive the body is {:.0f} % {} than in the ramp: the road's slope, another "
                "load, or a roll angle that lags behind",
                100.0 * std::abs(share), share > 0.0 ? "stiffer" : "softer");
        }
        for (std::size_t i = result_.ramps.size(); i < roll.drives.size(); ++i) {
            if (roll.drives[i].r_squared < 0.95) {
                warn("{}: the model explains only {:.1f} % of this drive: look at its residuals",
                     roll.drives[i].name, 100.0 * roll.drives[i].r_squared);
            }
        }
    }

    // A wrong sign of imu_z_m hides in Ixx: both act with the roll acceleration.
    void about_inertia() {
        const VehicleData& vehicle = result_.vehicle;
        if (vehicle.roll_inertia_kgm2) {
            about_given_inertia(*vehicle.roll_inertia_kgm2);
        }
        const auto& refused = result_.roll.refused_inertia_kgm2;
        const double fitted = refused.value_or(result_.roll.inertia_kgm2.value);
        const double usual = vehicle.roll_inertia_kgm2.value_or(usual_roll_inertia_kgm2(vehicle));
        if (refused) {
            warn(
                "the drives alone would give an Ixx of {:.0f} kg m2, which no body has: {:.0f} kg m2 is "
                "taken, {}, and stiffness and damping are fitted with it. Something else follows the roll "
                "acceleration: check masses, CG height and imu_z_m (negative when the IMU is below the "
                "sprung CG{}); a frame that twists and a roll angle of another place than the IMU's do that, "
                "too",
                fitted, result_.roll.inertia_kgm2.value,
                vehicle.roll_inertia_kgm2 ? "that of the vehicle data" : "the rule of thumb",
                other_sign_text(fitted, usual));
            return;
        }
        if (fitted > least_inertia_share * usual && fitted < largest_inertia_share * usual) {
            return;
        }
        warn(
            "Ixx is {:.0f} kg m2, {:.0f} kg m2 would be usual for this mass and track width: check "
            "masses, CG height and imu_z_m (negative when the IMU is below the sprung CG{})",
            fitted, usual, other_sign_text(fitted, usual));
    }

    // Empty where the other sign would be no better.
    std::string other_sign_text(double fitted_kgm2, double usual_kgm2) const {
        const VehicleData& vehicle = result_.vehicle;
        const double other_kgm2 =
            fitted_kgm2 - 2.0 * vehicle.sprung_mass_kg * result_.roll.arm_m * vehicle.imu_z_m;
        return std::abs(other_kgm2 - usual_kgm2) < std::abs(fitted_kgm2 - usual_kgm2)
                   ? fmt::format("; with the other sign Ixx would be about {:.0f} kg m2", other_kgm2)
                   : "";
    }

    void about_given_inertia(double given_kgm2) {
        const VehicleData& vehicle = result_.vehicle;
        const double radius_m = std::sqrt(given_kgm2 / vehicle.sprung_mass_kg);
        const double share = radius_m / vehicle.track_width_m;
        if (share < least_gyration_share || share > largest_gyration_share) {
            warn(
                "roll_inertia_kgm2 of the vehicle data, {:.0f} kg m2, means a radius of gyration of "
                "{:.2f} m, {:.2f} track widths; bodies have 0.35 to 0.55. The fit leans on it: correct it "
                "(about the roll axis of the sprung mass, in kg m2), or leave it out",
                given_kgm2, radius_m, share);
        }
    }

    void about_roll_centre() {
        const VehicleData& vehicle = result_.vehicle;
        if (!result_.loads && !vehicle.roll_centre_height_m) {
            warn(
                "without wheel loads a test drive gives only K/H, c/H and Ixx/H with H = h - h_rc: h_rc = "
                "{:.2f} m is taken, the road: no lift-off is missed as long as the roll centre lies on or "
                "above it. Below it, as with tyres that give sideways, warnings come late. It costs early "
                "warnings: if the roll centre lies at {:.2f} m, the component sees {:.0f} % more load "
                "transfer than there is. Give roll_centre_height_m if you know it (0 to 0.15 m with "
                "independent suspensions, 0.3 to 0.5 m with rigid axles, up to 0.9 m in trucks and buses)",
                result_.roll_centre_height_m, rigid_axle_m(),
                100.0 * (1.0 / ratio_at_computed_lift(rigid_axle_m()) - 1.0));
        }
        if (result_.loads) {
            about_loads(*result_.loads);
        } else {
            about_unchecked_heights();
        }
    }

    // In metres, because that is how they are measured again.
    void about_unchecked_heights() {
        const VehicleData& vehicle = result_.vehicle;
        const double higher_m = unseen_share * vehicle.sprung_cg_height_m;
        const double lift_rad = rollover_angle_rad(vehicle, result_.roll);
        const double lean_mps2 = g_mps2 * std::tan(lift_rad);
        const double whole_nm = 0.5 * vehicle.total_mass_kg * g_mps2 * vehicle.track_width_m;
        // At the computed lift: (m_s h + m_u h_u) A + m_s H g tan phi = whole_nm.
        const double parallel_mps2 =
            (whole_nm - vehicle.sprung_mass_kg * result_.roll.arm_m * lean_mps2) / height_moment_kgm(vehicle);
        const double more = vehicle.sprung_mass_kg * higher_m * (parallel_mps2 + lean_mps2) / whole_nm;
        warn(
            "without wheel loads nothing checks these heights: the sprung CG's, {:.3f} m of the vehicle "
            "data, and the roll centre's, {:.2f} m (0 to {:.2f} m with most suspensions, up to 0.9 m in "
            "trucks and buses). If the CG lies {:.3f} m higher ({:.0f} %), there is {:.0f} % more load "
            "transfer than the component sees, and warnings come late; if it lies as much lower, early",
            vehicle.sprung_cg_height_m, result_.roll_centre_height_m, rigid_axle_m(), higher_m,
            100.0 * unseen_share, 100.0 * more);
    }

    void about_loads(const LoadFit& loads) {
        const bool matched = loads.cg_height_m != result_.given_cg_height_m;
        if (loads.contradicts_data) {
            warn(
                "wheel loads and CG height contradict each other: with a roll centre at {:.2f} m the loads "
                "speak for a sprung CG at {:.3f} m, the vehicle data say {:.3f} m, too far apart to fit the "
                "height: check height, masses and track width",
                loads.roll_centre_height_m, loads.agreeing_cg_height_m, result_.given_cg_height_m);
        }
        if (result_.vehicle.roll_centre_height_m) {
            const double given_m = *result_.vehicle.roll_centre_height_m;
            if (std::abs(loads.roll_centre_at_given_height_m - given_m) > 0.15) {
                warn(
                    "the wheel loads speak for an effective roll centre at {:.2f} m; the given {:.2f} m is "
                    "kept",
                    loads.roll_centre_at_given_height_m, given_m);
            }
        } else if (matched) {
            warn(
                "the wheel loads would put the roll centre at {:.2f} m, where no suspension has it; tyres "
                "that give sideways or a load that sways do that, or a wrong CG height. It is set to "
                "{:.2f} m, and the CG height to {:.3f} m in place of {:.3f} m, which together give the "
                "wheel loads. --keep-cg-height keeps the given height",
                loads.roll_centre_at_given_height_m, loads.roll_centre_height_m, loads.cg_height_m,
                result_.given_cg_height_m);
        } else if (loads.agreeing_cg_height_m != result_.given_cg_height_m) {
            about_nearest_roll_centre(loads);
        }
    }

    void about_nearest_roll_centre(const LoadFit& loads) {
        if (!loads.contradicts_data) {
            warn(
                "the wheel loads would put the roll centre at {:.2f} m, where no suspension has it; tyres "
                "that give sideways do that. A CG height of {:.3f} m would agree with the wheel loads: "
                "measure it again, or leave --keep-cg-height out",
                loads.roll_centre_at_given_height_m, loads.agreeing_cg_height_m);
        }
        const double ratio = ratio_at_computed_lift(loads.roll_centre_at_given_height_m);
        warn(
            "the roll centre is taken at {:.2f} m, the nearest plausible to {:.2f} m, and the CG height "
            "stays at {:.3f} m. It costs {}: where the component computes that the inner wheels lift in a "
            "slow turn, the wheel loads speak for a load transfer ratio of {:.2f}",
            loads.roll_centre_height_m, loads.roll_centre_at_given_height_m, result_.given_cg_height_m,
            ratio > 1.0 ? "late and missed warnings" : "early warnings", ratio);
    }

    double rigid_axle_m() const { return std::min(0.5, 0.5 * result_.vehicle.sprung_cg_height_m); }

    // LTR of a vehicle whose roll centre lies at `height_m` where the component computes 1 in a slow turn.
    // They differ in H m_s g tan phi of the moment (m_s h + m_u h_u) A + H m_s g tan phi.
    double ratio_at_computed_lift(double height_m) const {
        const VehicleData& vehicle = result_.vehicle;
        const double lift_rad = rollover_angle_rad(vehicle, result_.roll);
        const double lean_nm = vehicle.sprung_mass_kg * g_mps2 * std::tan(lift_rad);
        const double whole_nm = 0.5 * vehicle.total_mass_kg * g_mps2 * vehicle.track_width_m;
        return 1.0 - (height_m - result_.roll_centre_height_m) * lean_nm / whole_nm;
    }

    void about_gradient() {
        const SteeringFit& steering = *result_.steering;
        const double gradient = steering.understeer_gradient_s2pm.value;
        if (gradient < 0.0) {
            warn(
                "the understeer gradient is {:.5f} s2/m: negative, so the vehicle would be unstable above "
                "{:.0f} km/h. Check steering_ratio ({:.1f}), the unit of the steering-wheel angle (of the "
                "handwheel, not of the front wheels) and of yaw rate and speed",
                gradient, std::sqrt(-result_.vehicle.wheelbase_m / gradient) * 3.6, steering.ratio.value);
        } else if (gradient > largest_understeer_gradient) {
            warn(
                "the understeer gradient is {:.5f} s2/m, vehicles have 0.001 to 0.006: check steering_ratio "
                "({:.1f}) and the unit of the steering-wheel angle, of yaw rate and of speed",
                gradient, steering.ratio.value);
        }
    }

    void about_response() {
        if (result_.steering_is_known() && (!result_.response || !result_.response->helps())) {
            warn(
                "how the lateral acceleration follows the steering does not show in the drives: the "
                "component will look ahead along the trend alone. A step steer or a lane change with a "
                "recorded steering-wheel angle shows it");
        } else if (result_.response && result_.response->at_a_bound) {
            warn(
                "the lateral response comes out at a bound of what is searched ({:.1f} rad/s, damping "
                "{:.2f}): check that steering-wheel angle and accelerometer are of one clock",
                result_.response->frequency_radps, result_.response->damping);
        }
    }

    // The suspension as the slow drives show it: a bank in a dynamic drive would go into it.
    void about_roll_reference() {
        const double arm_m = result_.roll.arm_m;
        const RollFit of_ramps = fit_roll(result_.vehicle, {arm_m, arm_m}, result_.ramps, {});
        for (const auto* drives : {&result_.ramps, &result_.dynamics}) {
            for (const PreparedDrive& drive : *drives) {
                if (const auto seen = seen_roll_reference(result_.vehicle, of_ramps, drive)) {
                    about_seen_reference(drive.name, *seen);
                }
            }
        }
    }

    void about_seen_reference(const std::string& drive, const SeenRollReference& seen) {
        const RollReference said = result_.vehicle.roll_angle_reference.value_or(RollReference::road);
        if (seen.reference == RollReference::road) {
            if (said == RollReference::horizon) {
                warn(
                    "{}: {}. The roll angle seems to be one against the road; the vehicle data say "
                    "roll_angle_reference = \"horizon\". Correct them",
                    drive, seen.by);
            }
            return;
        }
        if (said == RollReference::road) {
            warn(
                "{}: {}. The roll angle seems to be one against gravity, as an attitude sensor gives it: set "
                "roll_angle_reference = \"horizon\" in the vehicle data",
                drive, seen.by);
        }
        warn(
            "{}: the road is not level. Fitted is the angle of the body against the road, so the bank went "
            "into stiffness and damping: drive on a level road",
            drive);
    }

    void about_sensors() {
        for (const IdentifiedValue& value : result_.values) {
            if (value.key == "accelerometer_noise_mps2" || value.key == "speed_resolution_mps") {
                warn("the drives' sensors need {} = {:.3g}; check that these are the sensors of the vehicle",
                     value.key, value.value);
            }
        }
    }

    void about_admitted_ranges() {
        for (const IdentifiedValue& value : result_.values) {
            if (value.refused) {
                warn(
                    "{} would be {:.4g}, {}, {:.4g}, is written. Check the vehicle data, and the drives' "
                    "signs and units",
                    value.key, *value.refused, outside_admitted, value.value);
            }
        }
    }

    void about_steering() {
        if (result_.steering) {
            about_gradient();
        }
        if (!result_.steering) {
            warn("{}: steering ratio and understeer gradient are not from the drives{}", no_steering_text(),
                 result_.steering_is_known()
                     ? ""
                     : ", the lateral response w is 0 (not known), and the component looks ahead along the "
                       "trend alone: warnings come later. Give both in the vehicle data, or add a ramp that "
                       "shows them");
        } else if (result_.steering->r_squared < 0.9) {
            warn(
                "steering and yaw rate fit badly together (R2 {:.3f}): check the sign and the unit of "
                "both, and the steering ratio",
                result_.steering->r_squared);
        } else if (!result_.steering->gradient_fitted && !result_.vehicle.understeer_gradient_s2pm) {
            warn(
                "neither steering ratio nor understeer gradient is given, and the ramps are of one speed: "
                "the ratio {:.1f} belongs to an assumed gradient of {} s2/m",
                result_.steering->ratio.value, usual_understeer_gradient_s2pm);
        }
    }

    std::string no_steering_text() const {
        switch (why_no_steering(result_.ramps)) {
            case NoSteering::not_recorded:
                break;
            case NoSteering::too_fast:
                return fmt::format(
                    "in the ramps, the steering wheel turns faster than {:.0f} deg/s nearly all the time "
                    "between 0.1 and 0.4 g, too fast for ratio and gradient of a steady turn",
                    fastest_ramp_steering_radps * degrees_per_radian);
            case NoSteering::hardly_any_turn:
                return fmt::format(
                    "the ramps are hardly ever between 0.1 and 0.4 g of yaw rate times speed, faster than "
                    "{:.0f} m/s",
                    slowest_ramp_mps);
        }
        return "no ramp has steering-wheel angle, yaw rate and speed";
    }

    void about_offsets() {
        for (const auto* drives : {&result_.ramps, &result_.dynamics}) {
            for (const PreparedDrive& drive : *drives) {
                if (const auto doubt = straight_start_doubt(drive)) {
                    warn("{}: {}", drive.name, *doubt);
                }
            }
        }
    }

    const Identification& result_;
    std::vector<std::string> warnings_;
};

}  // namespace

std::optional<std::string> straight_start_doubt(const PreparedDrive& drive) {
    const SensorOffsets& offsets = drive.offsets;
    if (!offsets.known) {
        return fmt::format(
            "does not start with a long enough straight, as the {} shows (a second will do): sensor offsets "
            "are guessed from the drive itself",
            offsets.judged_by);
    }
    if (std::abs(offsets.lateral_mps2) > 0.02 * g_mps2 ||
        std::abs(offsets.roll_angle_rad) * degrees_per_radian > 0.5) {
        return fmt::format(
            "on the straight the sensors show {:+.3f} g and {:+.2f} deg of roll; that was taken off here, "
            "but the component does not do so: zero the sensors, or drive on a level road",
            offsets.lateral_mps2 / g_mps2, offsets.roll_angle_rad * degrees_per_radian);
    }
    return std::nullopt;
}

std::vector<std::string> identification_warnings(const Identification& result) {
    return Warnings{result}.all();
}

}  // namespace sil
