// The floor is a floor of the same thing: its least squares and the firmware's go the same way. Prints its
// count, which the table of budgets takes.
#include "tests/targets/budgets/least_squares_floor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rsi/estimation/robust_least_squares.hpp"
#include "rsi/numeric/bounded_functions.hpp"
#include "tests/rsi/support/estimation_chain.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/random_manoeuvre.hpp"
#include "tests/rsi/support/stages.hpp"
#include "tests/targets/budgets/counted_float.hpp"

namespace {

TEST(LeastSquaresFloor, GoesTheFirmwaresWay) {
    const rsi::Parameters parameters = rsi_test::large_suv();
    rsi_test::RandomManoeuvre drive(parameters, 5U, false);
    rsi_test::EstimationChain chain{parameters};
    rsi_test::RobustLeastSquares firmware;
    firmware.init(parameters);
    budgets::OperationCount count;
    const auto counted = [&](float value) { return budgets::CountedFloat{value, count}; };
    const float disturbance_weight =
        1.0F - rsi::decaying_exponential(6.2831853F * parameters.disturbance_cutoff_hz * 0.01F);
    auto floor = budgets::begin_least_squares(parameters, disturbance_weight, counted);

    // Not for longer: the two round differently, and without excitation the firmware ceases to forget.
    int updates = 0;
    for (; updates < 200; ++updates) {
        rsi::Regression regression;
        ASSERT_TRUE(chain.step(drive.next(), regression));
        ASSERT_LT(firmware.covariance().trace(), parameters.covariance_limit);
        firmware.update(regression);
        budgets::update(
            floor.state, floor.constants,
            {counted(regression.psi.x()), counted(regression.psi.y()), counted(regression.psi.z())},
            counted(regression.output_nm));
        const rsi::RollCentreEstimate estimate = firmware.estimate();
        const float dh = floor.state.theta[0].value() * parameters.initial_roll_centre_deviation_m;
        const float dK = floor.state.theta[1].value() * parameters.initial_stiffness_deviation_nmprad;
        ASSERT_NEAR(dh, estimate.vertical_movement_m, 1.0e-4F) << "update " << updates;
        ASSERT_NEAR(dK, estimate.stiffness_deviation_nmprad, 5.0F) << "update " << updates;
        ASSERT_NEAR(floor.state.disturbance.value() * parameters.regression_scale_nm, estimate.disturbance_nm,
                    0.5F)
            << "update " << updates;
    }
    EXPECT_EQ(count.total() % updates, 0);
    EXPECT_EQ(count.divisions, updates);
    RecordProperty("operations", count.total() / updates);
    std::cout << "operations: " << count.total() / updates << " (" << count.additions / updates
              << " additions, " << count.multiplications / updates << " multiplications, "
              << count.divisions / updates << " division)\n";
}

}  // namespace
