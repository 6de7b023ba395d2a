// Bit timing at the four usual bit rates, from the silicon's 100 MHz.
#include "hal/zynqmp_r5/can_bit_timing.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rsi::hal::zynqmp_r5 {
namespace {

constexpr std::uint32_t clock_hz = 100'000'000U;

struct Expected {
    std::uint32_t bit_rate;
    std::uint32_t prescaler_register;
    std::uint32_t timing_register;
    std::uint32_t sample_point_permille;
};

class CanBitTimingTest : public ::testing::TestWithParam<Expected> {};

TEST_P(CanBitTimingTest, GivesTheBitRateExactlyWithTheSamplePoint) {
    const CanBitSegments segments = can_bit_segments(clock_hz, GetParam().bit_rate);
    EXPECT_EQ(segments.bit_rate(clock_hz), GetParam().bit_rate);
    EXPECT_EQ(segments.prescaler * segments.quanta() * GetParam().bit_rate, clock_hz);
    EXPECT_EQ(segments.sample_point_permille(), GetParam().sample_point_permille);
    EXPECT_EQ(segments.registers().prescaler_register, GetParam().prescaler_register);
    EXPECT_EQ(segments.registers().timing_register, GetParam().timing_register);
}

// 16 quanta of 1 + 13 + 2, or 20 of 1 + 16 + 3, where 16 do not divide the clock.
INSTANTIATE_TEST_SUITE_P(BitRates, CanBitTimingTest,
                         ::testing::Values(Expected{125'000U, 49U, 0x09CU, 875U},
                                           Expected{250'000U, 24U, 0x09CU, 875U},
                                           Expected{500'000U, 9U, 0x12FU, 850U},
                                           Expected{1'000'000U, 4U, 0x12FU, 850U}),
                         [](const auto& rate) { return std::to_string(rate.param.bit_rate); });

TEST(CanBitTiming, IsTheSameWhereTheCompilerComputesIt) {
    constexpr CanBitTiming timing = can_bit_timing<clock_hz, 500'000U>();
    static_assert(timing.prescaler_register == 9U && timing.timing_register == 0x12FU);
}

TEST(CanBitTiming, SaysWhenTheClockGivesNoExactBitRate) {
    EXPECT_EQ(can_bit_segments(99'999'900U, 500'000U).prescaler, 0U);
    EXPECT_EQ(can_bit_segments(4'000'000U, 500'000U).prescaler, 0U);  // too few quanta
}

TEST(CanBitTiming, HasSixteenToTwentyFiveQuantaOfOneTo256ClockPeriods) {
    const auto is = [](const CanBitSegments& found, std::uint32_t prescaler, std::uint32_t before,
                       std::uint32_t after, std::uint32_t jump) {
        return found.prescaler == prescaler && found.before_sample == before && found.after_sample == after &&
               found.jump_width == jump;
    };
    EXPECT_TRUE(is(can_bit_segments(16'000'000U, 1'000'000U), 1U, 13U, 2U, 2U));
    EXPECT_EQ(can_bit_segments(15'000'000U, 1'000'000U).prescaler, 0U);
    EXPECT_TRUE(is(can_bit_segments(25'000'000U, 1'000'000U), 1U, 16U, 8U, 4U));
    EXPECT_EQ(can_bit_segments(26'000'000U, 1'000'000U).prescaler, 0U);
    EXPECT_TRUE(is(can_bit_segments(512'000'000U, 125'000U), 256U, 13U, 2U, 2U));
    EXPECT_EQ(can_bit_segments(514'000'000U, 125'000U).prescaler, 0U);
}

TEST(CanBitTiming, HasTheSamplePointThatIsNearestToTheWantedOne) {
    EXPECT_EQ(can_bit_segments(17'000'000U, 1'000'000U).sample_point_permille(), 882U);
    EXPECT_EQ(can_bit_segments(18'000'000U, 1'000'000U).sample_point_permille(), 888U);
    EXPECT_EQ(can_bit_segments(19'000'000U, 1'000'000U).sample_point_permille(), 894U);
    EXPECT_EQ(can_bit_segments(20'000'000U, 1'000'000U).sample_point_permille(), 850U);
}

TEST(CanBitTiming, TheJumpIsNeverWiderThanTheSegmentAfterTheSamplePoint) {
    for (const std::uint32_t clock :
         {16'000'000U, 20'000'000U, 24'000'000U, 40'000'000U, 80'000'000U, 100'000'000U}) {
        for (const std::uint32_t bit_rate : {125'000U, 250'000U, 500'000U, 1'000'000U}) {
            const CanBitSegments segments = can_bit_segments(clock, bit_rate);
            EXPECT_LE(segments.jump_width, segments.after_sample);
            EXPECT_LE(segments.jump_width, 4U);
        }
    }
}

}  // namespace
}  // namespace rsi::hal::zynqmp_r5
