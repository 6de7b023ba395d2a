// Draw: what a run is depends on seed and number alone, and is spread as the settings say.
#include "sil/studies/campaign/draw.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "tests/sil/campaign/small_campaign.hpp"

namespace {

using testing_campaign::small_campaign;
using Take = std::function<double(const sil::RunDraw&)>;

constexpr std::uint64_t many = 20000U;

// Largest distance of the sample's distribution from the uniform one (Kolmogorov and Smirnov).
double distance_from_uniform(std::vector<double> values, const sil::Interval& interval) {
    std::sort(values.begin(), values.end());
    double largest = 0.0;
    for (std::size_t i = 0U; i < values.size(); ++i) {
        const double expected = (values[i] - interval.lowest) / (interval.highest - interval.lowest);
        const double count = static_cast<double>(values.size());
        largest = std::max({largest, std::abs(static_cast<double>(i) / count - expected),
                            std::abs(static_cast<double>(i + 1U) / count - expected)});
    }
    return largest;
}

sil::CampaignSettings with_mass_sensors(sil::CampaignSettings settings) {
    for (sil::CampaignVehicle& vehicle : settings.vehicles) {
        vehicle.mass_sensor = true;
    }
    return settings;
}

void expect_uniform(const char* name, const sil::Interval& interval, const Take& take) {
    const sil::CampaignSettings settings = with_mass_sensors(small_campaign(many));
    std::vector<double> values;
    for (std::uint64_t run = 0U; run < many; ++run) {
        const sil::RunDraw draw = sil::draw_run(settings, run);
        if (draw.manoeuvre == 0U) {
            values.push_back(take(draw));
        }
    }
    EXPECT_GE(*std::min_element(values.begin(), values.end()), interval.lowest) << name;
    EXPECT_LE(*std::max_element(values.begin(), values.end()), interval.highest) << name;
    // A uniform sample exceeds 1.95 / sqrt(n) once in a thousand.
    EXPECT_LT(distance_from_uniform(values, interval), 1.95 / std::sqrt(static_cast<double>(values.size())))
        << name;
}

TEST(Draw, EveryQuantityIsUniformWithinItsBounds) {
    const sil::CampaignSettings settings = small_campaign(many);
    const sil::CampaignSpread& spread = settings.spread;
    expect_uniform("speed", settings.manoeuvres[0].speed_factor,
                   [](const auto& d) { return d.speed_factor; });
    expect_uniform("steering", settings.manoeuvres[0].steering_factor,
                   [](const auto& d) { return d.steering_factor; });
    expect_uniform("friction", spread.friction_factor, [](const auto& d) { return d.friction_factor; });
    expect_uniform("load", spread.load_share, [](const auto& d) { return d.load_share; });
    expect_uniform("load height", spread.load_height_factor,
                   [](const auto& d) { return d.load_height_factor; });
    expect_uniform("CG", {-0.05, 0.05}, [](const auto& d) { return d.cg_height_error; });
    expect_uniform("K", {-0.10, 0.10}, [](const auto& d) { return d.stiffness_error; });
    expect_uniform("mass", {-0.05, 0.05}, [](const auto& d) { return d.mass_error; });
    expect_uniform("mass sensor", {-0.03, 0.03}, [](const auto& d) { return d.mass_sensor_error; });
    expect_uniform("lateral bias", {-0.005, 0.005}, [](const auto& d) { return d.lateral_bias_g; });
    expect_uniform("vertical bias", {-0.005, 0.005}, [](const auto& d) { return d.vertical_bias_g; });
}

TEST(Draw, AMassSensorIsWrongOnlyWhereThereIsOneAndSensorsHaveNoise) {
    sil::CampaignSettings settings = small_campaign(10U);
    settings.vehicles[1].mass_sensor = true;
    for (std::uint64_t run = 0U; run < 10U; ++run) {
        const sil::RunDraw draw = sil::draw_run(settings, run);
        EXPECT_EQ(draw.mass_sensor_error != 0.0, draw.vehicle == 1U);
    }
    settings = with_mass_sensors(settings);
    settings.spread.sensor_noise = false;
    EXPECT_EQ(sil::draw_run(settings, 0U).mass_sensor_error, 0.0);
}

TEST(Draw, AWronglyMountedHousingAndAWrongMassAreUniformAndNeedToBeAskedFor) {
    sil::CampaignSettings settings = with_mass_sensors(small_campaign(many));
    settings.spread.sensor_noise = false;
    const sil::RunDraw right = sil::draw_run(settings, 3U);
    EXPECT_EQ(right.housing_tilt_deg, (std::array<double, 3>{}));
    EXPECT_EQ(right.lever_arm_error_m, (std::array<double, 3>{}));
    EXPECT_EQ(right.mass_sensor_error, 0.0);
    settings.spread.housing_tilt_deg = 2.0;
    settings.spread.lever_arm_error_m = 0.1;
    settings.spread.mass_signal_factor = {0.85, 1.3};
    const sil::CampaignSettings without = small_campaign(many);
    std::array<std::vector<double>, 7> drawn;
    for (std::uint64_t run = 0U; run < many; ++run) {
        const sil::RunDraw draw = sil::draw_run(settings, run);
        for (std::size_t axis = 0U; axis < 3U; ++axis) {
            drawn[axis].push_back(draw.housing_tilt_deg[axis]);
            drawn[3U + axis].push_back(draw.lever_arm_error_m[axis]);
        }
        drawn[6].push_back(draw.mass_sensor_error);
        EXPECT_EQ(draw.cg_height_error, sil::draw_run(without, run).cg_height_error)
            << "what else is drawn stays";
    }
    const double limit = 1.95 / std::sqrt(static_cast<double>(many));
    for (std::size_t axis = 0U; axis < 3U; ++axis) {
        EXPECT_LT(distance_from_uniform(drawn[axis], {-2.0, 2.0}), limit) << axis;
        EXPECT_LT(distance_from_uniform(drawn[3U + axis], {-0.1, 0.1}), limit) << axis;
    }
    EXPECT_LT(distance_from_uniform(drawn[6], {-0.15, 0.3}), limit);
    for (sil::CampaignVehicle& vehicle : settings.vehicles) {
        vehicle.mass_sensor = false;
    }
    EXPECT_EQ(sil::draw_run(settings, 3U).mass_sensor_error, 0.0);
}

TEST(Draw, ManoeuvresComeByTheirWeightsAndVehiclesAndDirectionsAlike) {
    const sil::CampaignSettings settings = small_campaign(many);
    double first_manoeuvre = 0.0;
    double first_vehicle = 0.0;
    double mirrored = 0.0;
    for (std::uint64_t run = 0U; run < many; ++run) {
        const sil::RunDraw draw = sil::draw_run(settings, run);
        first_manoeuvre += draw.manoeuvre == 0U ? 1.0 : 0.0;
        first_vehicle += draw.vehicle == 0U ? 1.0 : 0.0;
        mirrored += draw.mirrored ? 1.0 : 0.0;
    }
    // Four standard deviations of a binomial share.
    EXPECT_NEAR(first_manoeuvre / many, 2.0 / 3.0, 4.0 * std::sqrt(2.0 / 9.0 / many));
    EXPECT_NEAR(first_vehicle / many, 0.5, 4.0 * std::sqrt(0.25 / many));
    EXPECT_NEAR(mirrored / many, 0.5, 4.0 * std::sqrt(0.25 / many));
}

double correlation(const Take& one, const Take& other) {
    const sil::CampaignSettings settings = small_campaign(many);
    double x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
    for (std::uint64_t run = 0U; run < many; ++run) {
        const sil::RunDraw draw = sil::draw_run(settings, run);
        const double a = one(draw);
        const double b = other(draw);
        x += a, y += b, xx += a * a, yy += b * b, xy += a * b;
    }
    const double n = static_cast<double>(many);
    return (n * xy - x * y) / std::sqrt((n * xx - x * x) * (n * yy - y * y));
}

TEST(Draw, QuantitiesAreIndependent) {
    const Take cg = [](const auto& d) { return d.cg_height_error; };
    const double limit = 4.0 / std::sqrt(static_cast<double>(many));
    EXPECT_LT(std::abs(correlation(cg, [](const auto& d) { return d.stiffness_error; })), limit);
    EXPECT_LT(std::abs(correlation(cg, [](const auto& d) { return d.mass_error; })), limit);
    EXPECT_LT(std::abs(correlation(cg, [](const auto& d) { return d.load_share; })), limit);
    EXPECT_LT(std::abs(correlation(cg, [](const auto& d) { return static_cast<double>(d.number); })), limit);
}

TEST(Draw, ASeedAndANumberGiveTheSameRunAgainAndOthersAnother) {
    sil::CampaignSettings settings = small_campaign(10U);
    const sil::RunDraw draw = sil::draw_run(settings, 5U);
    EXPECT_EQ(draw.cg_height_error, sil::draw_run(settings, 5U).cg_height_error);
    EXPECT_EQ(draw.sensor_seed, sil::draw_run(settings, 5U).sensor_seed);
    EXPECT_NE(draw.cg_height_error, sil::draw_run(settings, 6U).cg_height_error);
    settings.runs = 1'000'000U;
    EXPECT_EQ(draw.cg_height_error, sil::draw_run(settings, 5U).cg_height_error);
    settings.seed += 1U;
    EXPECT_NE(draw.cg_height_error, sil::draw_run(settings, 5U).cg_height_error);
}

TEST(Draw, AVehiclesFactorsScaleItsManoeuvresAndNothingElse) {
    const sil::CampaignSettings plain = small_campaign(many);
    sil::CampaignSettings scaled = plain;
    scaled.vehicles[1].speed_factors = {0.5, 2.0};
    scaled.vehicles[1].steering_factors = {3.0, 0.25};
    for (std::uint64_t run = 0U; run < 200U; ++run) {
        const sil::RunDraw before = sil::draw_run(plain, run);
        const sil::RunDraw after = sil::draw_run(scaled, run);
        const bool other = before.vehicle == 1U;
        EXPECT_EQ(after.speed_factor,
                  before.speed_factor * (other ? (before.manoeuvre == 0U ? 0.5 : 2.0) : 1.0));
        EXPECT_EQ(after.steering_factor,
                  before.steering_factor * (other ? (before.manoeuvre == 0U ? 3.0 : 0.25) : 1.0));
        EXPECT_EQ(after.friction_factor, before.friction_factor);
        EXPECT_EQ(after.sensor_seed, before.sensor_seed);
    }
}

TEST(Draw, NoTwoRunsShareASensorSeed) {
    const sil::CampaignSettings settings = small_campaign(many);
    std::set<std::uint64_t> seeds;
    for (std::uint64_t run = 0U; run < many; ++run) {
        seeds.insert(sil::draw_run(settings, run).sensor_seed);
    }
    EXPECT_EQ(seeds.size(), many);
}

}  // namespace
