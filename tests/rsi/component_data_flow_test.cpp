// The outputs of one step belong together: each number of the component follows from the others by its
// equation, evaluated here in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rsi/component.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/random_manoeuvre.hpp"

namespace component_data_flow_test {
namespace {

constexpr double m_s = 2060.0;
constexpr double h = 0.988;
constexpr double h_frc = 0.281;
constexpr double H = h - h_frc;
constexpr double c_w = 1.6;
constexpr double K_f = 96.0e3;
constexpr double c_f = 8.0e3;

double wide(float value) {
    return static_cast<double>(value);
}

struct Step {
    rsi_inputs inputs{};
    rsi_outputs outputs{};
};

// Calls check(now, next) for each two neighbouring steps of a minute that goes to the limits in both
// directions.
template <typename Check>
void for_each_step(Check check) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_test::RandomManoeuvre drive(parameters, 73U, false);
    rsi::Component component;
    ASSERT_EQ(component.init(parameters).accepted, 1);
    Step now;
    for (int k = 0; k < 6000; ++k) {
        Step next;
        next.inputs = drive.next();
        component.step(next.inputs, next.outputs);
        if (k > 0) {
            check(now, next);
        }
        now = next;
    }
}

TEST(ComponentDataFlow, TheLateralRollCentreFollowsEquationSix) {
    for_each_step([](const Step& now, const Step&) {
        const double dh = wide(now.outputs.roll_centre_vertical_m);
        const double expected = H * std::tan(wide(now.outputs.fixed_model_roll_angle_rad)) -
                                (H - dh) * std::tan(wide(now.inputs.roll_angle_rad));
        ASSERT_NEAR(wide(now.outputs.roll_centre_lateral_m), expected, 1.0e-6);
    });
}

TEST(ComponentDataFlow, TheAdditionalMomentFollowsEquationSeven) {
    for_each_step([](const Step& now, const Step&) {
        const double expected =
            -(m_s * wide(now.outputs.road_parallel_force_mps2) * wide(now.outputs.roll_centre_vertical_m) +
              m_s * wide(now.outputs.road_normal_force_mps2) * wide(now.outputs.roll_centre_lateral_m) +
              wide(now.outputs.roll_stiffness_deviation_nmprad) * wide(now.inputs.roll_angle_rad) +
              wide(now.outputs.roll_damping_deviation_nmsprad) * wide(now.inputs.roll_rate_radps));
        ASSERT_NEAR(wide(now.outputs.additional_roll_moment_nm), expected, 0.05);
    });
}

// (23) with the estimated roll centre; the bank does not come back in the outputs, so it is taken from the
// inputs.
TEST(ComponentDataFlow, TheThresholdUsesTheEstimatedRollCentre) {
    for_each_step([](const Step& now, const Step&) {
        const double s = (now.outputs.road_parallel_force_mps2 < 0.0F) ? -1.0 : 1.0;
        const double h_rc = h_frc + wide(now.outputs.roll_centre_vertical_m);
        const double shift =
            wide(now.outputs.roll_centre_lateral_m) + (h - h_rc) * std::tan(wide(now.inputs.roll_angle_rad));
        const double T = (0.5 * c_w - s * shift) / h;
        ASSERT_NEAR(wide(now.outputs.rsi_bank_free),
                    std::fabs(wide(now.outputs.road_parallel_force_mps2)) /
                        wide(now.outputs.road_normal_force_mps2) / T,
                    1.0e-5);
        const double bank = std::isnan(now.inputs.bank_angle_rad) ? 0.0 : wide(now.inputs.bank_angle_rad);
        // The critical road-parallel and road-normal forces are in the ratio T; turned back by the bank.
        const double expected = s * rsi_test::gravity_mps2 * std::tan(std::atan(T) - s * bank);
        ASSERT_NEAR(wide(now.outputs.lateral_acceleration_threshold_mps2), expected, 1.0e-4);
    });
}

TEST(ComponentDataFlow, TheIndicatorIsTheShareOfTheThreshold) {
    for_each_step([](const Step& now, const Step&) {
        const double share = wide(now.outputs.lateral_acceleration_mps2) /
                             wide(now.outputs.lateral_acceleration_threshold_mps2);
        ASSERT_NEAR(wide(now.outputs.rsi), std::clamp(share, 0.0, 1.0), 1.0e-6);
    });
}

// Angle at which the compensated model would come to rest under what acts on it in a step.
double compensated_goal_rad(const rsi_outputs& outputs) {
    const double force =
        wide(outputs.road_parallel_force_mps2) +
        wide(outputs.road_normal_force_mps2) * std::tan(wide(outputs.fixed_model_roll_angle_rad));
    return (m_s * H * force + wide(outputs.additional_roll_moment_nm)) / K_f;
}

// With everything that acts on it going in a straight line from one sample to the next, the compensated model
// is linear, so its next angle is known in closed form. With z = T K_f / c_f the trapezoidal rule errs by z^3
// / 12 = 1.5e-4 of the way still to go and by z^2 / 12 = 1.2e-3 of the way that the goal has gone; a force of
// the sample before alone would err by z / 2 = 0.06 of that.
TEST(ComponentDataFlow, TheCompensatedModelMovesUnderTheAdditionalMoment) {
    for_each_step([](const Step& now, const Step& next) {
        const double z = 0.01 * K_f / c_f;
        const double angle = wide(now.outputs.compensated_roll_angle_rad);
        const double goal = compensated_goal_rad(now.outputs);
        const double change = compensated_goal_rad(next.outputs) - goal;
        const double expected =
            goal + (angle - goal) * std::exp(-z) + change * (1.0 - (1.0 - std::exp(-z)) / z);
        ASSERT_NEAR(wide(next.outputs.compensated_roll_angle_rad), expected,
                    1.6e-4 * std::fabs(angle - goal) + 1.2e-3 * std::fabs(change) + 1.0e-6);
    });
}

}  // namespace
}  // namespace component_data_flow_test
