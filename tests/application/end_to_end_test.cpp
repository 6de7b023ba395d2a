// The tests' own end-to-end check against published values, so that it can serve as a reference.
#include "tests/application/end_to_end.hpp"

#include <gtest/gtest.h>

namespace testing_application {
namespace {

TEST(TheBitwiseChecksum, GivesTheCatalogueValueOfSaeJ1850) {
    const std::uint8_t text[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    EXPECT_EQ(crc8_bit_by_bit(0xFFU, text, sizeof(text)) ^ 0xFFU, 0x4BU);
}

TEST(TheBitwiseProtection, GivesTheProfilesVectorForAPayloadOfZeros) {
    rsi::hal::CanFrame frame;
    frame.length = 8U;
    protect(frame, 0x123U, 0U);
    EXPECT_EQ(frame.data[0], 0x2AU);
    EXPECT_EQ(frame.data[1], 0x10U);
    EXPECT_TRUE(is_profile_11(frame, 0x123U));
    EXPECT_FALSE(is_profile_11(frame, 0x124U));
}

}  // namespace
}  // namespace testing_application
