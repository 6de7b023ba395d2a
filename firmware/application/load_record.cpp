#include "application/load_record.hpp"

#include <cstring>

#include "application/crc32.hpp"
#include "rsi/parameters.hpp"

namespace application {
namespace {

constexpr std::uint32_t record_magic = 0x4C495352U;  // "RSIL"
constexpr std::size_t parameters_at = 4U;
constexpr std::size_t excess_at = 8U;
constexpr std::size_t deviation_at = 12U;
constexpr std::size_t offset_at = 16U;
constexpr std::size_t record_checksum_at = 20U;

std::uint32_t word_of(float value) {
    std::uint32_t word = 0U;
    std::memcpy(&word, &value, sizeof word);
    return word;
}

float value_of(std::uint32_t word) {
    float value = 0.0F;
    std::memcpy(&value, &word, sizeof value);
    return value;
}

void put(LoadRecord& record, std::size_t place, std::uint32_t word) {
    for (std::size_t byte = 0U; byte < 4U; ++byte) {
        record[place + byte] = static_cast<std::uint8_t>(word >> (8U * byte));
    }
}

std::uint32_t word_in(const LoadRecord& record, std::size_t place) {
    std::uint32_t word = 0U;
    for (std::size_t byte = 0U; byte < 4U; ++byte) {
        word |= static_cast<std::uint32_t>(record[place + byte]) << (8U * byte);
    }
    return word;
}

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
        remainder = add_to_remainder(remainder, word_of(parameters.*field.member));
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        remainder = add_to_remainder(remainder, static_cast<std::uint32_t>(parameters.*field.member));
    }
    return crc32_end(remainder);
}

LoadRecord write_load_record(const rsi::LearntLoad& learnt, std::uint32_t parameters_check_word) noexcept {
    LoadRecord record{};
    put(record, 0U, record_magic);
    put(record, parameters_at, parameters_check_word);
    put(record, excess_at, word_of(learnt.excess));
    put(record, deviation_at, word_of(learnt.excess_deviation));
    put(record, offset_at, word_of(learnt.offset_mps2));
    put(record, record_checksum_at, crc32(record.data(), record_checksum_at));
    return record;
}

bool read_load_record(const LoadRecord& record, std::uint32_t parameters_check_word,
                      rsi::LearntLoad& learnt) noexcept {
    const bool good = (word_in(record, 0U) == record_magic) &&
                      (word_in(record, parameters_at) == parameters_check_word) &&
                      (word_in(record, record_checksum_at) == crc32(record.data(), record_checksum_at));
    if (good) {
        learnt =
            rsi::LearntLoad{value_of(word_in(record, excess_at)), value_of(word_in(record, deviation_at)),
                            value_of(word_in(record, offset_at))};
    }
    return good;
}

}  // namespace application
