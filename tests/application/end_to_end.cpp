#include "tests/application/end_to_end.hpp"

namespace testing_application {
namespace {

std::uint8_t profile_11_crc(const rsi::hal::CanFrame& frame, std::uint16_t data_id) {
    const std::uint8_t prefix[] = {static_cast<std::uint8_t>(data_id & 0xFFU), 0U};
    const std::uint8_t start = crc8_bit_by_bit(0U, prefix, sizeof(prefix));
    return crc8_bit_by_bit(start, frame.data.data() + 1, frame.length - 1U);
}

}  // namespace

std::uint8_t crc8_bit_by_bit(std::uint8_t start, const std::uint8_t* data, std::size_t length) {
    unsigned remainder = start;
    for (std::size_t index = 0U; index < length; ++index) {
        for (unsigned bit = 8U; bit-- > 0U;) {
            const unsigned next = (data[index] >> bit) & 1U;
            const unsigned out = (remainder >> 7U) & 1U;
            remainder = (remainder << 1U) & 0xFFU;
            remainder ^= (next ^ out) != 0U ? 0x1DU : 0U;
        }
    }
    return static_cast<std::uint8_t>(remainder);
}

bool is_profile_11(const rsi::hal::CanFrame& frame, std::uint16_t data_id) {
    return frame.length >= 2U && frame.data[0] == profile_11_crc(frame, data_id) &&
           (frame.data[1] >> 4U) == (data_id >> 8U);
}

void protect(rsi::hal::CanFrame& frame, std::uint16_t data_id, unsigned counter) {
    frame.data[1] = static_cast<std::uint8_t>((unsigned{data_id} >> 8U << 4U) | (counter & 0xFU));
    frame.data[0] = profile_11_crc(frame, data_id);
}

unsigned counter_of(const rsi::hal::CanFrame& frame) {
    return frame.data[1] & 0xFU;
}

}  // namespace testing_application
