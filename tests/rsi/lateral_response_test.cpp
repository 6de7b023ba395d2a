// The lateral response: how the force goes on under the present steering, and the limit that it learns.
#include "rsi/prediction/lateral_response.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace lateral_response_test {
namespace {

constexpr double frequency_radps = 9.0;
constexpr double damping = 0.7;
constexpr float largest_mps2 = 7.0F;
constexpr int samples_in_5_s = 500;

rsi_parameters with_response(double w = frequency_radps, double zeta = damping) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.lateral_response_frequency_radps = static_cast<float>(w);
    parameters.lateral_response_damping = static_cast<float>(zeta);
    parameters.largest_lateral_acceleration_mps2 = largest_mps2;
    return parameters;
}

rsi::RollMotion turning(double A, double rate = 0.0) {
    rsi::RollMotion motion;
    motion.road_parallel_force_mps2 = static_cast<float>(A);
    motion.road_parallel_force_rate_mps3 = static_cast<float>(rate);
    return motion;
}

rsi::DemandedForce asking(double force_mps2) {
    rsi::DemandedForce demand;
    demand.force_mps2 = static_cast<float>(force_mps2);
    demand.is_known = true;
    return demand;
}

struct Course {
    double force;
    double rate;
};

// A'' = w^2 (a_t - A) - 2 zeta w A', by small steps of the midpoint rule.
Course reference(Course from, double target, double time_s, double w = frequency_radps,
                 double zeta = damping) {
    constexpr double dt = 1.0e-5;
    const auto acceleration = [&](const Course& at) {
        return w * w * (target - at.force) - 2.0 * zeta * w * at.rate;
    };
    const int steps = static_cast<int>(std::lround(time_s / dt));
    for (int k = 0; k < steps; ++k) {
        const Course half{from.force + 0.5 * dt * from.rate, from.rate + 0.5 * dt * acceleration(from)};
        from = {from.force + dt * half.rate, from.rate + dt * acceleration(half)};
    }
    return from;
}

double after_steps(const rsi_test::LateralResponse& response, const rsi::RollMotion& motion, int steps) {
    rsi::ForceCourse course{motion.road_parallel_force_mps2, motion.road_parallel_force_rate_mps3};
    for (int k = 0; k < steps; ++k) {
        course = response.after_step(course);
    }
    return static_cast<double>(course.force_mps2);
}

// The limit, as the force that an endless demand leads to.
double limit_of(rsi_test::LateralResponse response, double direction = 1.0) {
    EXPECT_TRUE(response.update(turning(0.0), asking(60.0 * direction)));
    return direction * after_steps(response, turning(0.0), 500);
}

TEST(LateralResponse, IsKnownWithSteeringSpeedAndACalibratedResponse) {
    rsi_test::LateralResponse response;
    response.init(with_response());
    EXPECT_TRUE(response.update(turning(1.0), asking(2.0)));
    EXPECT_FALSE(response.update(turning(1.0), rsi::DemandedForce{}));
    response.init(with_response(0.0));
    EXPECT_FALSE(response.update(turning(1.0), asking(2.0)));
}

TEST(LateralResponse, FollowsTheSecondOrderEquation) {
    for (const double w : {4.0, 9.0, 18.0}) {
        for (const double zeta : {0.7, 1.3}) {
            rsi_test::LateralResponse response;
            response.init(with_response(w, zeta));
            const rsi::RollMotion motion = turning(1.0, 8.0);
            ASSERT_TRUE(response.update(motion, asking(6.0)));
            for (const int steps : {1, 2, 3, 5, 8, 15}) {
                const Course expected = reference(
                    {1.0, 8.0}, 6.0, steps * static_cast<double>(rsi::LateralResponse::step_s), w, zeta);
                if (expected.force < 6.0) {
                    EXPECT_NEAR(after_steps(response, motion, steps), expected.force, 0.06)
                        << w << ' ' << zeta << ' ' << steps;
                } else {
                    EXPECT_EQ(after_steps(response, motion, steps), 6.0) << w << ' ' << zeta << ' ' << steps;
                }
            }
        }
    }
}

TEST(LateralResponse, SwingsToTheOtherSideWhenTheSteeringAsksForIt) {
    rsi_test::LateralResponse response;
    response.init(with_response());
    const rsi::RollMotion motion = turning(5.0, -20.0);
    ASSERT_TRUE(response.update(motion, asking(-6.0)));
    EXPECT_NEAR(after_steps(response, motion, 5), reference({5.0, -20.0}, -6.0, 0.2).force, 0.1);
    EXPECT_LT(after_steps(response, motion, 8), -1.0);
}

TEST(LateralResponse, GoesNeitherPastItsTargetNorPastWhereItIsNorPastZero) {
    rsi_test::LateralResponse response;
    response.init(with_response(18.0, 0.5));
    ASSERT_TRUE(response.update(turning(2.0, 60.0), asking(4.0)));
    EXPECT_EQ(after_steps(response, turning(2.0, 60.0), 5), 4.0);
    ASSERT_TRUE(response.update(turning(5.0, 60.0), asking(4.0)));
    EXPECT_EQ(after_steps(response, turning(5.0, 60.0), 1), 5.0);
    ASSERT_TRUE(response.update(turning(1.0, -90.0), asking(1.0)));
    EXPECT_EQ(after_steps(response, turning(1.0, -90.0), 2), 0.0);
}

TEST(LateralResponse, BeginsWithTheCalibrationsLimit) {
    rsi_test::LateralResponse response;
    response.init(with_response());
    EXPECT_NEAR(limit_of(response), static_cast<double>(largest_mps2), 1e-3);
    EXPECT_NEAR(limit_of(response, -1.0), static_cast<double>(largest_mps2), 1e-3);
}

TEST(LateralResponse, LearnsWithinSixTenthsThatTheTyresGiveNoMore) {
    for (const double side : {1.0, -1.0}) {
        rsi_test::LateralResponse response;
        response.init(with_response());
        for (int k = 0; k < 60; ++k) {
            response.update(turning(4.0 * side), asking(12.0 * side));
        }
        EXPECT_NEAR(limit_of(response), 4.0 + 3.0 * std::exp(-3.0), 0.05);
        EXPECT_NEAR(limit_of(response, -1.0), 4.0 + 3.0 * std::exp(-3.0),
                    0.05);  // one limit for both directions
    }
}

TEST(LateralResponse, LearnsNothingFromAForceThatStillGrows) {
    rsi_test::LateralResponse response;
    response.init(with_response());
    // 4 + (2 0.7 / 9) 20 = 7.1: the motion is tending to the limit already.
    for (int k = 0; k < 60; ++k) {
        response.update(turning(4.0, 20.0), asking(12.0));
    }
    EXPECT_NEAR(limit_of(response), static_cast<double>(largest_mps2), 1e-3);
}

TEST(LateralResponse, LearnsNothingFromASmallForceNorFromASteeringThatAsksForNoMore) {
    rsi_test::LateralResponse response;
    response.init(with_response());
    for (int k = 0; k < 60; ++k) {
        response.update(turning(1.9), asking(12.0));
        response.update(turning(-4.0), asking(12.0));
        response.update(turning(4.0), asking(3.9));
    }
    EXPECT_NEAR(limit_of(response), static_cast<double>(largest_mps2), 1e-3);
}

TEST(LateralResponse, ForgetsTheLimitInFiveSecondsAlsoWithoutSteering) {
    for (const bool with_steering : {true, false}) {
        rsi_test::LateralResponse response;
        response.init(with_response());
        for (int k = 0; k < 300; ++k) {
            response.update(turning(3.0), asking(12.0));
        }
        ASSERT_NEAR(limit_of(response), 3.0, 0.05);
        for (int k = 0; k < samples_in_5_s; ++k) {
            response.update(turning(0.0), with_steering ? asking(0.0) : rsi::DemandedForce{});
        }
        EXPECT_NEAR(limit_of(response), 7.0 - 4.0 * std::exp(-3.0), 0.05);
    }
}

TEST(LateralResponse, AResetForgetsTheLimitAtOnce) {
    rsi_test::LateralResponse response;
    response.init(with_response());
    for (int k = 0; k < 300; ++k) {
        response.update(turning(3.0), asking(12.0));
    }
    response.reset();
    EXPECT_NEAR(limit_of(response), static_cast<double>(largest_mps2), 1e-3);
}

// Otherwise a vehicle that slides once would not be expected to turn any more.
TEST(LateralResponse, TheLimitStaysAboveTwoMetresPerSecondSquared) {
    rsi_test::LateralResponse response;
    response.init(with_response());
    for (int k = 0; k < 300; ++k) {
        response.update(turning(2.1, -30.0), asking(12.0));
    }
    EXPECT_NEAR(limit_of(response), 2.0, 0.05);
}

}  // namespace
}  // namespace lateral_response_test
