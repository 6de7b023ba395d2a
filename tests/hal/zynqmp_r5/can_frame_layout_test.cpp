// Place of the bits of a frame in the controller's FIFO.
#include <gtest/gtest.h>

#include "hal/zynqmp_r5/can_frame_layout.hpp"
#include "hal/zynqmp_r5/emulator/emulator_policy.hpp"
#include "tests/hal/make_frame.hpp"

namespace rsi::hal::zynqmp_r5 {
namespace {

using rsi::hal::testing::make_frame;

CanFrame extended_frame() {
    CanFrame frame = make_frame(0x1234'5678U, {0xAAU});
    frame.extended = true;
    return frame;
}

TEST(SiliconCanFrameLayout, StandardIdentifierAndFirstByteAreInTheUppermostBits) {
    const CanFrameWords words =
        SiliconCanFrameLayout::pack(make_frame(0x123U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}));
    EXPECT_EQ(words, (CanFrameWords{0x2460'0000U, 0x8000'0000U, 0x0102'0304U, 0x0506'0708U}));
}

TEST(SiliconCanFrameLayout, ExtendedIdentifierIsInTwoParts) {
    EXPECT_EQ(SiliconCanFrameLayout::pack(extended_frame())[0], 0x91B8'ACF0U);
}

TEST(SiliconCanFrameLayout, RemoteFramesAreNoDataFrames) {
    CanFrame frame;
    EXPECT_TRUE(SiliconCanFrameLayout::unpack({0x2460'0000U, 0U, 0U, 0U}, frame));
    EXPECT_FALSE(SiliconCanFrameLayout::unpack({0x2470'0000U, 0U, 0U, 0U}, frame));
    EXPECT_TRUE(SiliconCanFrameLayout::unpack({0x91B8'ACF0U, 0U, 0U, 0U}, frame));
    EXPECT_FALSE(SiliconCanFrameLayout::unpack({0x91B8'ACF1U, 0U, 0U, 0U}, frame));
}

TEST(SiliconCanFrameLayout, FilterLetsOneStandardDataFrameThrough) {
    const CanFilter filter = SiliconCanFrameLayout::filter({0x123U, 0x7FFU});
    const auto passes = [&filter](std::uint32_t word) {
        return (word & filter.mask) == (filter.identifier & filter.mask);
    };
    EXPECT_TRUE(passes(0x2460'0000U));
    EXPECT_FALSE(passes(0x2480'0000U));  // another identifier
    EXPECT_FALSE(passes(0x2470'0000U));  // remote
    EXPECT_FALSE(passes(0x2468'0000U));  // extended
}

TEST(SiliconCanFrameLayout, FilterLooksAtTheBitsOfTheMask) {
    const CanFilter filter = SiliconCanFrameLayout::filter({0x120U, 0x7FCU});
    EXPECT_EQ(filter.mask, 0xFF98'0000U);
    EXPECT_EQ(filter.identifier, 0x2400'0000U);
}

TEST(CanAcceptance, LetsAllThroughAndAsFewOthersAsOneMaskCan) {
    const CanAcceptance one = accepting(std::array{0x0D0U});
    EXPECT_EQ(one.identifier, 0x0D0U);
    EXPECT_EQ(one.mask, 0x7FFU);
    const std::array<std::uint32_t, 3> wanted{0x120U, 0x121U, 0x123U};
    const CanAcceptance several = accepting(wanted);
    EXPECT_EQ(several.identifier & several.mask, 0x120U);
    EXPECT_EQ(several.mask, 0x7FCU);
    EXPECT_EQ(accepting(std::array{0x000U, 0x7FFU}).mask, 0U);
}

TEST(EmulatorCanFrameLayout, IdentifierAndFirstByteAreInTheLowestBits) {
    const CanFrameWords words =
        EmulatorCanFrameLayout::pack(make_frame(0x123U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}));
    EXPECT_EQ(words, (CanFrameWords{0x123U, 0x8000'0000U, 0x0403'0201U, 0x0807'0605U}));
    EXPECT_EQ(EmulatorCanFrameLayout::pack(extended_frame())[0], 0x9234'5678U);
}

TEST(EmulatorCanFrameLayout, FilterAndUnpackingKeepOutWhatIsNoStandardDataFrame) {
    const CanFilter filter = EmulatorCanFrameLayout::filter({0x123U, 0x7FFU});
    CanFrame frame;
    for (const std::uint32_t flag : {1U << 30U, 1U << 29U}) {
        EXPECT_NE((0x123U | flag) & filter.mask, filter.identifier);
        EXPECT_FALSE(EmulatorCanFrameLayout::unpack({0x123U | flag, 0U, 0U, 0U}, frame));
    }
    EXPECT_NE((0x123U | (1U << 31U)) & filter.mask, filter.identifier);
    EXPECT_EQ(0x123U & filter.mask, filter.identifier);
    const CanFilter wider = EmulatorCanFrameLayout::filter({0x120U, 0x7FCU});
    EXPECT_EQ(0x123U & wider.mask, wider.identifier);
    EXPECT_NE(0x124U & wider.mask, wider.identifier);
}

template <typename Layout>
class CanFrameLayoutTest : public ::testing::Test {};
using Layouts = ::testing::Types<SiliconCanFrameLayout, EmulatorCanFrameLayout>;
TYPED_TEST_SUITE(CanFrameLayoutTest, Layouts, );

TYPED_TEST(CanFrameLayoutTest, EveryLengthAndIdentifierComesBackAsItWas) {
    for (std::uint8_t length = 0U; length <= 8U; ++length) {
        for (const bool extended : {false, true}) {
            CanFrame frame = make_frame(extended ? 0x1ABC'DEF0U + length : 0x7F0U + length, {});
            frame.extended = extended;
            frame.length = length;
            for (std::uint8_t byte = 0U; byte < length; ++byte) {
                frame.data[byte] = static_cast<std::uint8_t>(0x91U + 0x11U * byte);
            }
            CanFrame back;
            ASSERT_TRUE(TypeParam::unpack(TypeParam::pack(frame), back));
            EXPECT_EQ(back.identifier, frame.identifier);
            EXPECT_EQ(back.extended, frame.extended);
            EXPECT_EQ(back.length, frame.length);
            EXPECT_EQ(back.data, frame.data);
        }
    }
}

TYPED_TEST(CanFrameLayoutTest, LengthCodesAboveEightStandForEightBytes) {
    CanFrame frame;
    ASSERT_TRUE(TypeParam::unpack({0U, 0xF000'0000U, 0xFFFF'FFFFU, 0xFFFF'FFFFU}, frame));
    EXPECT_EQ(frame.length, 8U);
    EXPECT_EQ(frame.data[8], 0U);
}

}  // namespace
}  // namespace rsi::hal::zynqmp_r5
