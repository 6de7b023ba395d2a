// The bounded functions against the C library in double, over the whole range of arguments.
#include "rsi/numeric/bounded_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bounded_functions_test {
namespace {

constexpr int points = 400000;

// Largest of error(x) at evenly spaced floats from `from` to `to`, both included.
template <typename Error>
double largest_over(double from, double to, Error error) {
    double largest = 0.0;
    for (int i = 0; i <= points; ++i) {
        const float x = static_cast<float>(from + (to - from) * i / points);
        largest = std::fmax(largest, error(x));
    }
    return largest;
}

double as_double(float value) {
    return static_cast<double>(value);
}

constexpr double largest_angle = 1.3;

float sine(float x) {
    return rsi::bounded_sine_and_versine(x).sine;
}

float cosine(float x) {
    return 1.0F - rsi::bounded_sine_and_versine(x).versine;
}

TEST(BoundedFunctions, SineStaysWithinItsDocumentedError) {
    const double error = largest_over(-largest_angle, largest_angle, [](float x) {
        return std::fabs(as_double(sine(x)) - std::sin(as_double(x)));
    });
    EXPECT_LT(error, 3.0e-7);
}

TEST(BoundedFunctions, CosineStaysWithinItsDocumentedError) {
    const double error = largest_over(-largest_angle, largest_angle, [](float x) {
        return std::fabs(as_double(cosine(x)) - std::cos(as_double(x)));
    });
    EXPECT_LT(error, 8.0e-6);
}

TEST(BoundedFunctions, TangentStaysWithinItsDocumentedRelativeError) {
    const double error = largest_over(-1.3, 1.3, [](float x) {
        const double truth = std::tan(as_double(x));
        return (truth == 0.0) ? std::fabs(as_double(rsi::bounded_tangent(x)))
                              : std::fabs(as_double(rsi::bounded_tangent(x)) / truth - 1.0);
    });
    EXPECT_LT(error, 5.0e-5);
}

TEST(BoundedFunctions, VersineKeepsItsDigitsNearZero) {
    for (const float x : {1.0e-6F, 1.0e-3F, 0.03F, 0.3F, 1.25F}) {
        const double half_sine = std::sin(0.5 * as_double(x));
        const double truth = 2.0 * half_sine * half_sine;
        EXPECT_NEAR(as_double(rsi::bounded_sine_and_versine(x).versine), truth, 8.0e-6 * truth) << x;
    }
}

TEST(BoundedFunctions, ShortRangeTangentStaysWithinItsDocumentedRelativeError) {
    const double error = largest_over(-0.5, 0.5, [](float x) {
        const double truth = std::tan(as_double(x));
        return (truth == 0.0) ? std::fabs(as_double(rsi::short_range_tangent(x)))
                              : std::fabs(as_double(rsi::short_range_tangent(x)) / truth - 1.0);
    });
    EXPECT_LT(error, 2.0e-6);
}

TEST(BoundedFunctions, DecayingExponentialStaysWithinItsDocumentedRelativeError) {
    const double error = largest_over(0.0, 16.0, [](float x) {
        return std::fabs(as_double(rsi::decaying_exponential(x)) / std::exp(-as_double(x)) - 1.0);
    });
    EXPECT_LT(error, 1.0e-5);
}

TEST(BoundedFunctions, ArgumentsBeyondTheRangeCountAsItsEnd) {
    const float huge = std::numeric_limits<float>::max();
    for (const float beyond : {1.6F, 2.2F, 100.0F, huge}) {
        EXPECT_EQ(sine(beyond), sine(rsi::largest_angle_rad));
        EXPECT_EQ(sine(-beyond), sine(-rsi::largest_angle_rad));
        EXPECT_EQ(cosine(beyond), cosine(rsi::largest_angle_rad));
        EXPECT_EQ(rsi::bounded_tangent(beyond), rsi::bounded_tangent(rsi::largest_angle_rad));
        EXPECT_EQ(rsi::bounded_tangent(-beyond), rsi::bounded_tangent(-rsi::largest_angle_rad));
        EXPECT_EQ(rsi::decaying_exponential(16.0F + beyond), rsi::decaying_exponential(16.0F));
        EXPECT_EQ(rsi::decaying_exponential(-beyond), 1.0F);
    }
}

TEST(BoundedFunctions, SineAndTangentAreExactlyOddAndCosineExactlyEven) {
    for (int i = 0; i <= 1000; ++i) {
        const float x = 0.002F * static_cast<float>(i);
        EXPECT_EQ(sine(-x), -sine(x));
        EXPECT_EQ(rsi::bounded_tangent(-x), -rsi::bounded_tangent(x));
        EXPECT_EQ(cosine(-x), cosine(x));
    }
}

TEST(BoundedFunctions, NotANumberAndInfinitiesAreNotFinite) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(rsi::is_finite(infinity));
    EXPECT_FALSE(rsi::is_finite(-infinity));
    EXPECT_FALSE(rsi::is_finite(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_TRUE(rsi::is_finite(std::numeric_limits<float>::max()));
    EXPECT_TRUE(rsi::is_finite(std::numeric_limits<float>::denorm_min()));
    EXPECT_FALSE(rsi::is_within(std::numeric_limits<float>::quiet_NaN(), -1.0F, 1.0F));
}

}  // namespace
}  // namespace bounded_functions_test
