// Unified diagnostic services: the words of ISO 14229-1 that this server knows.
#pragma once

#include <cstdint>

namespace rsi::diagnosis {

enum class Session : std::uint8_t { standard = 1U, programming = 2U, extended = 3U };

enum class Nrc : std::uint8_t {
    none = 0x00U,  // a positive response
    service_not_supported = 0x11U,
    sub_function_not_supported = 0x12U,
    incorrect_length = 0x13U,
    response_too_long = 0x14U,
    conditions_not_correct = 0x22U,
    request_sequence_error = 0x24U,
    request_out_of_range = 0x31U,
    security_access_denied = 0x33U,
    invalid_key = 0x35U,
    exceeded_attempts = 0x36U,
    time_delay_not_expired = 0x37U,
    download_not_accepted = 0x70U,
    transfer_suspended = 0x71U,
    programming_failure = 0x72U,
    wrong_block_counter = 0x73U,
    response_pending = 0x78U,
    service_not_in_session = 0x7FU,
};

}  // namespace rsi::diagnosis
