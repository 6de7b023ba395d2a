// Disturbances: wind, slick wheels, flat tyres, loads that move, kerbs and soft ground act as their laws say,
// and in the vehicle they are meant for alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "scenario.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/vehicle_batch.hpp"

namespace disturbance_test {
namespace {

const std::vector<std::string> disturbed_names{"split-friction", "gust", "tyre-failure"};

void drive(sil::Vehicle& vehicle, double until_s, const sil::DriverInput& input = {}) {
    while (vehicle.truth().time_s < until_s - 1e-9) {
        vehicle.step(input);
    }
}

TEST(Wind, PushesTheWholeVehicleAndTurnsIt) {
    const sil::PlaneRoad no_grip{0.0, 0.0};
    sil::Vehicle vehicle{scenario::large_suv(), no_grip};
    sil::DriverInput wind;
    wind.disturbance.side_force_n = 3000.0;
    drive(vehicle, 0.5, wind);
    EXPECT_NEAR(vehicle.truth().lateral_velocity_mps, 0.5 * 3000.0 / vehicle.truth().mass_kg, 0.02);
    EXPECT_NEAR(vehicle.truth().angular_velocity_radps[2], 0.0, 0.02);

    sil::Vehicle turned{scenario::large_suv(), no_grip};
    wind.disturbance.side_force_ahead_m = 1.0;
    drive(turned, 0.5, wind);
    EXPECT_GT(turned.truth().angular_velocity_radps[2], 0.2);

    sil::Vehicle rolled{scenario::large_suv(), no_grip};
    wind.disturbance.side_force_ahead_m = 0.0;
    wind.disturbance.side_force_above_m = 1.0;
    drive(rolled, 0.15, wind);
    EXPECT_LT(rolled.truth().roll_angle_rad, vehicle.truth().roll_angle_rad)
        << "pushed to the left, leans left";
}

TEST(SlickWheels, AreThoseOfASlickRoad) {
    const auto turn = [](double) { return sil::DriverCommand{1.5}; };
    sil::Manoeuvre on_slick_road = scenario::manoeuvre(80.0, 2.0, turn);
    on_slick_road.make_road = [](std::uint64_t) { return std::make_unique<sil::PlaneRoad>(0.0, 0.4); };
    sil::Manoeuvre with_slick_wheels = scenario::manoeuvre(80.0, 2.0, turn);
    with_slick_wheels.draw_disturbances = [](const sil::VehicleParameters&, std::uint64_t) {
        return [](const sil::Truth&) {
            sil::Disturbance disturbance;
            disturbance.grip.fill(0.4);
            return disturbance;
        };
    };
    sil::ManoeuvreRun road{scenario::large_suv(), on_slick_road};
    sil::ManoeuvreRun wheels{scenario::large_suv(), with_slick_wheels};
    while (!road.finished()) {
        road.step();
        wheels.step();
        ASSERT_EQ(road.truth().lateral_acceleration_mps2, wheels.truth().lateral_acceleration_mps2);
    }
    EXPECT_LT(road.truth().lateral_acceleration_mps2, 5.0);
}

TEST(FlatTyre, LetsItsCornerSinkByWhatTheRadiusLoses) {
    const sil::PlaneRoad road;
    const sil::VehicleParameters parameters = scenario::symmetric(scenario::ordinary_suv());
    sil::Vehicle vehicle{parameters, road};
    sil::DriverInput input;
    input.disturbance.lost_air = {0.0, 1.0, 0.0, 1.0};
    drive(vehicle, 6.0, input);
    const double sunk_m = sil::FlatTyre::lost_radius * parameters.geometry.wheel_radius_m;
    EXPECT_NEAR(vehicle.truth().roll_angle_rad, sunk_m / parameters.geometry.track_width_m,
                0.15 * sunk_m / parameters.geometry.track_width_m);
}

TEST(FlatTyre, AtTheOutsideRearThrowsTheTailOutOfATurn) {
    const auto turn = [](double time_s) {
        return sil::DriverCommand{sil::ramp_and_hold(time_s, 0.5, 1.0, 1.0)};
    };
    sil::Manoeuvre whole = scenario::manoeuvre(80.0, 6.0, turn);
    sil::Manoeuvre flat = whole;
    flat.draw_disturbances = [](const sil::VehicleParameters&, std::uint64_t) {
        return [](const sil::Truth& truth) {
            sil::Disturbance disturbance;
            disturbance.lost_air[sil::rear_right] = truth.time_s < 4.0 ? 0.0 : 1.0;
            return disturbance;
        };
    };
    sil::ManoeuvreRun before{scenario::large_suv(), whole};
    sil::ManoeuvreRun after{scenario::large_suv(), flat};
    double most_whole = 0.0;
    double most_flat = 0.0;
    while (!before.finished()) {
        before.step();
        after.step();
        if (before.truth().time_s < 4.0) {
            ASSERT_EQ(before.truth().angular_velocity_radps[2], after.truth().angular_velocity_radps[2]);
        }
        most_whole = std::max(most_whole, before.truth().angular_velocity_radps[2]);
        most_flat = std::max(most_flat, after.truth().angular_velocity_radps[2]);
    }
    EXPECT_GT(most_flat, 1.1 * most_whole);
}

TEST(DisturbedManoeuvres, AreTheseAndDrawOtherCoursesFromOtherSeeds) {
    for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
        EXPECT_EQ(manoeuvre.is_disturbed,
                  std::count(disturbed_names.begin(), disturbed_names.end(), manoeuvre.name) == 1)
            << manoeuvre.name;
    }
    EXPECT_EQ(sil::undisturbed_manoeuvres().size() + disturbed_names.size(), sil::all_manoeuvres().size());
    for (const char* name : {"split-friction", "gust", "tyre-failure"}) {
        const auto end = [name](std::uint64_t seed) {
            sil::RunOptions options;
            options.road_seed = seed;
            sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre(name), options};
            while (!run.finished() && run.truth().time_s < 5.0) {
                run.step();
            }
            return run.truth().position_y_m;
        };
        EXPECT_EQ(end(1U), end(1U)) << name;
        EXPECT_NE(end(1U), end(2U)) << name;
    }
}

// The neighbours of disturbed vehicles go on as alone, and so do these.
TEST(DisturbedManoeuvres, AreTheSameInCompanyAsAlone) {
    std::array<std::unique_ptr<sil::ManoeuvreRun>, sil::lane_count> together;
    std::array<std::unique_ptr<sil::ManoeuvreRun>, sil::lane_count> alone;
    ASSERT_LE(disturbed_names.size(), sil::lane_count);
    sil::VehicleBatch batch;
    for (std::size_t lane = 0U; lane < sil::lane_count; ++lane) {
        sil::RunOptions options;
        options.mirrored = lane % 2U == 1U;
        options.steering_factor = 1.4;
        const std::string name = lane < disturbed_names.size() ? disturbed_names[lane] : "straight";
        together[lane] =
            std::make_unique<sil::ManoeuvreRun>(scenario::large_suv(), sil::find_manoeuvre(name), options);
        alone[lane] = std::make_unique<sil::ManoeuvreRun>(*together[lane]);
        batch.enter(lane, together[lane]->vehicle_to_step());
    }
    std::array<sil::DriverInput, sil::lane_count> inputs{};
    for (int step = 0; step < 5000; ++step) {
        for (std::size_t lane = 0U; lane < sil::lane_count; ++lane) {
            inputs[lane] = together[lane]->next_input();
            alone[lane]->step();
        }
        batch.step(inputs, sil::Vehicle::nominal_step_s, sil::VehicleBatch::TruthWanted::all);
        for (std::size_t lane = 0U; lane < sil::lane_count; ++lane) {
            ASSERT_EQ(std::memcmp(&together[lane]->truth(), &alone[lane]->truth(), sizeof(sil::Truth)), 0)
                << "lane " << lane << " at " << step;
        }
    }
}

}  // namespace
}  // namespace disturbance_test
