// End-to-end check by another way than the code under test: bit by bit, from the profile's description.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rsi/hal/can_bus.hpp"

namespace testing_application {

// CRC-8 of SAE J1850 (polynomial 0x1D, most significant bit first) with any start value, no final xor.
std::uint8_t crc8_bit_by_bit(std::uint8_t start, const std::uint8_t* data, std::size_t length);

// Profile 11, data identifier as a nibble: whether byte 0 and the high nibble of byte 1 are right.
bool is_profile_11(const rsi::hal::CanFrame& frame, std::uint16_t data_id);

// Makes them right, with this counter (any value of 4 bits, the forbidden 15 too).
void protect(rsi::hal::CanFrame& frame, std::uint16_t data_id, unsigned counter);

unsigned counter_of(const rsi::hal::CanFrame& frame);

}  // namespace testing_application
