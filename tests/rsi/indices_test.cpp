// Extended indicator, load transfer, prediction and the paper's other indices, through the component, against
// the equations in double.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "rsi/component.hpp"
#include "rsi/indicator/extended_indicator.hpp"
#include "rsi/indicator/load_transfer.hpp"
#include "rsi/model/critical_roll_angle.hpp"
#include "tests/rsi/support/body_kinematics.hpp"
#include "tests/rsi/support/damage.hpp"
#include "tests/rsi/support/index_reference.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/random_manoeuvre.hpp"

namespace indices_test {
namespace {

using rsi_test::gravity_mps2;
using rsi_test::ReferenceVehicle;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

double wide(float value) {
    return static_cast<double>(value);
}

// The motion that the indicators share, in double, from the forces that the component reports and the roll
// sensors' values.
class ReferenceMotion {
 public:
    explicit ReferenceMotion(double lag_s)
        : A{lag_s}, N{lag_s}, phi{lag_s}, p{lag_s}, trend_{lag_s}, roll_{lag_s} {}

    void next(const rsi_inputs& inputs, const rsi_outputs& outputs) {
        A.next(wide(outputs.road_parallel_force_mps2));
        N.next(wide(outputs.road_normal_force_mps2));
        // The bank's share is not lagged.
        a_y = A.value() - (wide(outputs.road_parallel_force_mps2) - wide(outputs.lateral_acceleration_mps2));
        phi.next(wide(inputs.roll_angle_rad));
        p.next(wide(inputs.roll_rate_radps));
        force_rate = trend_.next(A.derivative());
        roll_acceleration = roll_.next(p.derivative());
    }

    rsi_test::ReferenceSignal A, N, phi, p;
    double a_y{0.0};
    double force_rate{0.0};
    double roll_acceleration{0.0};

 private:
    rsi_test::ReferenceLag trend_;
    rsi_test::ReferenceLag roll_;
};

// Demand of the steering along the road; empty if it is not known.
rsi_test::ReferenceForce force_ahead(const rsi_parameters& p, const rsi_inputs& inputs,
                                     const rsi_outputs& outputs, const ReferenceMotion& motion) {
    rsi_test::ReferenceForce force{motion.A.value(), motion.force_rate, wide(p.acceleration_trend_s)};
    if (std::isnan(inputs.steering_wheel_angle_rad) || std::isnan(inputs.speed_mps)) {
        return force;
    }
    const double V = wide(inputs.speed_mps);
    const double delta = wide(inputs.steering_wheel_angle_rad) / wide(p.steering_ratio);
    const double a_d = V * V * delta / (wide(p.wheelbase_m) + wide(p.understeer_gradient_s2pm) * V * V);
    const double bank = wide(outputs.road_parallel_force_mps2) - wide(outputs.lateral_acceleration_mps2);
    const double most = wide(p.largest_lateral_acceleration_mps2);
    force.bounded = true;
    force.demand = std::clamp(a_d + bank, -most, most);
    return force;
}

double rollover_index(const rsi_parameters& p, double phi, double rate, double a_y) {
    const double C_1 = wide(p.rollover_index_angle_weight);
    const double C_2 = wide(p.rollover_index_acceleration_weight);
    const double phi_th = wide(p.rollover_index_roll_angle_rad);
    const double rate_th = wide(p.rollover_index_roll_rate_radps);
    if (phi * (rate - wide(p.rollover_index_slope_radps) * phi) <= 0.0) {
        return 0.0;
    }
    return C_1 * (std::fabs(phi) * rate_th + std::fabs(rate) * phi_th) / (phi_th * rate_th) +
           C_2 * std::fabs(a_y) / wide(p.rollover_index_acceleration_mps2) +
           (1.0 - C_1 - C_2) * std::fabs(phi) / std::hypot(phi, rate);
}

void expect_state_indices(const rsi_parameters& p, const rsi_outputs& out, const ReferenceMotion& motion) {
    const ReferenceVehicle v{p};
    const double A = motion.A.value();
    const double N = motion.N.value();
    const double x = motion.phi.value();
    EXPECT_NEAR(wide(out.load_transfer_ratio), v.load_transfer(A, N, x, motion.p.value()), 2e-4);
    EXPECT_NEAR(wide(out.rsi_extended), v.extended(A, N, x, motion.roll_acceleration), 2e-3);
}

void expect_classic_indices(const rsi_parameters& p, const rsi_inputs& in, const rsi_outputs& out,
                            const ReferenceMotion& motion) {
    const ReferenceVehicle v{p};
    const double share = v.Ixx * motion.roll_acceleration / (v.m_s * gravity_mps2 * v.h);
    EXPECT_NEAR(wide(out.dynamic_stability_index), motion.a_y / gravity_mps2 - share, 1e-4);
    EXPECT_NEAR(wide(out.dynamic_stability_index_late), motion.a_y / gravity_mps2 + share, 1e-4);
    const double a_y = wide(out.lateral_acceleration_mps2);
    const double phi = wide(in.roll_angle_rad);
    const double rate = wide(in.roll_rate_radps);
    EXPECT_NEAR(wide(out.static_stability_level), std::fabs(a_y) / (gravity_mps2 * v.c_w / (2.0 * v.h)),
                1e-5);
    EXPECT_NEAR(wide(out.energy_margin), 1.0 - v.energy(phi, rate) / v.energy(v.critical_angle(), 0.0), 1e-4);
    EXPECT_NEAR(wide(out.rollover_index), rollover_index(p, phi, rate, a_y), 1e-5);
    const double left = v.critical_angle() - std::fabs(phi);
    const double time = (phi * rate > 0.0) ? std::max(left, 0.0) / std::fabs(rate) : 10.0;
    EXPECT_NEAR(wide(out.time_to_rollover_s), std::min(time, 10.0), 1e-4 + 2e-3 * std::min(time, 10.0));
}

TEST(Indices, FollowTheEquationsOverALivelyDriveWithNoiseAndBank) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.prediction_horizon_s = 0.11F;
    rsi::Component component;
    ASSERT_EQ(component.init(parameters).accepted, 1);
    rsi_test::RandomManoeuvre drive(parameters, 83U, false);
    ReferenceMotion motion{wide(parameters.prediction_filter_lag_s)};
    ReferenceVehicle vehicle{parameters};
    rsi_test::ReferenceMomentArmError moment_arm_error;
    int ahead = 0;
    int with_demand = 0;
    for (int k = 0; k < 20000 && !HasFailure(); ++k) {
        const rsi_inputs inputs = drive.next();
        rsi_outputs out;
        component.step(inputs, out);
        motion.next(inputs, out);
        expect_state_indices(parameters, out, motion);
        expect_classic_indices(parameters, inputs, out, motion);
        vehicle.e = moment_arm_error.next(vehicle, motion.A.value(), motion.N.value(), motion.phi.value(),
                                          motion.p.value(), motion.roll_acceleration,
                                          wide(parameters.excitation_threshold_mps2));
        const rsi_test::ReferenceForce force = force_ahead(parameters, inputs, out, motion);
        const double L =
            rsi_test::predicted_load_transfer(vehicle, force, motion.N.value(), motion.phi.value(),
                                              motion.p.value(), wide(parameters.prediction_horizon_s), 5);
        EXPECT_NEAR(std::fabs(wide(out.predicted_load_transfer_ratio)), std::fabs(L),
                    rsi_test::prediction_tolerance(L))
            << "step " << k;
        EXPECT_GE(std::fabs(out.predicted_load_transfer_ratio), std::fabs(out.load_transfer_ratio));
        EXPECT_GE(out.predicted_rsi, out.rsi_extended);
        ahead += (std::fabs(L) > std::fabs(wide(out.load_transfer_ratio)) + 0.1) ? 1 : 0;
        with_demand += force.bounded ? 1 : 0;
    }
    EXPECT_GT(ahead, 1000);
    EXPECT_GT(with_demand, 10000);
    EXPECT_LT(with_demand, 20000);
}

rsi_inputs turning(double a_y, double phi) {
    return rsi_test::sensed(rsi_test::GroundMotion{a_y, 0.0, 0.0, phi});
}

// (27) in ISO 8855: a body that speeds up its roll outwards leaves the inner wheels with more load for the
// moment, so the physical index (minus) comes later at the onset than with the late sign's plus, and the
// other way round when the roll is being stopped, just before the peak. There the early index warns.
TEST(Indices, OfTheTwoDynamicStabilityIndicesTheEarlyOneLeadsWhereTheRollIsStopped) {
    for (const double side : {1.0, -1.0}) {
        rsi::Component component;
        ASSERT_EQ(component.init(rsi_test::large_suv()).accepted, 1);
        double rate = 0.0;
        rsi_outputs out;
        const auto run = [&](int samples, double roll_acceleration) {
            for (int k = 0; k < samples; ++k) {
                rsi_inputs inputs = turning(side * 5.0, side * 0.05);
                inputs.roll_rate_radps = static_cast<float>(side * rate);
                component.step(inputs, out);
                rate += 0.01 * roll_acceleration;
            }
        };
        const double force_share = side * 5.0 / gravity_mps2;
        const double inertia_share = side * 2.0 * 950.0 / (2060.0 * gravity_mps2 * 0.988);
        run(30, 0.0);
        EXPECT_NEAR(wide(out.dynamic_stability_index), force_share, 1e-4);
        EXPECT_NEAR(wide(out.dynamic_stability_index_late), force_share, 1e-4);
        run(50, 2.0);
        EXPECT_NEAR(wide(out.dynamic_stability_index), force_share - inertia_share, 1e-4);
        EXPECT_NEAR(wide(out.dynamic_stability_index_late), force_share + inertia_share, 1e-4);
        run(50, -2.0);
        EXPECT_NEAR(wide(out.dynamic_stability_index), force_share + inertia_share, 1e-4);
        EXPECT_NEAR(wide(out.dynamic_stability_index_late), force_share - inertia_share, 1e-4);
    }
}

rsi_outputs one_step(const rsi_parameters& parameters, const rsi_inputs& inputs) {
    rsi::Component component;
    EXPECT_EQ(component.init(parameters).accepted, 1);
    rsi_outputs out;
    component.step(inputs, out);
    return out;
}

TEST(Indices, TheEnergyMarginIsOneAtRestAndZeroAtTheCriticalAngle) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const double critical = ReferenceVehicle{parameters}.critical_angle();
    EXPECT_EQ(one_step(parameters, rsi_test::at_rest()).energy_margin, 1.0F);
    for (const double side : {1.0, -1.0}) {
        const rsi_outputs out = one_step(parameters, turning(side * 6.0, side * critical));
        EXPECT_NEAR(wide(out.energy_margin), 0.0, 1e-5);
        EXPECT_GT(one_step(parameters, turning(side * 6.0, side * (critical - 0.001))).energy_margin, 0.01F);
        EXPECT_LT(one_step(parameters, turning(side * 6.0, side * (critical + 0.001))).energy_margin, -0.01F);
    }
}

TEST(Indices, TheTimeToRolloverCountsOnlyWhileRollingOutwards) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const double critical = ReferenceVehicle{parameters}.critical_angle();
    rsi_inputs inputs = turning(5.0, 0.05);
    inputs.roll_rate_radps = 0.1F;
    EXPECT_NEAR(wide(one_step(parameters, inputs).time_to_rollover_s), (critical - 0.05) / 0.1, 1e-4);
    inputs.roll_rate_radps = -0.1F;
    EXPECT_EQ(one_step(parameters, inputs).time_to_rollover_s, 10.0F);
    inputs.roll_rate_radps = 0.0F;
    EXPECT_EQ(one_step(parameters, inputs).time_to_rollover_s, 10.0F);
    inputs.roll_rate_radps = 1.0e-40F;
    EXPECT_EQ(one_step(parameters, inputs).time_to_rollover_s, 10.0F);
    inputs.roll_angle_rad = static_cast<float>(critical + 0.01);
    inputs.roll_rate_radps = 0.1F;
    EXPECT_EQ(one_step(parameters, inputs).time_to_rollover_s, 0.0F);
    inputs.roll_rate_radps = 0.0F;
    for (const float on_its_side : {1.4F, -1.4F}) {
        inputs.roll_angle_rad = on_its_side;
        EXPECT_EQ(one_step(parameters, inputs).time_to_rollover_s, 0.0F);
    }
}

// The gate with k_1 = -5 1/s: shut while the body swings back faster than 5 times its angle a second.
TEST(Indices, TheRolloverIndexIsZeroBehindItsGate) {
    const rsi_parameters parameters = rsi_test::large_suv();
    for (const float side : {1.0F, -1.0F}) {
        rsi_inputs inputs = turning(wide(side) * 5.0, wide(side) * 0.05);
        inputs.roll_rate_radps = side * -0.26F;
        EXPECT_EQ(one_step(parameters, inputs).rollover_index, 0.0F);
        inputs.roll_rate_radps = side * -0.24F;
        EXPECT_GT(one_step(parameters, inputs).rollover_index, 0.3F);
    }
    EXPECT_EQ(one_step(parameters, rsi_test::at_rest()).rollover_index, 0.0F);
}

// Held at the angle and force at which a steady turn lifts the inner wheels of the extended model: both the
// extended indicator and the load transfer say 1, because springs, links and weight balance there.
TEST(Indices, InASteadyTurnTheExtendedIndicatorAndTheLoadTransferReachOneTogether) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const ReferenceVehicle v{parameters};
    double low = 0.0;
    double high = 12.0;
    double phi = 0.0;
    for (int halving = 0; halving < 60; ++halving) {
        const double A = 0.5 * (low + high);
        double below = 0.0;
        double above = 0.4;
        for (int inner = 0; inner < 60; ++inner) {
            phi = 0.5 * (below + above);
            ((v.roll_acceleration(A, gravity_mps2, phi, 0.0) > 0.0) ? below : above) = phi;
        }
        ((v.load_transfer(A, gravity_mps2, phi, 0.0) < 1.0) ? low : high) = A;
    }
    const rsi_outputs out = one_step(parameters, turning(low, phi));
    EXPECT_NEAR(wide(out.load_transfer_ratio), 1.0, 1e-3);
    EXPECT_NEAR(wide(out.rsi_extended), 1.0, 1e-3);
    EXPECT_NEAR(wide(out.predicted_load_transfer_ratio), 1.0, 1e-3);
    EXPECT_NEAR(wide(out.predicted_rsi), 1.0, 1e-3);
}

TEST(Indices, AGapIsNoMovement) {
    rsi_parameters parameters = rsi_test::large_suv();
    rsi::Component component;
    ASSERT_EQ(component.init(parameters).accepted, 1);
    rsi_outputs out;
    for (int k = 0; k < 100; ++k) {
        component.step(turning(-6.0, -0.08), out);
    }
    rsi_inputs missing = turning(6.0, 0.08);
    missing.roll_rate_radps = nan;
    component.step(missing, out);
    EXPECT_TRUE(std::isnan(out.predicted_load_transfer_ratio));
    component.step(turning(6.0, 0.08), out);
    const rsi_outputs fresh = one_step(parameters, turning(6.0, 0.08));
    EXPECT_EQ(out.predicted_load_transfer_ratio, fresh.predicted_load_transfer_ratio);
    EXPECT_EQ(out.rsi_extended, fresh.rsi_extended);
    EXPECT_EQ(out.dynamic_stability_index, fresh.dynamic_stability_index);
}

// Nor is anything left of what was predicted from.
TEST(Indices, AGapForgetsTheMotionAndWhatWasLearntOfIt) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const auto inputs_at = [](int sample) {
        rsi_inputs inputs = turning(3.0 + 0.3 * sample, 0.05);
        inputs.roll_rate_radps = 0.3F;
        inputs.speed_mps = 20.0F;  // and the steering wheel in the middle: a demand of none
        inputs.steering_wheel_angle_rad = 0.0F;
        return inputs;
    };
    rsi::Component driven;
    ASSERT_EQ(driven.init(parameters).accepted, 1);
    rsi_outputs of_driven;
    for (int sample = 0; sample < 20; ++sample) {
        driven.step(inputs_at(sample), of_driven);
    }
    rsi_inputs missing = inputs_at(0);
    missing.roll_rate_radps = nan;
    driven.step(missing, of_driven);
    rsi::Component fresh;
    ASSERT_EQ(fresh.init(parameters).accepted, 1);
    rsi_outputs of_fresh;
    for (int sample = 0; sample < 10; ++sample) {
        driven.step(inputs_at(sample), of_driven);
        fresh.step(inputs_at(sample), of_fresh);
        EXPECT_EQ(of_driven.predicted_load_transfer_ratio, of_fresh.predicted_load_transfer_ratio) << sample;
        EXPECT_EQ(of_driven.predicted_rsi, of_fresh.predicted_rsi) << sample;
    }
}

// None that exceeds its range, whatever the calibration.
TEST(ClassicIndices, EndAtTheirBounds) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.track_width_m = 0.8F;
    parameters.sprung_cg_height_m = 2.0F;  // a static stability factor of 0.2
    parameters.roll_stiffness_nmprad = 1.0e5F;
    parameters.rollover_index_roll_rate_radps = 0.1F;
    const rsi::ClassicIndices indices{parameters, rsi::critical_roll_angle_rad(parameters)};
    for (const float side : {1.0F, -1.0F}) {
        rsi::Measurement measured;
        measured.lateral_acceleration_mps2 = side * 60.0F;
        measured.roll_angle_rad = side * 0.1F;
        measured.roll_rate_radps = side * 10.0F;
        rsi::RollMotion motion;
        motion.lateral_acceleration_mps2 = side * 60.0F;
        motion.roll_acceleration_radps2 = side * -5000.0F;
        rsi_outputs values{};
        indices.evaluate(measured, motion, values);
        EXPECT_EQ(values.static_stability_level, 20.0F);
        EXPECT_EQ(values.dynamic_stability_index, side * 20.0F);
        EXPECT_EQ(values.dynamic_stability_index_late, side * -20.0F);
        EXPECT_EQ(values.energy_margin, -20.0F);
        EXPECT_EQ(values.rollover_index, 20.0F);
    }
}

TEST(ClassicIndices, OfTheStaticStabilityFactorIsTheShareOfItThatIsUsed) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const ReferenceVehicle vehicle{parameters};
    const rsi::ClassicIndices indices{parameters, rsi::critical_roll_angle_rad(parameters)};
    for (const float acceleration : {-6.0F, 0.0F, 0.5F, 8.0F}) {
        rsi::Measurement measured;
        measured.lateral_acceleration_mps2 = acceleration;
        rsi_outputs values{};
        indices.evaluate(measured, rsi::RollMotion{}, values);
        EXPECT_NEAR(wide(values.static_stability_level),
                    std::fabs(wide(acceleration)) / (gravity_mps2 * vehicle.c_w / (2.0 * vehicle.h)), 1e-6);
    }
}

// Each byte in turn; the critical roll angle is kept, so damage to it stays.
TEST(ClassicIndices, MadeAnewRepairAllButTheCriticalRollAngle) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi::Measurement measured;
    measured.lateral_acceleration_mps2 = 6.0F;
    measured.roll_angle_rad = 0.08F;
    measured.roll_rate_radps = 0.3F;
    measured.tan_roll_angle = 0.08F;
    measured.versine_roll_angle = 0.0032F;
    rsi::RollMotion motion;
    motion.lateral_acceleration_mps2 = 6.0F;
    motion.roll_acceleration_radps2 = 2.0F;
    const auto answer = [&](const rsi::ClassicIndices& indices) {
        rsi_outputs outputs{};
        indices.evaluate(measured, motion, outputs);
        return outputs;
    };
    const rsi::ClassicIndices sound{parameters, rsi::critical_roll_angle_rad(parameters)};
    const rsi_outputs expected = answer(sound);
    const std::size_t kept = rsi_test::bytes_whose_damage_shows(sound, [&](rsi::ClassicIndices& damaged) {
        damaged = rsi::ClassicIndices{parameters, damaged.critical_roll_angle_rad()};
        const rsi_outputs answered = answer(damaged);
        return std::memcmp(&answered, &expected, sizeof expected) == 0;
    });
    EXPECT_LE(kept, sizeof(float));
}

TEST(ClassicIndices, NoTimeIsLeftAtTheStaticStabilityFactorItself) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const rsi::ClassicIndices indices{parameters, rsi::critical_roll_angle_rad(parameters)};
    rsi::Measurement measured;
    measured.tan_roll_angle = parameters.track_width_m / (2.0F * parameters.sprung_cg_height_m);
    rsi_outputs outputs{};
    indices.evaluate(measured, rsi::RollMotion{}, outputs);
    EXPECT_EQ(outputs.time_to_rollover_s, 0.0F);
    measured.tan_roll_angle *= 0.999F;
    indices.evaluate(measured, rsi::RollMotion{}, outputs);
    EXPECT_EQ(outputs.time_to_rollover_s, 10.0F);
}

// k phi - T_0 - q tan phi is zero at the wanted angle by the choice of the track.
TEST(CriticalRollAngle, IsFoundUpToOneRadianAndNotBeyond) {
    rsi_parameters parameters = rsi_test::large_suv();
    const ReferenceVehicle v{parameters};
    for (const double angle_rad : {0.05, 0.5, 0.99, 1.02, 1.2}) {
        const double k = v.K / (v.m_s * gravity_mps2 * (v.h - v.h_rc));
        const double T_0 = k * angle_rad - v.h_rc / v.h * std::tan(angle_rad);
        parameters.track_width_m = static_cast<float>(2.0 * v.h * T_0);
        const float found = rsi::critical_roll_angle_rad(parameters);
        if (angle_rad <= 1.0) {
            EXPECT_NEAR(wide(found), angle_rad, 1.0e-4);
        } else {
            EXPECT_TRUE(std::isnan(found)) << angle_rad;
        }
    }
}

// If nothing rights the vehicle, T_dyn is 0.001 + 0.05 |A/N|.
TEST(ExtendedIndicator, EndsShortOfTwenty) {
    const rsi::Vehicle vehicle{rsi_test::large_suv()};
    for (const double N : {1.0, 5.0}) {
        for (const double side : {1.0, -1.0}) {
            const double expected = (60.0 / N) / (0.001 + 0.05 * 60.0 / N);
            rsi::RollMotion motion;
            motion.road_parallel_force_mps2 = static_cast<float>(side * 60.0);
            motion.road_normal_force_mps2 = static_cast<float>(N);
            motion.roll_angle_rad = static_cast<float>(side * 1.66);  // a tangent above 3
            EXPECT_NEAR(wide(rsi::extended_level(motion, vehicle.loaded)), expected, 1.0e-4 * expected);
        }
    }
}

}  // namespace
}  // namespace indices_test
