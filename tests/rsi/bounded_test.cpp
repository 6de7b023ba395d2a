// Guards on numbers, at and beyond their limits and for what is no number.
#include "rsi/numeric/bounded.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "rsi/numeric/saturating_count.hpp"

namespace bounded_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();

TEST(Bounded, WithinHoldsAtBothEndsAndNotBeyond) {
    EXPECT_TRUE(rsi::is_within(2.0F, 2.0F, 3.0F));
    EXPECT_TRUE(rsi::is_within(3.0F, 2.0F, 3.0F));
    EXPECT_FALSE(rsi::is_within(std::nextafter(2.0F, 0.0F), 2.0F, 3.0F));
    EXPECT_FALSE(rsi::is_within(std::nextafter(3.0F, 4.0F), 2.0F, 3.0F));
    for (const float value : {nan, infinity, -infinity}) {
        EXPECT_FALSE(rsi::is_within(value, 2.0F, 3.0F)) << value;
    }
}

TEST(Bounded, WithinAMagnitudeHoldsOnBothSides) {
    for (const float sign : {-1.0F, 1.0F}) {
        EXPECT_TRUE(rsi::is_within_magnitude(sign * 3.0F, 3.0F));
        EXPECT_FALSE(rsi::is_within_magnitude(sign * std::nextafter(3.0F, 4.0F), 3.0F));
        EXPECT_FALSE(rsi::is_within_magnitude(sign * infinity, 3.0F));
    }
    EXPECT_FALSE(rsi::is_within_magnitude(nan, 3.0F));
}

TEST(Bounded, FiniteIsEveryNumberAndNothingElse) {
    for (const float value : {0.0F, -0.0F, largest, -largest, std::numeric_limits<float>::denorm_min()}) {
        EXPECT_TRUE(rsi::is_finite(value)) << value;
    }
    for (const float value : {nan, -nan, infinity, -infinity}) {
        EXPECT_FALSE(rsi::is_finite(value)) << value;
    }
}

TEST(Bounded, ClampKeepsWhatIsWithinAndCutsTheRest) {
    EXPECT_EQ(rsi::clamp(-3.0F, -2.0F, 5.0F), -2.0F);
    EXPECT_EQ(rsi::clamp(-2.0F, -2.0F, 5.0F), -2.0F);
    EXPECT_EQ(rsi::clamp(4.5F, -2.0F, 5.0F), 4.5F);
    EXPECT_EQ(rsi::clamp(6.0F, -2.0F, 5.0F), 5.0F);
    EXPECT_EQ(rsi::clamp_magnitude(-6.0F, 5.0F), -5.0F);
    EXPECT_EQ(rsi::clamp_magnitude(-4.5F, 5.0F), -4.5F);
    EXPECT_EQ(rsi::clamp_magnitude(6.0F, 5.0F), 5.0F);
    EXPECT_EQ(rsi::clamp_magnitude(0.5F, 0.2F), 0.2F);
    EXPECT_EQ(rsi::clamp_magnitude(-0.5F, 0.2F), -0.2F);
}

TEST(Bounded, SmallerAndLargerChoose) {
    EXPECT_EQ(rsi::smaller(-1.0F, 2.0F), -1.0F);
    EXPECT_EQ(rsi::smaller(2.0F, -1.0F), -1.0F);
    EXPECT_EQ(rsi::larger(-1.0F, 2.0F), 2.0F);
    EXPECT_EQ(rsi::larger(2.0F, -1.0F), 2.0F);
}

TEST(Bounded, AbsoluteTakesTheSignOffWhateverThereIs) {
    EXPECT_EQ(rsi::absolute(-2.5F), 2.5F);
    EXPECT_EQ(rsi::absolute(2.5F), 2.5F);
    EXPECT_FALSE(std::signbit(rsi::absolute(-0.0F)));
    EXPECT_EQ(rsi::absolute(-infinity), infinity);
    EXPECT_TRUE(std::isnan(rsi::absolute(nan)));
}

TEST(SaturatingCount, StaysAtItsLargest) {
    std::uint32_t count = UINT32_MAX - 1U;
    rsi::count_up(count);
    EXPECT_EQ(count, UINT32_MAX);
    rsi::count_up(count);
    EXPECT_EQ(count, UINT32_MAX);
}

}  // namespace
}  // namespace bounded_test
