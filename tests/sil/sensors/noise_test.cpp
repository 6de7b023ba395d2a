// Noise: the same bits everywhere, and the statistics that its options promise.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "sil/world/sensors/noise_source.hpp"

namespace {

constexpr std::size_t many = 200'000U;

std::vector<double> draw(std::uint64_t seed, std::uint64_t stream, std::size_t count) {
    sil::NoiseSource source(seed, stream);
    std::vector<double> values(count);
    for (double& value : values) {
        value = source.next();
    }
    return values;
}

// Mean of x(k) * y(k - lag).
double moment(const std::vector<double>& x, const std::vector<double>& y, std::size_t lag) {
    double sum = 0.0;
    for (std::size_t index = lag; index < x.size(); ++index) {
        sum += x[index] * y[index - lag];
    }
    return sum / static_cast<double>(x.size() - lag);
}

double mean(const std::vector<double>& values) {
    return moment(values, std::vector<double>(values.size(), 1.0), 0U);
}

// Standard error of a mean of `many` values of unit variance; bounds below are five of these.
const double five_standard_errors = 5.0 / std::sqrt(static_cast<double>(many));

TEST(NoiseSource, GivesTheBitsThatAnIndependentMersenneTwisterGives) {
    // Computed in Python from the published recurrence of MT19937-64 and splitmix64, in exact integers.
    EXPECT_EQ(draw(1U, 1U, 3U), (std::vector<double>{0x1.0d05e47cp-1, -0x1.af0050c8p-2, -0x1.670d44bap-1}));
    EXPECT_EQ(draw(42U, 8U, 3U), (std::vector<double>{0x1.1dae3ea8p-1, -0x1.281f3744p+0, 0x1.4135736dp+0}));
}

TEST(NoiseSource, HasZeroMeanAndUnitVariance) {
    const std::vector<double> values = draw(1U, 1U, many);
    EXPECT_NEAR(mean(values), 0.0, five_standard_errors);
    EXPECT_NEAR(moment(values, values, 0U), 1.0, std::sqrt(1.9) * five_standard_errors);
}

TEST(NoiseSource, IsNearlyGaussian) {
    const std::vector<double> values = draw(2U, 1U, many);
    std::vector<double> squares = values;
    std::size_t within_one = 0U;
    std::size_t within_two = 0U;
    for (std::size_t index = 0U; index < values.size(); ++index) {
        squares[index] = values[index] * values[index];
        within_one += std::fabs(values[index]) < 1.0 ? 1U : 0U;
        within_two += std::fabs(values[index]) < 2.0 ? 1U : 0U;
        ASSERT_LE(std::fabs(values[index]), 6.0);
    }
    // Fourth moment of twelve uniforms: 3 - 6/(5 * 12) = 2.9. Shares of a Gaussian: 0.6827 and 0.9545.
    EXPECT_NEAR(moment(squares, squares, 0U), 2.9, 0.1);
    EXPECT_NEAR(static_cast<double>(within_one) / many, 0.6827, 0.01);
    EXPECT_NEAR(static_cast<double>(within_two) / many, 0.9545, 0.005);
}

TEST(NoiseSource, IsWhite) {
    const std::vector<double> values = draw(3U, 1U, many);
    for (const std::size_t lag : {1U, 2U, 5U, 10U, 100U}) {
        EXPECT_NEAR(moment(values, values, lag), 0.0, five_standard_errors) << "lag " << lag;
    }
}

TEST(NoiseSource, StreamsAndNeighbouringSeedsAreUncorrelated) {
    const std::vector<double> values = draw(4U, 1U, many);
    EXPECT_NEAR(moment(values, draw(4U, 2U, many), 0U), 0.0, five_standard_errors);
    EXPECT_NEAR(moment(values, draw(5U, 1U, many), 0U), 0.0, five_standard_errors);
}

TEST(NoiseSource, TheSameSeedRepeatsAndAnotherDoesNot) {
    EXPECT_EQ(draw(9U, 3U, 100U), draw(9U, 3U, 100U));
    EXPECT_NE(draw(9U, 3U, 100U), draw(10U, 3U, 100U));
    EXPECT_NE(draw(9U, 3U, 100U), draw(9U, 4U, 100U));
}

}  // namespace
