#include "rsi/ecu/diagnosis/section_download.hpp"

namespace rsi::diagnosis {
namespace {

constexpr std::uint8_t neither_compressed_nor_encrypted = 0x00U;
constexpr std::size_t formats_length = 3U;  // service, format of the data, format of address and length
constexpr std::size_t block_header = 2U;

// Number of up to four bytes.
std::uint32_t number_at(const Request& request, std::size_t place, std::size_t count) {
    std::uint32_t number = 0U;
    for (std::size_t index = 0U; index < count; ++index) {
        number = (number << 8U) | request.byte(place + index);
    }
    return number;
}

bool is_width(std::size_t bytes) {
    return (bytes >= 1U) && (bytes <= 4U);
}

}  // namespace

// The section is at address 0 of a memory that has nothing else.
// A request that is repeated before the first block begins anew: its answer was lost. Later the transfer has
// to be ended first, by a change of the session if not otherwise.
Nrc SectionDownload::begin(const Request& request, bool is_unlocked, bool is_allowed,
                           Response& response) noexcept {
    if (request.length() < formats_length) {
        return Nrc::incorrect_length;
    }
    const std::size_t address_width = request.byte(2U) & 0x0FU;
    const std::size_t length_width = static_cast<std::size_t>(request.byte(2U)) >> 4U;
    if ((request.byte(1U) != neither_compressed_nor_encrypted) || !is_width(address_width) ||
        !is_width(length_width)) {
        return Nrc::request_out_of_range;
    }
    if (request.length() != formats_length + address_width + length_width) {
        return Nrc::incorrect_length;
    }
    if (target_ == nullptr) {
        return is_unlocked ? Nrc::download_not_accepted : Nrc::security_access_denied;
    }
    const std::uint32_t address = number_at(request, formats_length, address_width);
    const std::uint32_t length = number_at(request, formats_length + address_width, length_width);
    if ((address != 0U) || (length != target_->length())) {
        return Nrc::request_out_of_range;
    }
    if (!is_unlocked) {
        return Nrc::security_access_denied;
    }
    const bool is_busy = (state_ == State::transferring) && (received_ != 0U);
    if (!is_allowed || is_busy) {
        return Nrc::conditions_not_correct;
    }
    state_ = State::transferring;
    received_ = 0U;
    next_block_ = 1U;
    response.put(0x20U);  // two bytes of length
    response.put_u16(static_cast<std::uint32_t>(longest_block));
    return Nrc::none;
}

Nrc SectionDownload::transfer(const Request& request, Response& response) noexcept {
    if (request.length() < block_header) {
        return Nrc::incorrect_length;
    }
    if (state_ != State::transferring) {
        return Nrc::request_sequence_error;
    }
    const std::uint8_t block = request.byte(1U);
    const bool is_repeated = (received_ != 0U) && (block == static_cast<std::uint8_t>(next_block_ - 1U));
    const Nrc answer = is_repeated ? Nrc::none : take_block(request);  // its answer was lost: once is enough
    response.put(block);
    return answer;
}

Nrc SectionDownload::take_block(const Request& request) noexcept {
    const std::size_t count = request.length() - block_header;
    if (request.byte(1U) != next_block_) {
        return Nrc::wrong_block_counter;
    }
    if (count == 0U) {
        return Nrc::incorrect_length;
    }
    if (count > target_->length() - received_) {
        return Nrc::transfer_suspended;
    }
    for (std::size_t index = 0U; index < count; ++index) {
        target_->put(received_ + index, request.byte(block_header + index));
    }
    received_ += count;
    next_block_ = static_cast<std::uint8_t>(next_block_ + 1U);
    return Nrc::none;
}

Nrc SectionDownload::end(const Request& request) noexcept {
    if (request.length() != 1U) {
        return Nrc::incorrect_length;
    }
    if ((state_ != State::transferring) || (received_ != target_->length())) {
        return Nrc::request_sequence_error;
    }
    state_ = State::complete;
    return Nrc::none;
}

Nrc SectionDownload::check_and_store(std::uint8_t& refusal) noexcept {
    if (state_ != State::complete) {
        return Nrc::request_sequence_error;
    }
    refusal = 0U;
    const SectionAnswer answer = target_->store(refusal);
    is_memory_failing_ = target_->is_failing();
    if (answer == SectionAnswer::busy) {
        return Nrc::response_pending;
    }
    state_ = State::idle;
    return Nrc::none;
}

}  // namespace rsi::diagnosis
