// Population campaigns: each vehicle gets manoeuvres as severe for it as for any other, within what its class
// drives.
#include "sil/studies/population/population_campaigns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sil/studies/population/vehicle_writer.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

constexpr std::uint64_t many = 80U;

double nominal_kmh(const std::string& name) {
    return sil::find_manoeuvre(name).initial_speed_mps * 3.6;
}

TEST(PopulationCampaigns, NoVehicleDrivesFasterThanItsClass) {
    for (std::uint64_t number = 0U; number < many; ++number) {
        const sil::DrawnVehicle drawn = sil::draw_vehicle(1U, number);
        const sil::CampaignVehicle scaled = sil::scaled_vehicle(drawn, drawn.parameters);
        const std::vector<sil::CampaignManoeuvre>& manoeuvres = sil::population_manoeuvres();
        ASSERT_EQ(scaled.speed_factors.size(), manoeuvres.size());
        ASSERT_EQ(scaled.steering_factors.size(), manoeuvres.size());
        EXPECT_EQ(scaled.in_class, sil::vehicle_classes()[drawn.in_class].name);
        for (std::size_t i = 0U; i < manoeuvres.size(); ++i) {
            const double fastest = nominal_kmh(manoeuvres[i].name) * scaled.speed_factors[i] *
                                   manoeuvres[i].speed_factor.highest;
            EXPECT_LE(fastest, sil::vehicle_classes()[drawn.in_class].max_speed_kmh + 1e-9)
                << drawn.name << " " << manoeuvres[i].name;
        }
    }
}

TEST(PopulationCampaigns, AJTurnAsksEveryVehicleForTheSameShareOfItsThreshold) {
    const std::vector<sil::CampaignManoeuvre>& manoeuvres = sil::population_manoeuvres();
    ASSERT_EQ(manoeuvres[0].name, "j-turn-110");
    for (std::uint64_t number = 0U; number < many; ++number) {
        const sil::DrawnVehicle drawn = sil::draw_vehicle(1U, number);
        const sil::CampaignVehicle scaled = sil::scaled_vehicle(drawn, drawn.parameters);
        const double speed_mps = 0.8 * scaled.speed_factors[0] * 110.0 / 3.6;
        const double angle_rad = scaled.steering_factors[0] * 360.0 / sil::degrees_per_radian;
        EXPECT_NEAR(
            angle_rad,
            sil::handwheel_for_rad(drawn.parameters, drawn.properties.threshold_g * sil::g_mps2, speed_mps),
            1e-9)
            << drawn.name;
        // Beyond 15 rad the firmware takes the angle for a fault of the sensor.
        EXPECT_LT(angle_rad * manoeuvres[0].steering_factor.highest, 13.0 + 1e-9) << drawn.name;
    }
}

TEST(PopulationCampaigns, HandsTurnAtUpTo1200DegreesASecond) {
    int ramps = 0;
    for (const sil::CampaignManoeuvre& manoeuvre : sil::population_manoeuvres()) {
        if (manoeuvre.handwheel_rate_degps.highest > 0.0) {
            ++ramps;
            EXPECT_TRUE(sil::find_manoeuvre(manoeuvre.name).make_driver_at_rate) << manoeuvre.name;
            EXPECT_EQ(manoeuvre.handwheel_rate_degps.highest, 1200.0) << manoeuvre.name;
        }
    }
    EXPECT_EQ(ramps, 5);
}

TEST(PopulationCampaigns, TippierVehiclesTakeACourseOfConesMoreSlowly) {
    const std::vector<sil::CampaignManoeuvre>& manoeuvres = sil::population_manoeuvres();
    const auto at = std::find_if(manoeuvres.begin(), manoeuvres.end(),
                                 [](const auto& m) { return m.name == "double-lane-change"; });
    ASSERT_NE(at, manoeuvres.end());
    const auto index = static_cast<std::size_t>(at - manoeuvres.begin());
    for (std::uint64_t number = 0U; number < many; ++number) {
        const sil::DrawnVehicle drawn = sil::draw_vehicle(1U, number);
        const double factor = sil::scaled_vehicle(drawn, drawn.parameters).speed_factors[index];
        EXPECT_NEAR(factor, std::sqrt(drawn.properties.threshold_g / 0.75), 1e-9) << drawn.name;
        EXPECT_EQ(sil::scaled_vehicle(drawn, drawn.parameters).steering_factors[index], 1.0);
    }
}

// Any calibration does.
TEST(PopulationCampaigns, TrucksAndBusesHaveTheirMassOnTheBus) {
    const test_support::ScratchFolder scratch;
    std::vector<sil::DrawnVehicle> vehicles;
    for (std::uint64_t number = 0U; number < 8U; ++number) {
        vehicles.push_back(sil::draw_vehicle(1U, number));
        for (const bool loaded : {false, true}) {
            const std::filesystem::path file = sil::vehicle_file(scratch.path(), vehicles.back(), loaded);
            std::filesystem::create_directories(file.parent_path());
            test_support::write_text(file, sil::vehicle_toml(vehicles.back().parameters, ""));
        }
        for (const sil::CalibrationKind kind :
             {sil::CalibrationKind::with_loads, sil::CalibrationKind::without_loads,
              sil::CalibrationKind::of_loaded_vehicle}) {
            const std::filesystem::path file = sil::calibration_file(scratch.path(), vehicles.back(), kind);
            std::filesystem::create_directories(file.parent_path());
            test_support::write_text(file, "");
        }
    }
    for (const sil::CampaignVariant variant : sil::campaign_variants()) {
        const sil::CampaignSettings settings =
            sil::population_campaign(scratch.path(), vehicles, variant, 1U);
        ASSERT_EQ(settings.vehicles.size(), 8U);
        for (const sil::CampaignVehicle& vehicle : settings.vehicles) {
            EXPECT_EQ(vehicle.mass_sensor, vehicle.in_class == "light truck" ||
                                               vehicle.in_class == "heavy truck" || vehicle.in_class == "bus")
                << vehicle.in_class;
        }
    }
}

std::vector<std::string> names_of(const std::vector<sil::CampaignManoeuvre>& manoeuvres) {
    std::vector<std::string> names;
    for (const sil::CampaignManoeuvre& manoeuvre : manoeuvres) {
        names.push_back(manoeuvre.name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

TEST(PopulationCampaigns, ManoeuvresAreThoseOfTheCampaignAndRoadsAndEvents) {
    std::vector<std::string> wanted = names_of(sil::default_campaign().manoeuvres);
    wanted.insert(wanted.end(), {"decreasing-radius", "crowned-road", "split-friction", "gust",
                                 "tyre-failure", "sloshing-load", "sliding-load", "trailer"});
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(names_of(sil::population_manoeuvres()), wanted);
}

TEST(PopulationCampaigns, TrippingHasACampaignOfItsOwn) {
    const std::vector<std::string> wanted{"kerb-trip", "soil-trip"};
    EXPECT_EQ(names_of(sil::population_manoeuvres(sil::ManoeuvreMixture::tripping)), wanted);
    const sil::DrawnVehicle drawn = sil::draw_vehicle(1U, 0U);
    const sil::CampaignVehicle scaled =
        sil::scaled_vehicle(drawn, drawn.parameters, sil::ManoeuvreMixture::tripping);
    EXPECT_EQ(scaled.speed_factors.size(), wanted.size());
    EXPECT_EQ(scaled.steering_factors.size(), wanted.size());
}

}  // namespace
