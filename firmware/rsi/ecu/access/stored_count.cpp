#include "rsi/ecu/access/stored_count.hpp"

#include <array>

namespace rsi::access {
namespace {

constexpr std::size_t count_at = 4U;
constexpr std::size_t inverted_at = 8U;

using Record = std::array<std::uint8_t, stored_count_length>;

std::uint32_t u32_at(const Record& record, std::size_t place) {
    std::uint32_t word = 0U;
    for (std::size_t byte = 0U; byte < 4U; ++byte) {
        word |= static_cast<std::uint32_t>(record[place + byte]) << (8U * byte);
    }
    return word;
}

void put_u32(Record& record, std::size_t place, std::uint32_t word) {
    for (std::size_t byte = 0U; byte < 4U; ++byte) {
        record[place + byte] = static_cast<std::uint8_t>((word >> (8U * byte)) & 0xFFU);
    }
}

}  // namespace

CountState read_count(hal::Storage& storage, CountOf what, std::uint32_t& count) noexcept {
    Record record{};
    const hal::Reading reading = storage.read(record.data(), record.size());
    if (reading == hal::Reading::never_written) {
        return CountState::absent;
    }
    const std::uint32_t read = u32_at(record, count_at);
    if ((reading != hal::Reading::stored) || (u32_at(record, 0U) != static_cast<std::uint32_t>(what)) ||
        (u32_at(record, inverted_at) != ~read)) {
        return CountState::damaged;
    }
    count = read;
    return CountState::good;
}

bool write_count(hal::Storage& storage, CountOf what, std::uint32_t count) noexcept {
    Record record{};
    put_u32(record, 0U, static_cast<std::uint32_t>(what));
    put_u32(record, count_at, count);
    put_u32(record, inverted_at, ~count);
    return storage.write(record.data(), record.size());
}

}  // namespace rsi::access
