// The outcome of an end-to-end check of one cycle, in AUTOSAR's terms; the same for every profile.
#pragma once

#include <cstdint>

namespace rsi::can_dbc::e2e {

enum class CheckStatus : std::uint8_t {
    ok,              // the next frame in sequence, or the first one
    ok_some_lost,    // in sequence after a tolerated number of lost frames
    repeated,        // the same counter as before
    wrong_sequence,  // more frames lost than tolerated, or frames out of order
    error,           // the frame is damaged or is not the expected one
    no_new_data,     // no frame arrived
};

enum class CheckError : std::uint8_t {
    none,
    length,
    crc,      // damaged, or sent with another data identifier
    data_id,  // the transmitted part of the data identifier is another one
    counter,  // a counter value that no sender may use
};

struct CheckResult {
    CheckStatus status{CheckStatus::no_new_data};
    CheckError error{CheckError::none};  // other than none only when status is error
    std::uint8_t lost_frames{0U};  // counted modulo the counter's range; when ok_some_lost or wrong_sequence
};

// Whether the frame's signals may be used.
constexpr bool is_usable(CheckStatus status) {
    return status == CheckStatus::ok || status == CheckStatus::ok_some_lost;
}

}  // namespace rsi::can_dbc::e2e
