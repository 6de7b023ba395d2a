// The numeric helpers of the further indicators: two lags, length of a vector.
#include <gtest/gtest.h>

#include <cmath>

#include "rsi/numeric/two_lags.hpp"
#include "rsi/numeric/vector_length.hpp"

namespace {

TEST(VectorLength, IsWithinThreeInTenMillionAtAnyDirectionAndScale) {
    EXPECT_EQ(rsi::vector_length(0.0F, -0.0F), 0.0F);
    for (float scale = 1.0e-30F; scale < 1.0e30F; scale *= 977.0F) {
        for (int degrees = 0; degrees < 360; ++degrees) {
            const float a = scale * static_cast<float>(std::cos(degrees * 0.0174532925));
            const float b = scale * static_cast<float>(std::sin(degrees * 0.0174532925));
            const double exact = std::hypot(static_cast<double>(a), static_cast<double>(b));
            ASSERT_NEAR(static_cast<double>(rsi::vector_length(a, b)), exact, 3.0e-7 * exact)
                << scale << ' ' << degrees;
        }
    }
}

// Two lags of 0.02 s answer a unit step with 1 - (1 + t/tau) exp(-t/tau), half a sample earlier in each lag.
TEST(TwoLags, AnswerAStepAsTwoFirstOrderLagsDo) {
    rsi::TwoLags lags;
    lags.reset(0.0F);
    const float weight = rsi::lag_weight(0.02F);
    const double kept = std::exp(-0.5);
    for (int k = 1; k <= 50; ++k) {
        const double before = static_cast<double>(lags.value());
        lags.update(1.0F, weight);
        // The discrete answer in closed form: 1 - q^k (1 + k (1 - q)), q = exp(-T/tau).
        const double expected = 1.0 - std::pow(kept, k) * (1.0 + k * (1.0 - kept));
        ASSERT_NEAR(static_cast<double>(lags.value()), expected, 1e-5) << k;
        ASSERT_NEAR(static_cast<double>(lags.derivative()), (expected - before) / 0.01, 1e-3) << k;
    }
}

TEST(TwoLags, WithoutALagTheValuePassesThrough) {
    rsi::TwoLags lags;
    lags.reset(1.0F);
    lags.update(3.0F, rsi::lag_weight(0.0F));
    EXPECT_EQ(lags.value(), 3.0F);
    EXPECT_NEAR(static_cast<double>(lags.derivative()), 200.0, 1e-3);
}

TEST(TwoLags, StartWhereTheyAreTold) {
    rsi::TwoLags lags;
    lags.reset(7.0F);
    lags.update(7.0F, rsi::lag_weight(0.02F));
    EXPECT_EQ(lags.value(), 7.0F);
    EXPECT_EQ(lags.derivative(), 0.0F);
}

}  // namespace
