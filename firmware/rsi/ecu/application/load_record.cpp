#include "rsi/ecu/application/load_record.hpp"

#include "rsi/ecu/application/crc32.hpp"
#include "rsi/ecu/application/little_endian.hpp"
#include "rsi/parameters.hpp"

namespace rsi::application {
namespace {

constexpr std::uint32_t record_magic = 0x4D495352U;  // "RSIM": "RSIL" had no offset of the accelerometer
constexpr std::size_t parameters_at = 4U;
constexpr std::size_t excess_at = 8U;
constexpr std::size_t deviation_at = 12U;
constexpr std::size_t offset_at = 16U;
constexpr std::size_t lateral_offset_at = 20U;
constexpr std::size_t record_checksum_at = 24U;

std::uint32_t add_to_remainder(std::uint32_t remainder, std::uint32_t word) {
    for (std::uint32_t byte = 0U; byte < 4U; ++byte) {
        remainder = crc32_update(remainder, static_cast<std::uint8_t>(word >> (8U * byte)));
    }
    return remainder;
}

}  // namespace

std::uint32_t check_word_of(const rsi::Parameters& parameters) noexcept {
    std::uint32_t remainder = crc32_start;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        remainder = add_to_remainder(remainder, float_bits(parameters.*field.member));
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        remainder = add_to_remainder(remainder, static_cast<std::uint32_t>(parameters.*field.member));
    }
    return crc32_end(remainder);
}

LoadRecord write_load_record(const Learnt& learnt, std::uint32_t parameters_check_word) noexcept {
    LoadRecord record{};
    std::uint8_t* const bytes = record.data();
    put_u32(bytes, 0U, record_magic);
    put_u32(bytes, parameters_at, parameters_check_word);
    put_u32(bytes, excess_at, float_bits(learnt.load.excess));
    put_u32(bytes, deviation_at, float_bits(learnt.load.excess_deviation));
    put_u32(bytes, offset_at, float_bits(learnt.load.offset_mps2));
    put_u32(bytes, lateral_offset_at, float_bits(learnt.lateral_offset_mps2));
    put_u32(bytes, record_checksum_at, crc32(bytes, record_checksum_at));
    return record;
}

bool is_load_record(const LoadRecord& record) noexcept {
    const std::uint8_t* const bytes = record.data();
    return (u32_at(bytes, 0U) == record_magic) &&
           (u32_at(bytes, record_checksum_at) == crc32(bytes, record_checksum_at));
}

bool read_load_record(const LoadRecord& record, std::uint32_t parameters_check_word,
                      Learnt& learnt) noexcept {
    const std::uint8_t* const bytes = record.data();
    const bool good = (u32_at(bytes, parameters_at) == parameters_check_word);
    if (good) {
        learnt.load = rsi::LearntLoad{float_at(bytes, excess_at), float_at(bytes, deviation_at),
                                      float_at(bytes, offset_at)};
        learnt.lateral_offset_mps2 = float_at(bytes, lateral_offset_at);
    }
    return good;
}

}  // namespace rsi::application
