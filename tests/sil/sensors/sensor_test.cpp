// Sensors: lever arm against rigid-body kinematics, decimation, and the errors that the options ask for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sil/world/sensors/sensor_suite.hpp"

namespace sensor_test {
namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;  // rows

constexpr double g_mps2 = 9.80665;
constexpr double pi = 3.14159265358979323846;
constexpr double rad_per_deg = pi / 180.0;

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix result{};
    for (std::size_t row = 0U; row < 3U; ++row) {
        for (std::size_t column = 0U; column < 3U; ++column) {
            for (std::size_t k = 0U; k < 3U; ++k) {
                result[row][column] += a[row][k] * b[k][column];
            }
        }
    }
    return result;
}

Matrix transposed(const Matrix& a) {
    Matrix result{};
    for (std::size_t row = 0U; row < 3U; ++row) {
        for (std::size_t column = 0U; column < 3U; ++column) {
            result[column][row] = a[row][column];
        }
    }
    return result;
}

Vector product(const Matrix& a, const Vector& v) {
    Vector result{};
    for (std::size_t row = 0U; row < 3U; ++row) {
        result[row] = a[row][0] * v[0] + a[row][1] * v[1] + a[row][2] * v[2];
    }
    return result;
}

// A body that yaws, pitches and rolls at once while its CG runs along a curve: everything else is derived
// from these two functions of time by numerical differentiation.
Matrix attitude(double t) {
    const double yaw = 0.3 + 0.8 * t + 0.2 * std::sin(2.0 * t);
    const double pitch = 0.1 * std::sin(3.0 * t);
    const double roll = 0.4 * std::sin(5.0 * t) + 0.2 * t;
    const Matrix z{
        {{std::cos(yaw), -std::sin(yaw), 0.0}, {std::sin(yaw), std::cos(yaw), 0.0}, {0.0, 0.0, 1.0}}};
    const Matrix y{
        {{std::cos(pitch), 0.0, std::sin(pitch)}, {0.0, 1.0, 0.0}, {-std::sin(pitch), 0.0, std::cos(pitch)}}};
    const Matrix x{
        {{1.0, 0.0, 0.0}, {0.0, std::cos(roll), -std::sin(roll)}, {0.0, std::sin(roll), std::cos(roll)}}};
    return product(z, product(y, x));
}

Vector centre_of_gravity(double t) {
    return {20.0 * t + 0.5 * t * t, 3.0 * std::sin(1.5 * t), 0.1 * std::cos(4.0 * t)};
}

Vector point(double t, const Vector& r) {
    const Vector offset = product(attitude(t), r);
    const Vector c = centre_of_gravity(t);
    return {c[0] + offset[0], c[1] + offset[1], c[2] + offset[2]};
}

// Specific force of the body's point r in body axes: its acceleration in space plus g upwards.
Vector specific_force(double t, const Vector& r) {
    constexpr double step = 1e-4;
    const Vector before = point(t - step, r);
    const Vector now = point(t, r);
    const Vector after = point(t + step, r);
    Vector force{};
    for (std::size_t axis = 0U; axis < 3U; ++axis) {
        force[axis] = (after[axis] - 2.0 * now[axis] + before[axis]) / (step * step);
    }
    force[2] += g_mps2;
    return product(transposed(attitude(t)), force);
}

// Body components from R^T R', which is the cross-product matrix of omega.
Vector angular_velocity(double t) {
    constexpr double step = 1e-5;
    const Matrix before = attitude(t - step);
    const Matrix after = attitude(t + step);
    Matrix rate{};
    for (std::size_t row = 0U; row < 3U; ++row) {
        for (std::size_t column = 0U; column < 3U; ++column) {
            rate[row][column] = (after[row][column] - before[row][column]) / (2.0 * step);
        }
    }
    const Matrix spin = product(transposed(attitude(t)), rate);
    return {spin[2][1], spin[0][2], spin[1][0]};
}

sil::Truth truth_of_moving_body(double t) {
    constexpr double step = 1e-4;
    sil::Truth truth;
    truth.time_s = t;
    truth.specific_force_mps2 = specific_force(t, {0.0, 0.0, 0.0});
    truth.angular_velocity_radps = angular_velocity(t);
    const Vector before = angular_velocity(t - step);
    const Vector after = angular_velocity(t + step);
    for (std::size_t axis = 0U; axis < 3U; ++axis) {
        truth.angular_acceleration_radps2[axis] = (after[axis] - before[axis]) / (2.0 * step);
    }
    return truth;
}

TEST(SpecificForceAt, IsThatOfThePointsOwnMotionInSpace) {
    const Vector r{0.7, -0.4, 0.5};
    for (double t = 0.0; t < 3.0; t += 0.137) {
        const Vector expected = specific_force(t, r);
        const Vector found = sil::specific_force_at(truth_of_moving_body(t), {r[0], r[1], r[2]});
        for (std::size_t axis = 0U; axis < 3U; ++axis) {
            EXPECT_NEAR(found[axis], expected[axis], 1e-4) << "axis " << axis << " at " << t << " s";
        }
    }
}

TEST(SpecificForceAt, SpinningAboutTheVerticalPullsTowardsTheAxis) {
    sil::Truth truth;
    truth.angular_velocity_radps = {0.0, 0.0, 2.0};
    const Vector force = sil::specific_force_at(truth, {0.5, 0.0, 0.3});
    EXPECT_DOUBLE_EQ(force[0], -2.0);  // omega^2 r = 4 * 0.5
    EXPECT_DOUBLE_EQ(force[1], 0.0);
    EXPECT_DOUBLE_EQ(force[2], 0.0);
}

TEST(SpecificForceAt, RollAccelerationMovesTheTopToTheRight) {
    sil::Truth truth;
    truth.angular_acceleration_radps2 = {3.0, 0.0, 0.0};
    EXPECT_DOUBLE_EQ(sil::specific_force_at(truth, {0.0, 0.0, 0.5})[1], -1.5);
    EXPECT_DOUBLE_EQ(sil::specific_force_at(truth, {0.0, 0.4, 0.0})[2], 1.2);
}

TEST(Imu, AtTheCentreOfGravityReportsWhatTheBodyFeels) {
    sil::Truth truth;
    truth.specific_force_mps2 = {1.0, 2.0, g_mps2};
    truth.angular_velocity_radps = {0.1, 0.2, 0.3};
    sil::Imu imu({}, 1U);
    imu.observe(truth);
    sil::SensorSample sample;
    imu.report(sample);
    EXPECT_EQ(sample.lateral_acceleration_mps2, 2.0);
    EXPECT_EQ(sample.vertical_acceleration_mps2, g_mps2);
    EXPECT_EQ(sample.roll_rate_radps, 0.1);
}

TEST(Imu, ReportsTheMeanOfTheTruthsSinceItsLastReport) {
    sil::Imu imu({}, 1U);
    sil::SensorSample sample;
    sil::Truth truth;
    for (int report = 0; report < 3; ++report) {
        for (int step = 0; step < 10; ++step) {
            const double time_ms = report * 10 + step;
            truth.specific_force_mps2 = {0.0, time_ms, -2.0 * time_ms};
            truth.angular_velocity_radps[0] = 4.0 * time_ms;
            imu.observe(truth);
        }
        imu.report(sample);
        const double mean_ms = report * 10 + 4.5;
        EXPECT_DOUBLE_EQ(sample.lateral_acceleration_mps2, mean_ms);
        EXPECT_DOUBLE_EQ(sample.vertical_acceleration_mps2, -2.0 * mean_ms);
        EXPECT_DOUBLE_EQ(sample.roll_rate_radps, 4.0 * mean_ms);
    }
}

TEST(Imu, WithoutAFilterReportsTheLatestTruth) {
    sil::ImuOptions options;
    options.averaged = false;
    sil::Imu imu(options, 1U);
    sil::Truth truth;
    for (const double force : {4.0, 5.0, 9.0}) {
        truth.specific_force_mps2 = {0.0, force, 2.0 * force};
        imu.observe(truth);
    }
    sil::SensorSample sample;
    imu.report(sample);
    EXPECT_EQ(sample.lateral_acceleration_mps2, 9.0);
    EXPECT_EQ(sample.vertical_acceleration_mps2, 18.0);
    imu.report(sample);
    EXPECT_TRUE(std::isnan(sample.lateral_acceleration_mps2));
}

TEST(Imu, WithNothingObservedIsNotAvailable) {
    sil::Imu imu(sil::noisy_sensors(1U).imu, 1U);
    sil::SensorSample sample;
    sample.lateral_acceleration_mps2 = 1.0;
    imu.report(sample);
    EXPECT_TRUE(std::isnan(sample.lateral_acceleration_mps2));
    EXPECT_TRUE(std::isnan(sample.vertical_acceleration_mps2));
    EXPECT_TRUE(std::isnan(sample.roll_rate_radps));
}

TEST(Imu, MountedOffTheCentreTakesItsPlaceIntoAccount) {
    sil::ImuOptions options;
    options.position = {0.5, 0.0, 0.25};
    sil::Imu imu(options, 1U);
    sil::Truth truth;
    truth.angular_acceleration_radps2 = {2.0, 0.0, 1.0};
    imu.observe(truth);
    sil::SensorSample sample;
    imu.report(sample);
    EXPECT_DOUBLE_EQ(sample.lateral_acceleration_mps2, 1.0 * 0.5 - 2.0 * 0.25);
}

TEST(Imu, InATurnedHousingMeasuresAlongItsOwnAxes) {
    sil::Truth truth;
    truth.specific_force_mps2 = {1.0, 4.0, 9.0};
    truth.angular_velocity_radps = {0.3, 0.2, 0.7};
    const auto sample_of = [&truth](const sil::MountingTilt& tilt) {
        sil::ImuOptions options;
        options.tilt = tilt;
        sil::Imu imu(options, 1U);
        imu.observe(truth);
        sil::SensorSample sample;
        imu.report(sample);
        return sample;
    };
    const double angle = 0.05;
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    const sil::SensorSample rolled = sample_of({angle, 0.0, 0.0});
    EXPECT_NEAR(rolled.lateral_acceleration_mps2, 4.0 * cosine + 9.0 * sine, 1e-12);
    EXPECT_NEAR(rolled.vertical_acceleration_mps2, 9.0 * cosine - 4.0 * sine, 1e-12);
    EXPECT_NEAR(rolled.roll_rate_radps, 0.3, 1e-12);
    const sil::SensorSample pitched = sample_of({0.0, angle, 0.0});
    EXPECT_NEAR(pitched.lateral_acceleration_mps2, 4.0, 1e-12);
    EXPECT_NEAR(pitched.vertical_acceleration_mps2, 9.0 * cosine + 1.0 * sine, 1e-12);
    EXPECT_NEAR(pitched.roll_rate_radps, 0.3 * cosine - 0.7 * sine, 1e-12);
    const sil::SensorSample yawed = sample_of({0.0, 0.0, angle});
    EXPECT_NEAR(yawed.lateral_acceleration_mps2, 4.0 * cosine - 1.0 * sine, 1e-12);
    EXPECT_NEAR(yawed.vertical_acceleration_mps2, 9.0, 1e-12);
    EXPECT_NEAR(yawed.roll_rate_radps, 0.3 * cosine + 0.2 * sine, 1e-12);
    // All three turns together: two components are no more than the whole.
    const sil::SensorSample turned = sample_of({0.3, -0.4, 0.5});
    EXPECT_LT(turned.lateral_acceleration_mps2 * turned.lateral_acceleration_mps2 +
                  turned.vertical_acceleration_mps2 * turned.vertical_acceleration_mps2,
              1.0 + 16.0 + 81.0);
}

sil::Truth some_truth() {
    sil::Truth truth;
    truth.time_s = 12.5;
    truth.mass_kg = 7500.0;
    truth.specific_force_mps2 = {0.0, 3.0, 9.0};
    truth.angular_velocity_radps = {0.11, 0.22, 0.33};
    truth.roll_angle_rad = 0.05;
    truth.roll_to_horizon_rad = 0.07;
    truth.bank_angle_rad = 0.02;
    truth.speed_mps = 25.0;
    truth.steering_wheel_angle_rad = -1.5;
    return truth;
}

TEST(SensorSuite, IdealSensorsTellTheTruth) {
    sil::SensorSuite sensors(sil::SensorOptions{});
    sensors.observe(some_truth());
    const sil::SensorSample sample = sensors.report(some_truth());
    EXPECT_EQ(sample.time_s, 12.5);
    EXPECT_EQ(sample.lateral_acceleration_mps2, 3.0);
    EXPECT_EQ(sample.vertical_acceleration_mps2, 9.0);
    EXPECT_EQ(sample.roll_rate_radps, 0.11);
    EXPECT_EQ(sample.roll_angle_rad, 0.05);
    EXPECT_TRUE(std::isnan(sample.bank_angle_rad));
    EXPECT_EQ(sample.speed_mps, 25.0);
    EXPECT_EQ(sample.yaw_rate_radps, 0.33);
    EXPECT_EQ(sample.steering_wheel_angle_rad, -1.5);
    EXPECT_TRUE(std::isnan(sample.vehicle_mass_kg));
}

TEST(SensorSuite, ReportsTheBankWhereTheCarCanMeasureIt) {
    sil::SensorOptions options;
    options.roll.reports_bank = true;
    sil::SensorSuite sensors(options);
    EXPECT_EQ(sensors.report(some_truth()).bank_angle_rad, 0.02);
}

TEST(SensorSuite, AnAttitudeSensorMeasuresAgainstTheHorizon) {
    sil::SensorOptions options;
    options.roll.reference = sil::RollReference::horizon;
    sil::SensorSuite sensors(options);
    EXPECT_EQ(sensors.report(some_truth()).roll_angle_rad, 0.07);
}

TEST(SensorSuite, AMassSensorTellsTheMassOrWhatItsScaleMakesOfIt) {
    sil::SensorOptions options;
    options.mass.fitted = true;
    EXPECT_EQ(sil::SensorSuite(options).report(some_truth()).vehicle_mass_kg, 7500.0);
    options.mass.scale_error = -0.02;
    sil::SensorSuite sensors(options);
    EXPECT_DOUBLE_EQ(sensors.report(some_truth()).vehicle_mass_kg, 7350.0);
    EXPECT_DOUBLE_EQ(sensors.report(some_truth()).vehicle_mass_kg, 7350.0);
}

TEST(SensorSuite, AddsTheBiasAndRoundsToTheStep) {
    sil::SensorOptions options;
    options.roll.roll_angle_rad = {0.0, 0.013, 0.01};
    options.motion.speed_mps = {0.0, -0.5, 0.0};
    sil::SensorSuite sensors(options);
    const sil::SensorSample sample = sensors.report(some_truth());
    EXPECT_DOUBLE_EQ(sample.roll_angle_rad, 0.06);  // 0.063 in steps of 0.01
    EXPECT_DOUBLE_EQ(sample.speed_mps, 24.5);
    sil::Truth truth = some_truth();
    truth.roll_angle_rad = 0.054;
    EXPECT_DOUBLE_EQ(sensors.report(truth).roll_angle_rad, 0.07);  // 0.067: to the nearest, not down
    truth.roll_angle_rad = -0.08;
    EXPECT_DOUBLE_EQ(sensors.report(truth).roll_angle_rad, -0.07);  // -0.067
}

// The speed of each report where the true one is 1, 2, 3, ... m/s.
std::vector<double> reported_speeds(const sil::ChannelOptions& options, int reports) {
    sil::SensorOptions all;
    all.motion.speed_mps = options;
    sil::SensorSuite sensors(all);
    std::vector<double> speeds;
    sil::Truth truth;
    for (int report = 1; report <= reports; ++report) {
        truth.speed_mps = report;
        speeds.push_back(sensors.report(truth).speed_mps);
    }
    return speeds;
}

TEST(SensorSuite, ALateSensorTellsWhatWas) {
    sil::ChannelOptions late;
    late.reports_late = 2U;
    EXPECT_EQ(reported_speeds(late, 6), (std::vector<double>{1.0, 1.0, 1.0, 2.0, 3.0, 4.0}));
}

TEST(SensorSuite, ASlowSensorRepeatsItsValue) {
    sil::ChannelOptions slow;
    slow.reports_a_value = 2U;
    EXPECT_EQ(reported_speeds(slow, 6), (std::vector<double>{1.0, 1.0, 3.0, 3.0, 5.0, 5.0}));
    slow.reports_late = 1U;
    EXPECT_EQ(reported_speeds(slow, 6), (std::vector<double>{1.0, 1.0, 2.0, 2.0, 4.0, 4.0}));
}

TEST(SensorSuite, SpeedFromWheelSpeedsNeverGetsNegative) {
    sil::SensorOptions options;
    options.motion.speed_mps = {0.0, -1.0, 0.0};
    sil::SensorSuite sensors(options);
    EXPECT_EQ(sensors.report(sil::Truth{}).speed_mps, 0.0);
}

// Mean and standard deviation of one quantity over many reports of a constant truth.
struct Statistics {
    double mean{0.0};
    double deviation{0.0};
};

Statistics statistics_of(const sil::SensorOptions& options, double sil::SensorSample::* quantity) {
    constexpr int count = 20'000;
    sil::SensorSuite sensors(options);
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (int report = 0; report < count; ++report) {
        sensors.observe(some_truth());
        const double value = sensors.report(some_truth()).*quantity;
        sum += value;
        sum_of_squares += value * value;
    }
    const double mean = sum / count;
    return {mean, std::sqrt(sum_of_squares / count - mean * mean)};
}

TEST(NoisySensors, HaveTheNoiseThatThePresetNames) {
    sil::SensorOptions options = sil::noisy_sensors(11U);
    options.roll.reports_bank = true;
    const struct {
        double sil::SensorSample::* quantity;
        double truth;
        double noise_rms;
    } channels[] = {
        {&sil::SensorSample::lateral_acceleration_mps2, 3.0, 0.02 * g_mps2},
        {&sil::SensorSample::vertical_acceleration_mps2, 9.0, 0.02 * g_mps2},
        {&sil::SensorSample::roll_rate_radps, 0.11, 0.3 * rad_per_deg},
        {&sil::SensorSample::roll_angle_rad, 0.05, 0.2 * rad_per_deg},
        {&sil::SensorSample::bank_angle_rad, 0.02, 0.2 * rad_per_deg},
        {&sil::SensorSample::speed_mps, 25.0, 0.1 / 3.6},
        {&sil::SensorSample::yaw_rate_radps, 0.33, 0.3 * rad_per_deg},
        {&sil::SensorSample::steering_wheel_angle_rad, -1.5, 0.1 * rad_per_deg},
    };
    for (const auto& channel : channels) {
        const Statistics statistics = statistics_of(options, channel.quantity);
        EXPECT_NEAR(statistics.mean, channel.truth, 5.0 * channel.noise_rms / std::sqrt(20'000.0));
        EXPECT_NEAR(statistics.deviation / channel.noise_rms, 1.0, 0.03);
    }
}

TEST(NoisySensors, HaveTheBiasLevelsOfThePreset) {
    const auto mean_of = [](sil::AccelerometerBias bias) {
        return statistics_of(sil::noisy_sensors(3U, bias), &sil::SensorSample::lateral_acceleration_mps2)
            .mean;
    };
    const double without = mean_of(sil::AccelerometerBias::none);
    EXPECT_NEAR(mean_of(sil::AccelerometerBias::after_zeroing) - without, 0.005 * g_mps2, 1e-9);
    EXPECT_NEAR(mean_of(sil::AccelerometerBias::raw) - without, 0.03 * g_mps2, 1e-9);
}

TEST(NoisySensors, AMassSensorIsWrongByAShareThatTheSeedDecides) {
    EXPECT_FALSE(sil::noisy_sensors(1U).mass.fitted);
    constexpr std::uint64_t seeds = 1000U;
    double sum = 0.0;
    double largest = 0.0;
    for (std::uint64_t seed = 0U; seed < seeds; ++seed) {
        const double error = sil::noisy_sensors(seed).mass.scale_error;
        EXPECT_EQ(error, sil::noisy_sensors(seed).mass.scale_error);
        sum += error;
        largest = std::max(largest, std::abs(error));
    }
    EXPECT_LE(largest, 0.03);
    EXPECT_GT(largest, 0.0295);
    // Five standard deviations of the mean of a uniform share.
    EXPECT_NEAR(sum / seeds, 0.0, 5.0 * 0.03 / std::sqrt(3.0 * seeds));
}

TEST(NoisySensors, TheSameSeedRepeatsEveryBitAndAnotherSeedDoesNot) {
    const auto series = [](std::uint64_t seed) {
        sil::SensorSuite sensors(sil::noisy_sensors(seed));
        std::array<double, 50> values{};
        for (double& value : values) {
            sensors.observe(some_truth());
            value = sensors.report(some_truth()).lateral_acceleration_mps2;
        }
        return values;
    };
    EXPECT_EQ(series(5U), series(5U));
    EXPECT_NE(series(5U), series(6U));
}

TEST(NoisySensors, OneSensorsNoiseDoesNotDependOnTheOthers) {
    sil::SensorOptions alone;
    alone.seed = 21U;
    alone.roll.roll_angle_rad = sil::noisy_sensors(21U).roll.roll_angle_rad;
    sil::SensorSuite one(alone);
    sil::SensorSuite all(sil::noisy_sensors(21U));
    for (int report = 0; report < 20; ++report) {
        one.observe(some_truth());
        all.observe(some_truth());
        EXPECT_EQ(one.report(some_truth()).roll_angle_rad, all.report(some_truth()).roll_angle_rad);
    }
}

}  // namespace
}  // namespace sensor_test
