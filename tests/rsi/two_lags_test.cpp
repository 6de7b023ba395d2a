// Two lags in a row.
#include <gtest/gtest.h>

#include <cmath>

#include "rsi/numeric/two_lags.hpp"

namespace two_lags_test {
namespace {

// Two lags of 0.02 s answer a unit step with 1 - (1 + t/tau) exp(-t/tau), half a sample earlier in each lag.
TEST(TwoLags, AnswerAStepAsTwoFirstOrderLagsDo) {
    rsi::TwoLags lags;
    lags.reset(0.0F);
    const float weight = rsi::lag_weight(0.02F);
    const double kept = std::exp(-0.5);
    for (int k = 1; k <= 50; ++k) {
        const double before = static_cast<double>(lags.value());
        const float change = lags.update(1.0F, weight);
        // The discrete answer in closed form: 1 - q^k (1 + k (1 - q)), q = exp(-T/tau).
        const double expected = 1.0 - std::pow(kept, k) * (1.0 + k * (1.0 - kept));
        ASSERT_NEAR(static_cast<double>(lags.value()), expected, 1e-5) << k;
        ASSERT_NEAR(static_cast<double>(change), expected - before, 1e-5) << k;
    }
}

TEST(TwoLags, WithoutALagTheValuePassesThrough) {
    rsi::TwoLags lags;
    lags.reset(1.0F);
    EXPECT_EQ(lags.update(3.0F, rsi::lag_weight(0.0F)), 2.0F);
    EXPECT_EQ(lags.value(), 3.0F);
}

TEST(TwoLags, StartWhereTheyAreTold) {
    rsi::TwoLags lags;
    lags.reset(7.0F);
    EXPECT_EQ(lags.update(7.0F, rsi::lag_weight(0.02F)), 0.0F);
    EXPECT_EQ(lags.value(), 7.0F);
}

}  // namespace
}  // namespace two_lags_test
