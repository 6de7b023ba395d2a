// The linear forecast: a weighted sum of sensor signals and their past.
#include "rsi/prediction/linear_forecast.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "rsi/prediction/forecast_weights.hpp"
#include "tests/rsi/support/nominal.hpp"

namespace linear_forecast_test {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

struct Sample {
    float force_mps2{0.0F};
    float roll_rate_radps{0.0F};
    float roll_angle_rad{0.0F};
    float yaw_rate_radps{0.0F};
    float steering_wheel_angle_rad{0.0F};
    float speed_mps{20.0F};
};

class LinearForecast : public testing::Test {
 protected:
    float update(const Sample& sample) {
        rsi::Inputs inputs{};
        inputs.yaw_rate_radps = sample.yaw_rate_radps;
        inputs.speed_mps = sample.speed_mps;
        inputs.steering_wheel_angle_rad = sample.steering_wheel_angle_rad;
        rsi::Measurement measured;
        measured.road_parallel_force_mps2 = sample.force_mps2;
        measured.lateral_acceleration_mps2 = sample.force_mps2;
        measured.roll_rate_radps = sample.roll_rate_radps;
        measured.roll_angle_rad = sample.roll_angle_rad;
        return forecast_.update(vehicle_, inputs, measured, steering_.evaluate(inputs, measured));
    }

    // The moment that lifts the wheels, from the data sheet.
    double half_weight_nm() const {
        return rsi_test::gravity_mps2 *
               static_cast<double>(parameters_.sprung_mass_kg + parameters_.unsprung_mass_kg) * 0.5 *
               static_cast<double>(parameters_.track_width_m);
    }
    double share_of(double force_mps2) const {
        const double arm_kgm =
            static_cast<double>(parameters_.sprung_mass_kg * parameters_.sprung_cg_height_m +
                                parameters_.unsprung_mass_kg * parameters_.unsprung_cg_height_m);
        return arm_kgm * force_mps2 / half_weight_nm();
    }

    static double weight(std::size_t signal) {
        const std::array<float, 3>& row = rsi::forecast_weights[signal];
        return static_cast<double>(row[0]) + static_cast<double>(row[1]) + static_cast<double>(row[2]);
    }

    rsi_parameters parameters_ = rsi_test::large_suv();
    rsi::Vehicle vehicle_{parameters_};
    rsi::SteeringDemand steering_{parameters_};
    rsi::LinearForecast forecast_;
};

TEST_F(LinearForecast, OfAStateThatLastsIsTheSumOfEachSignalsWeights) {
    Sample turn;
    turn.force_mps2 = 4.0F;
    turn.roll_angle_rad = 0.05F;
    turn.yaw_rate_radps = 0.2F;
    const double rolled = static_cast<double>(parameters_.roll_stiffness_nmprad) * 0.05 / half_weight_nm();
    const double expected = weight(0) * share_of(4.0) + weight(2) * rolled + weight(3) * share_of(0.2 * 20.0);
    EXPECT_NEAR(static_cast<double>(update(turn)), expected, 1.0e-5);
    for (int k = 0; k < 50; ++k) {
        EXPECT_NEAR(static_cast<double>(update(turn)), expected, 1.0e-5) << k;
    }
}

TEST_F(LinearForecast, SeesALeftTurnAsARightOneWithTheOtherSign) {
    rsi::LinearForecast left;
    for (int k = 0; k < 40; ++k) {
        const float x = 0.02F * static_cast<float>(k);
        const Sample sample{9.0F * x, 0.3F * x, 0.1F * x, 0.5F * x, 2.0F * x};
        const float to_the_right = update(sample);
        std::swap(forecast_, left);
        EXPECT_EQ(update({-sample.force_mps2, -sample.roll_rate_radps, -sample.roll_angle_rad,
                          -sample.yaw_rate_radps, -sample.steering_wheel_angle_rad}),
                  -to_the_right);
        std::swap(forecast_, left);
    }
}

TEST_F(LinearForecast, OfGrowingSignalsIsMoreThanOfSteadyOnes) {
    const Sample steady{5.0F, 0.0F, 0.05F, 0.25F};
    const float lasting = update(steady);
    forecast_.reset();
    float growing = 0.0F;
    for (int k = 0; k <= 40; ++k) {
        const float x = static_cast<float>(k) / 40.0F;
        growing = update({5.0F * x, 0.125F, 0.05F * x, 0.25F * x});
    }
    EXPECT_GT(growing, lasting + 0.05F);
}

TEST_F(LinearForecast, TakesTheForceWhereYawRateOrSteeringIsMissing) {
    const Sample whole{4.0F, 0.0F, 0.0F, 0.2F};
    Sample blind = whole;
    blind.yaw_rate_radps = none;
    const float without_yaw = update(blind);
    forecast_.reset();
    EXPECT_NEAR(without_yaw, update(whole), 1.0e-6F);  // 4 m/s^2 are 0.2 rad/s at 20 m/s
    forecast_.reset();
    blind.speed_mps = none;
    blind.steering_wheel_angle_rad = none;
    const float without_any = update(blind);
    EXPECT_NEAR(static_cast<double>(without_any), (weight(0) + weight(3) + weight(4)) * share_of(4.0),
                1.0e-5);
}

TEST_F(LinearForecast, SeesNoStepWhereTheYawRateIsLost) {
    Sample turn{5.0F, 0.0F, 0.05F, 0.3F};
    for (int k = 0; k < 30; ++k) {
        update(turn);
    }
    turn.yaw_rate_radps = none;
    const float at_once = update(turn);
    EXPECT_EQ(forecast_.lagged()(3, 2), forecast_.lagged()(0, 2));
    for (int k = 0; k < 100; ++k) {
        EXPECT_NEAR(update(turn), at_once, 1.0e-3F) << k;
    }
}

TEST_F(LinearForecast, HearsNoMoreOfTheYawRateThanABoundedDifferenceFromTheForce) {
    const float right = update({5.0F, 0.0F, 0.0F, 9.0F / 20.0F});
    forecast_.reset();
    EXPECT_NEAR(update({5.0F, 0.0F, 0.0F, 9.0F}), right, 1.0e-6F);
    forecast_.reset();
    EXPECT_NEAR(static_cast<double>(right - update({5.0F, 0.0F, 0.0F, 0.0F})), weight(3) * share_of(8.0),
                1.0e-5);
}

TEST_F(LinearForecast, IsFiniteAndBoundedAtTheEndsOfTheRanges) {
    for (const float side : {1.0F, -1.0F}) {
        for (const float speed_mps : {0.0F, 150.0F, 1.0e9F}) {
            forecast_.reset();
            const float forecast =
                update({60.0F * side, 10.0F * side, 1.5F * side, 1.0e9F * side, 29.0F * side, speed_mps});
            EXPECT_TRUE(std::fabs(forecast) < 200.0F) << forecast;
        }
    }
}

TEST_F(LinearForecast, AfterAResetKnowsNothingOfThePast) {
    const Sample turn{5.0F, 0.2F, 0.05F, 0.3F, 1.0F};
    const float first = update(turn);
    for (int k = 0; k < 10; ++k) {
        update({-8.0F, -0.5F, -0.1F, -0.5F, -2.0F});
    }
    EXPECT_NE(update(turn), first);
    forecast_.reset();
    EXPECT_EQ(update(turn), first);
}

}  // namespace
}  // namespace linear_forecast_test
