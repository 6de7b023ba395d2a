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
#include "sil/world/vehicle/load.hpp"
#include "sil/world/vehicle/trip_road.hpp"
#include "sil/world/vehicle/vehicle_batch.hpp"

namespace disturbance_test {
namespace {

const std::vector<std::string> disturbed_names{"split-friction", "gust",    "tyre-failure", "sloshing-load",
                                               "sliding-load",   "trailer", "kerb-trip",    "soil-trip"};

void drive(sil::Vehicle& vehicle, double until_s, const sil::DriverInput& input = {}) {
    while (vehicle.truth().time_s < until_s - 1e-9) {
        vehicle.step(input);
    }
}

double share_on_the_right(const sil::Truth& truth) {
    const auto& load = truth.wheel_load_n;
    const double right = load[sil::front_right] + load[sil::rear_right];
    return right / (right + load[sil::front_left] + load[sil::rear_left]);
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

sil::VehicleParameters carrying(double mass_kg) {
    sil::VehicleParameters vehicle = sil::with_load(scenario::large_suv(), mass_kg, 1.2);
    vehicle.moving_load.mass_kg = mass_kg;
    vehicle.moving_load.above_cg_m = 1.2 - vehicle.geometry.cg_height_m;
    vehicle.moving_load.travel_m = 0.5;
    return vehicle;
}

TEST(MovingLoad, OnASpringComesToRestWhereABankPullsIt) {
    constexpr double bank_rad = 0.05;
    const sil::PlaneRoad road{bank_rad};
    sil::VehicleParameters parameters = carrying(300.0);
    parameters.moving_load.frequency_radps = 6.0;
    parameters.moving_load.damping_ratio = 0.3;
    sil::Vehicle vehicle{parameters, road};
    drive(vehicle, 8.0);
    // The body leans on top of the bank, and the right side is down.
    const double to_horizon = vehicle.truth().roll_to_horizon_rad;
    EXPECT_NEAR(vehicle.state().load_offset_m, -sil::gravity_mps2 * std::sin(to_horizon) / 36.0, 2e-4);
    EXPECT_LT(vehicle.state().load_offset_m, -0.01);
}

TEST(MovingLoad, StaysUntilItsFrictionIsOvercomeAndThenSlidesToTheWall) {
    sil::VehicleParameters parameters = carrying(300.0);
    parameters.moving_load.friction = 0.3;
    parameters.moving_load.travel_m = 0.2;
    const sil::PlaneRoad gentle{0.12};
    const sil::PlaneRoad steep{0.4};
    sil::Vehicle held{parameters, gentle};
    sil::Vehicle loose{parameters, steep};
    drive(held, 4.0);
    drive(loose, 4.0);
    EXPECT_LT(std::abs(held.state().load_offset_m), 0.01);
    EXPECT_NEAR(loose.state().load_offset_m, -0.2, 0.01);
    sil::VehicleParameters fixed = parameters;
    fixed.moving_load.friction = 10.0;
    sil::Vehicle still{fixed, steep};
    drive(still, 4.0);
    // 300 of some 2,700 kg, moved by 0.2 m: a hundredth of the weight over the track, and the body leans
    // more.
    EXPECT_GT(share_on_the_right(loose.truth()), share_on_the_right(still.truth()) + 0.009);
}

TEST(MovingLoad, SwingsAtItsFrequencyInABodyThatStands) {
    const sil::PlaneRoad road{0.02};
    sil::VehicleParameters parameters = carrying(10.0);  // too little to move the body
    parameters.moving_load.frequency_radps = 4.0;
    parameters.moving_load.damping_ratio = 0.0;
    sil::Vehicle vehicle{parameters, road};
    drive(vehicle, 6.0);
    std::vector<double> turned_s;
    double before = vehicle.state().load_rate_mps;
    while (turned_s.size() < 5U) {
        vehicle.step({});
        const double now = vehicle.state().load_rate_mps;
        if (before < 0.0 && now >= 0.0) {
            turned_s.push_back(vehicle.truth().time_s);
        }
        before = now;
        ASSERT_LT(vehicle.truth().time_s, 30.0);
    }
    EXPECT_NEAR((turned_s[4] - turned_s[0]) / 4.0, 2.0 * 3.14159265358979 / 4.0, 0.02);
}

// The body loses the momentum that the load gains: without grip nothing else takes it.
TEST(MovingLoad, LeavesTheMomentumOfTheWholeAsItWas) {
    const sil::PlaneRoad no_grip{0.0, 0.0};
    sil::VehicleParameters parameters = carrying(600.0);
    parameters.moving_load.frequency_radps = 4.0;
    parameters.moving_load.damping_ratio = 0.1;
    sil::Vehicle vehicle{parameters, no_grip};
    sil::DriverInput wind;
    wind.disturbance.side_force_n = 4000.0;
    double largest_share = 0.0;
    double gust_s = 0.0;
    while (vehicle.truth().time_s < 2.0) {
        if (vehicle.truth().time_s >= 0.25) {
            wind.disturbance.side_force_n = 0.0;
        } else {
            gust_s += 0.001;
        }
        vehicle.step(wind);
        const double of_load = 600.0 * vehicle.state().load_rate_mps;
        largest_share = std::max(largest_share, std::abs(of_load) / (4000.0 * gust_s));
    }
    const double of_all = vehicle.truth().mass_kg * vehicle.truth().lateral_velocity_mps +
                          600.0 * vehicle.state().load_rate_mps;
    EXPECT_NEAR(of_all, 4000.0 * gust_s, 0.06 * 4000.0 * gust_s)
        << "but for the wheels under a body that rolls";
    EXPECT_GT(largest_share, 0.15) << "else nothing is tested";
}

sil::VehicleParameters towing(double mass_kg) {
    sil::VehicleParameters vehicle = scenario::large_suv();
    vehicle.trailer = {mass_kg, 2.0 * mass_kg, vehicle.geometry.rear_axle_to_cg_m + 1.0, 0.45, 3.0, 0.3};
    return vehicle;
}

TEST(Trailer, FollowsOnACircleAsItsGeometryHasIt) {
    const auto turn = [](double time_s) {
        return sil::DriverCommand{sil::ramp_and_hold(time_s, 0.5, 0.5, 1.5)};
    };
    sil::ManoeuvreRun run{towing(200.0), scenario::manoeuvre(15.0, 14.0, turn)};
    while (!run.finished()) {
        run.step();
    }
    const sil::Truth& truth = run.truth();
    const sil::State& state = run.vehicle().state();
    const double yaw_rate = truth.angular_velocity_radps[2];
    ASSERT_GT(yaw_rate, 0.1);
    EXPECT_NEAR(state.trailer.yaw_rate_radps, yaw_rate, 0.02 * yaw_rate);
    // Slowly: axle and hitch on circles about one centre.
    const double hitch_m = 1.0;
    const double radius = truth.speed_mps / yaw_rate;
    const double expected = std::atan(hitch_m / radius) + std::asin(3.3 / std::hypot(radius, hitch_m));
    EXPECT_NEAR(truth.yaw_angle_rad - state.trailer.yaw_rad, expected, 0.1 * expected);
}

TEST(Trailer, IsPushedAsHardAsItPushes) {
    const sil::PlaneRoad no_grip{0.0, 0.0};
    sil::VehicleParameters parameters = towing(1000.0);
    parameters.tyre.friction = 1e-6;
    sil::Vehicle vehicle{parameters, no_grip};
    sil::DriverInput wind;
    wind.disturbance.side_force_n = 3000.0;
    drive(vehicle, 0.5, wind);
    // In the earth's frame, for the vehicle has turned meanwhile.
    const double yaw = vehicle.truth().yaw_angle_rad;
    const double sideways =
        vehicle.truth().speed_mps * std::sin(yaw) + vehicle.truth().lateral_velocity_mps * std::cos(yaw);
    EXPECT_NEAR(vehicle.truth().mass_kg * sideways + 1000.0 * vehicle.state().trailer.y_mps, 1500.0, 60.0);
    EXPECT_GT(std::abs(vehicle.state().trailer.yaw_rate_radps), 0.01);
}

sil::Vehicle sliding(const sil::VehicleParameters& parameters, const sil::Road& road, double sideways_mps) {
    sil::Vehicle vehicle{parameters, road};
    sil::InitialState initial;
    initial.speed_mps = 10.0;
    initial.sideways_mps = sideways_mps;
    vehicle.reset(initial);
    EXPECT_NEAR(vehicle.truth().lateral_velocity_mps, sideways_mps, 1e-9);
    return vehicle;
}

TEST(Kerb, StopsTheWheelsAndTipsWhatComesFastEnough) {
    const sil::KerbRoad road{1.5, 0.15, 0.1};
    const auto slid = [&road](double sideways_mps) {
        sil::Vehicle vehicle = sliding(scenario::large_suv(), road, sideways_mps);
        bool lifted = false;
        double farthest_m = 0.0;
        while (vehicle.truth().time_s < 2.0) {
            vehicle.step({});
            lifted = lifted || sil::right_side_has_lifted(vehicle.truth());
            farthest_m = std::max(farthest_m, vehicle.truth().position_y_m);
        }
        const double at_kerb_m = 1.5 - 0.5 * scenario::large_suv().geometry.track_width_m;
        EXPECT_GT(farthest_m, at_kerb_m - 0.1);
        EXPECT_TRUE(lifted || farthest_m < at_kerb_m + 0.3) << farthest_m;
        return lifted;
    };
    EXPECT_FALSE(slid(1.0));
    EXPECT_TRUE(slid(6.0));
}

TEST(Kerb, LetsAWheelPassThatIsAboveIt) {
    sil::RoadPoint surface;
    surface.beyond_kerb_m = 0.1;
    surface.kerb_height_m = 0.15;
    EXPECT_EQ(sil::kerb_force_n(surface, -0.2, 0.0, 200e3), 0.0);
    EXPECT_LT(sil::kerb_force_n(surface, 0.0, 0.0, 200e3), -30e3) << "to the right";
    surface.beyond_kerb_m = -0.1;
    EXPECT_GT(sil::kerb_force_n(surface, 0.0, 0.0, 200e3), 30e3);
    EXPECT_EQ(sil::kerb_force_n(surface, 0.0, 50.0, 200e3), 0.0) << "a kerb does not pull";
}

TEST(SoftGround, HoldsTheMoreTheFartherAVehicleHasSlidThroughIt) {
    const auto slowed = [](double softness, double until_s) {
        const sil::SoftShoulderRoad road{-50.0, softness, 0.3, 0.3};  // all of it
        sil::Vehicle vehicle = sliding(scenario::ordinary_suv(), road, 4.0);
        drive(vehicle, until_s);
        for (const double ploughed_m : vehicle.state().ploughed_m) {
            EXPECT_EQ(ploughed_m < -0.05, softness > 0.0) << "pushes to the right";
        }
        return 4.0 - vehicle.truth().lateral_velocity_mps;
    };
    const double soon = slowed(1.0, 0.1) - slowed(0.0, 0.1);
    const double later = slowed(1.0, 0.3) - slowed(0.0, 0.3);
    EXPECT_GT(soon, 0.02);
    EXPECT_GT(later, 4.0 * soon) << "in three times the time";
}

TEST(DisturbedManoeuvres, AreTheseAndDrawOtherCoursesFromOtherSeeds) {
    for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
        EXPECT_EQ(manoeuvre.is_disturbed,
                  std::count(disturbed_names.begin(), disturbed_names.end(), manoeuvre.name) == 1)
            << manoeuvre.name;
    }
    EXPECT_EQ(sil::undisturbed_manoeuvres().size() + disturbed_names.size(), sil::all_manoeuvres().size());
    for (const char* name :
         {"crowned-road", "split-friction", "gust", "tyre-failure", "kerb-trip", "soil-trip"}) {
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
