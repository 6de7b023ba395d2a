// Little-endian numbers: which bytes are read and written, and no other.
#include "rsi/ecu/application/little_endian.hpp"

#include <gtest/gtest.h>

#include <array>

namespace {

using Bytes = std::array<std::uint8_t, 6>;

constexpr Bytes bytes{0x11U, 0xD2U, 0x83U, 0xF4U, 0xA5U, 0x96U};

TEST(LittleEndian, ReadsTheLeastSignificantByteFirst) {
    EXPECT_EQ(rsi::application::u16_at(bytes.data(), 0U), 0xD211U);
    EXPECT_EQ(rsi::application::u16_at(bytes.data(), 3U), 0xA5F4U);
    EXPECT_EQ(rsi::application::u32_at(bytes.data(), 0U), 0xF483'D211U);
    EXPECT_EQ(rsi::application::u32_at(bytes.data(), 2U), 0x96A5'F483U);
}

TEST(LittleEndian, WritesFourBytesAndNoOther) {
    Bytes written{};
    written.fill(0x77U);
    rsi::application::put_u32(written.data(), 1U, 0xA5F4'83D2U);
    EXPECT_EQ(written, (Bytes{0x77U, 0xD2U, 0x83U, 0xF4U, 0xA5U, 0x77U}));
}

TEST(LittleEndian, AFloatIsItsBits) {
    EXPECT_EQ(rsi::application::float_bits(-1.5F), 0xBFC0'0000U);
    EXPECT_EQ(rsi::application::float_at(Bytes{0xFFU, 0x00U, 0x00U, 0xC0U, 0xBFU, 0xFFU}.data(), 1U), -1.5F);
}

}  // namespace
