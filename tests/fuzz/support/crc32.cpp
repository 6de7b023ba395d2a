#include "tests/fuzz/support/crc32.hpp"

namespace fuzz {

std::uint32_t crc32_by_division(const std::uint8_t* bytes, std::size_t length) {
    std::uint32_t remainder = 0xFFFFFFFFU;
    for (std::size_t bit = 0U; bit < 8U * length; ++bit) {
        const std::uint32_t next = (bytes[bit / 8U] >> (bit % 8U)) & 1U;
        const std::uint32_t out = remainder >> 31U;
        remainder = (remainder << 1U) ^ (out != next ? 0x04C11DB7U : 0U);
    }
    std::uint32_t reflected = 0U;
    for (unsigned bit = 0U; bit < 32U; ++bit) {
        reflected |= ((remainder >> bit) & 1U) << (31U - bit);
    }
    return ~reflected;
}

}  // namespace fuzz
