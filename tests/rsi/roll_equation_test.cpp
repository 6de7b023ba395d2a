// The filtered roll equation on a vehicle that obeys it.
#include "rsi/estimation/roll_equation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/rsi/support/inertial_roll_vehicle.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace roll_equation_test {
namespace {

using rsi_test::InertialRollVehicle;

double wide(float value) {
    return static_cast<double>(value);
}

// Three sines up to 1.5 Hz.
double lively_mps2(double time_s) {
    return 4.0 * std::sin(1.3 * time_s) + 1.5 * std::sin(4.1 * time_s) + 0.5 * std::sin(9.4 * time_s);
}

// The rest is the force times the movement, whatever the manoeuvre.
TEST(RollEquation, LeavesTheForceTimesTheMovement) {
    for (const double movement_m : {0.0, -0.05, 0.08}) {
        rsi_test::FilteredRollEquation filtered{rsi_test::large_suv()};

        InertialRollVehicle vehicle(rsi_test::large_suv(), {movement_m});
        double largest_nm = 0.0;
        for (int k = 0; k < 3000; ++k) {
            const rsi::RollEquation equation = filtered.update(vehicle.drive(lively_mps2(0.01 * k)));
            if (equation.settled) {
                // Sampling moves the mean of two samples against the integral by (T omega)^2 / 12: 1e-3 of 4
                // kN m.
                ASSERT_NEAR(wide(equation.residual_nm), wide(equation.lateral_force_n) * movement_m, 5.0);
                largest_nm = std::fmax(largest_nm, std::fabs(wide(equation.lateral_force_n) * 0.05));
            }
        }
        EXPECT_GT(largest_nm, 300.0);
    }
}

// The roll acceleration is that of the vehicle, two lags late.
TEST(RollEquation, TakesTheRollAccelerationFromTheFilteredRate) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_test::FilteredRollEquation filtered{parameters};

    InertialRollVehicle vehicle(parameters, {});
    const double keep = std::exp(-0.01 / wide(parameters.estimator_filter_lag_s));
    double first = 0.0, second = 0.0, before = 0.0;
    for (int k = 0; k < 1000; ++k) {
        const rsi::RollEquation equation = filtered.update(vehicle.drive(lively_mps2(0.01 * k)));
        const double now = vehicle.acceleration_radps2();
        first = keep * first + (1.0 - keep) * 0.5 * (now + before);  // the mean over the sample
        second = keep * second + (1.0 - keep) * first;
        before = now;
        if (equation.settled) {
            ASSERT_NEAR(wide(equation.roll_acceleration_radps2), second, 0.02);
        }
    }
}

TEST(RollEquation, IsSettledOnceItsLagsHaveForgottenTheirStart) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_test::FilteredRollEquation filtered{parameters};

    InertialRollVehicle vehicle(parameters, {});
    int samples = 0;
    while (!filtered.update(vehicle.drive(0.0)).settled) {
        ASSERT_LT(++samples, 100);
    }
    EXPECT_GE(0.01 * samples, 8.0 * wide(parameters.estimator_filter_lag_s));
    filtered.reset();
    EXPECT_FALSE(filtered.update(vehicle.drive(0.0)).settled);
}

}  // namespace
}  // namespace roll_equation_test
