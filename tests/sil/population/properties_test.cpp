// Properties: the formulas agree with what the vehicles do when they are driven.
#include "sil/studies/population/properties.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sil/studies/population/vehicle_draw.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace {

TEST(Properties, OfTheLargeSuvAreThoseOfItsFile) {
    const sil::VehicleParameters suv = sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml");
    const sil::VehicleProperties p = sil::properties(suv);
    // (2060 * 0.988 + 314 * 0.395) / 2374
    EXPECT_NEAR(p.cg_height_m, 0.9096, 1e-4);
    EXPECT_NEAR(p.static_stability_factor, 0.8795, 1e-4);
    // 1.6^2 (35500 / 2 + 10500) + 2 * 0.61^2 * 44500 + 16500
    EXPECT_NEAR(p.roll_stiffness_nmprad, 121937.0, 1.0);
    EXPECT_NEAR(p.roll_arm_m + p.roll_centre_height_m, 0.988, 1e-12);
    // Front 0.15 * 0.8 m, rear 0.395 - 0.0194 + 0.053 m, by the axles' shares of the load.
    EXPECT_NEAR(p.roll_centre_height_m, 0.5186 * 0.12 + 0.4814 * 0.4283, 2e-3);
    EXPECT_GT(p.threshold_g, 0.70);
    EXPECT_LT(p.threshold_g, p.static_stability_factor);
}

struct SlowRamp {
    double handwheel_rad{0.0};  // at 0.2 g
    double acceleration_g{0.0};
    double ltr{0.0};
};

// Until half of the load has gone to one side, in a slow turn to the left.
SlowRamp at_half_transfer(const sil::VehicleParameters& vehicle) {
    sil::ManoeuvreRun run{vehicle, sil::find_manoeuvre("slow-ramp")};
    SlowRamp seen;
    while (!run.finished() && seen.ltr < 0.5) {
        run.step();
        const auto& load = run.truth().wheel_load_n;
        const double left = load[sil::front_left] + load[sil::rear_left];
        const double right = load[sil::front_right] + load[sil::rear_right];
        seen.ltr = (right - left) / (right + left);
        if (seen.acceleration_g < 0.2) {
            seen.handwheel_rad = run.truth().steering_wheel_angle_rad;
        }
        seen.acceleration_g = run.truth().lateral_acceleration_mps2 / sil::g_mps2;
    }
    return seen;
}

TEST(Properties, AreThoseOfADrive) {
    for (std::uint64_t number = 0U; number < 8U; ++number) {
        const sil::DrawnVehicle drawn = sil::draw_vehicle(3U, number);
        const SlowRamp ramp = at_half_transfer(drawn.parameters);
        EXPECT_GE(ramp.ltr, 0.5) << drawn.name;
        EXPECT_NEAR(ramp.acceleration_g / 0.5, drawn.properties.threshold_g,
                    0.08 * drawn.properties.threshold_g)
            << drawn.name;
        EXPECT_NEAR(sil::handwheel_for_rad(drawn.parameters, 0.2 * sil::g_mps2, 60.0 / 3.6),
                    ramp.handwheel_rad, 0.12 * ramp.handwheel_rad)
            << drawn.name;
    }
}

}  // namespace
