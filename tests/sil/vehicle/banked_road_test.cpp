// Banked roads: geometry, signs, and what a resting vehicle feels on them.
#include <gtest/gtest.h>
#include <cmath>

#include "scenario.hpp"
#include "tests/support/nominal_roll_model.hpp"

namespace {

constexpr double bank = 0.08;

TEST(PlaneRoad, ABankedPlaneRisesToTheLeftAndItsNormalLeansToTheRight) {
    const sil::PlaneRoad road{bank};
    const sil::RoadPoint point = road.at(7.0, 3.0);
    EXPECT_NEAR(point.height_m, 3.0 * std::tan(bank), 1e-12);
    EXPECT_NEAR(point.normal.y(), -std::sin(bank), 1e-12);
    EXPECT_NEAR(point.normal.norm(), 1.0, 1e-12);
}

TEST(BankedCircleRoad, PassesThroughTheOriginAndRisesOutwards) {
    const sil::BankedCircleRoad road{152.4, bank};
    EXPECT_NEAR(road.at(0.0, 0.0).height_m, 0.0, 1e-9);
    EXPECT_NEAR(road.at(0.0, -2.0).height_m, 2.0 * std::tan(bank), 1e-9);
    EXPECT_NEAR(road.at(152.4, 152.4).height_m, 0.0, 1e-9);
}

TEST(BankedCircleRoad, HasTheNormalOfItsOwnSlope) {
    const sil::BankedCircleRoad road{152.4, bank};
    const double step = 1e-4;
    for (const double x : {-40.0, 0.0, 90.0}) {
        for (const double y : {-5.0, 60.0}) {
            const double by_x = (road.at(x + step, y).height_m - road.at(x - step, y).height_m) / (2 * step);
            const double by_y = (road.at(x, y + step).height_m - road.at(x, y - step).height_m) / (2 * step);
            const sil::Vector3 expected = sil::Vector3{-by_x, -by_y, 1.0}.normalized();
            EXPECT_NEAR((road.at(x, y).normal - expected).norm(), 0.0, 1e-7);
        }
    }
}

TEST(BankedRoad, TheLeftSideUpIsAPositiveBankAlongTheHeading) {
    const sil::PlaneRoad plane{bank};
    const sil::Vehicle there{scenario::large_suv(), plane};
    EXPECT_NEAR(there.truth().bank_angle_rad, bank, 1e-9);
    EXPECT_NEAR(there.truth().roll_angle_rad, 0.0, 1e-9);
    EXPECT_NEAR(there.truth().roll_to_horizon_rad, bank, 1e-9);

    sil::Vehicle back{scenario::large_suv(), plane};
    sil::InitialState turned;
    turned.yaw_angle_rad = 3.14159265358979323846;
    back.reset(turned);
    EXPECT_NEAR(back.truth().bank_angle_rad, -bank, 1e-9);

    const sil::BankedCircleRoad circle{152.4, bank};
    const sil::Vehicle on_circle{scenario::large_suv(), circle};
    EXPECT_NEAR(on_circle.truth().bank_angle_rad, -bank, 1e-9) << "outer edge up in a turn to the left";
}

TEST(BankedRoad, ARestingVehicleLeansDownhillAndItsAccelerometerShowsTheSlope) {
    const sil::PlaneRoad road{bank};
    const sil::VehicleParameters parameters = scenario::large_suv();
    sil::Vehicle vehicle{parameters, road};
    for (int step = 0; step < 6000; ++step) {
        vehicle.step({});
    }
    const sil::Truth& truth = vehicle.truth();
    const double lean = truth.roll_to_horizon_rad;
    // Quasi-static roll (1): K_f phi = m_s H (g sin b + g cos b tan phi), bank downhill to the right.
    const rsi_test::NominalRollModel model = rsi_test::nominal_roll_model(parameters.name);
    const double lever = parameters.geometry.cg_height_m - model.roll_centre_height_m;
    const double pull = parameters.mass.sprung_kg * sil::gravity_mps2 * lever;
    EXPECT_NEAR(truth.roll_angle_rad, pull * std::sin(bank) / (model.stiffness_nmprad - pull),
                0.10 * truth.roll_angle_rad);
    EXPECT_NEAR(lean, bank + truth.roll_angle_rad, 2e-3);
    EXPECT_NEAR(truth.specific_force_mps2[1], sil::gravity_mps2 * std::sin(lean), 0.01);
    EXPECT_NEAR(truth.specific_force_mps2[2], sil::gravity_mps2 * std::cos(lean), 0.01);
    EXPECT_NEAR(truth.lateral_acceleration_mps2, 0.0, 0.01);
}

}  // namespace
