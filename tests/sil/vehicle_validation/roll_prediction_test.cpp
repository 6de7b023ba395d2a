// Roll prediction: the models alone, against what can be computed by hand.
#include "sil/studies/identification/roll_prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sil/studies/identification/load_fit.hpp"
#include "sil/units.hpp"

namespace {

using sil::RollModel;
using sil::RollSample;

constexpr double step_s = 0.01;

RollModel linear_model() {
    return {1000.0, 700.0, 4000.0, 90000.0, 0.0, 0.0};
}

std::vector<RollSample> constant_force(double parallel_mps2, double duration_s) {
    std::vector<RollSample> samples;
    for (int count = 0; count * step_s <= duration_s; ++count) {
        RollSample sample{};
        sample.time_s = 3.0 + count * step_s;
        sample.parallel_mps2 = parallel_mps2;
        sample.normal_mps2 = sil::g_mps2;
        samples.push_back(sample);
    }
    return samples;
}

TEST(RollPrediction, SettlesWhereTheMomentsBalance) {
    const RollModel model = linear_model();
    const double angle = sil::predicted_roll_angles_rad(model, constant_force(3.0, 5.0)).back();
    EXPECT_NEAR(model.mass_arm_kgm * (3.0 + sil::g_mps2 * std::tan(angle)), model.stiffness_nmprad * angle,
                1e-3);
    EXPECT_GT(angle, 0.03);
}

TEST(RollPrediction, FollowsTheCurve) {
    RollModel model = linear_model();
    model.cubic_nmprad3 = 2.0e6;
    model.quintic_nmprad5 = 5.0e7;
    const double angle = sil::predicted_roll_angles_rad(model, constant_force(-6.0, 5.0)).back();
    const double moment = angle * (90000.0 + angle * angle * (2.0e6 + angle * angle * 5.0e7));
    EXPECT_NEAR(model.mass_arm_kgm * (-6.0 + sil::g_mps2 * std::tan(angle)), moment, 1e-2);
}

// m_s H g is taken off the stiffness: w = sqrt((K - m_s H g) / Ixx) for small angles.
TEST(RollPrediction, SwingsAtItsFrequency) {
    RollModel model = linear_model();
    model.damping_nmsprad = 0.0;
    std::vector<RollSample> samples = constant_force(0.0, 2.0);
    samples.front().roll_angle_rad = 0.01;
    const std::vector<double> angles = sil::predicted_roll_angles_rad(model, samples);
    const double frequency = std::sqrt((90000.0 - 1000.0 * sil::g_mps2) / 700.0);
    for (std::size_t place = 0U; place < angles.size(); ++place) {
        EXPECT_NEAR(angles[place], 0.01 * std::cos(frequency * step_s * static_cast<double>(place)), 3e-4);
    }
}

// Nothing of the measured roll motion but its beginning is used.
TEST(RollPrediction, DoesNotLookAtTheMeasuredAngle) {
    std::vector<RollSample> samples = constant_force(3.0, 1.0);
    const std::vector<double> angles = sil::predicted_roll_angles_rad(linear_model(), samples);
    for (std::size_t place = 1U; place < samples.size(); ++place) {
        samples[place].roll_angle_rad = 0.2;
        samples[place].roll_rate_radps = -1.0;
    }
    EXPECT_EQ(sil::predicted_roll_angles_rad(linear_model(), samples), angles);
}

TEST(RollPrediction, SaysNothingAfterItTipped) {
    RollModel model = linear_model();
    model.stiffness_nmprad = 5000.0;
    const std::vector<double> angles = sil::predicted_roll_angles_rad(model, constant_force(3.0, 5.0));
    EXPECT_FALSE(std::isnan(angles[1]));
    EXPECT_TRUE(std::isnan(angles.back()));
    EXPECT_TRUE(sil::predicted_roll_angles_rad(model, {}).empty());
}

TEST(RollPrediction, HasTheModelOfTheFit) {
    rsi::Parameters parameters{};
    parameters.sprung_mass_kg = 1800.0F;
    parameters.sprung_cg_height_m = 0.75F;
    parameters.fixed_roll_centre_height_m = 0.25F;
    parameters.unsprung_mass_kg = 250.0F;
    parameters.unsprung_cg_height_m = 0.4F;
    parameters.roll_stiffness_nmprad = 90000.0F;
    parameters.roll_damping_nmsprad = 4000.0F;
    parameters.roll_inertia_kgm2 = 700.0F;
    sil::VehicleData vehicle;
    vehicle.sprung_mass_kg = 1800.0;
    vehicle.sprung_cg_height_m = 0.75;
    vehicle.unsprung_mass_kg = 250.0;
    vehicle.unsprung_cg_height_m = 0.4;
    sil::RollFit fit;
    fit.arm_m = 0.5;
    fit.stiffness_nmprad.value = 90000.0;
    fit.damping_nmsprad.value = 4000.0;
    fit.inertia_kgm2.value = 700.0;
    EXPECT_NEAR(sil::roll_model(parameters).mass_arm_kgm, sil::roll_model(vehicle, fit).mass_arm_kgm, 1e-3);
    RollSample sample{};
    sample.parallel_mps2 = 4.0;
    sample.roll_angle_rad = 0.05;
    sample.roll_rate_radps = 0.2;
    EXPECT_NEAR(sil::load_moment_nm(parameters, sample), sil::component_load_moment_nm(vehicle, fit, sample),
                0.1);
}

TEST(Response, SettlesAtWhatTheSteeringAsksFor) {
    const sil::SteeringModel model{2.8, 17.0, 0.002, 8.0, 0.0};
    std::vector<RollSample> samples = constant_force(0.0, 4.0);
    for (RollSample& sample : samples) {
        sample.speed_mps = 20.0;
        sample.steering_wheel_angle_rad = 0.5;
    }
    const std::vector<double> response = sil::response_mps2(model, 8.0, 0.7, samples);
    EXPECT_EQ(response.front(), 0.0);
    EXPECT_NEAR(response.back(), 400.0 * 0.5 / 17.0 / (2.8 + 0.002 * 400.0), 1e-3);
    samples[100].speed_mps = std::nan("");
    const std::vector<double> broken = sil::response_mps2(model, 8.0, 0.7, samples);
    EXPECT_TRUE(std::isnan(broken[100]));
    EXPECT_EQ(broken[101], 0.0);
}

}  // namespace
