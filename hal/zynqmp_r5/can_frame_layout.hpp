// How a CAN frame lies in the controller's FIFO: four words.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/hal/can_bus.hpp"

namespace rsi::hal::zynqmp_r5 {

using CanFrameWords = std::array<std::uint32_t, 4>;

// Standard identifiers that agree with this one in the bits of the mask, from 0 to 0x7FF both.
struct CanAcceptance {
    std::uint32_t identifier{0U};
    std::uint32_t mask{0x7FFU};
};

// As narrow as one acceptance can be that lets all of these through; others may come with them.
template <std::size_t count>
constexpr CanAcceptance accepting(const std::array<std::uint32_t, count>& identifiers) {
    std::uint32_t differing = 0U;
    for (const std::uint32_t each : identifiers) {
        differing |= each ^ identifiers[0];
    }
    return CanAcceptance{identifiers[0], 0x7FFU & ~differing};
}

// Content of two registers of the controller.
struct CanFilter {
    std::uint32_t mask{0U};
    std::uint32_t identifier{0U};
};

namespace detail {

inline constexpr std::uint32_t length_shift{28U};

// `most_significant_first`: the first byte of each four is in bits 31 to 24.
constexpr std::uint32_t byte_shift(std::size_t byte, bool most_significant_first) {
    const auto place = static_cast<std::uint32_t>(byte % 4U);
    return 8U * (most_significant_first ? 3U - place : place);
}

constexpr CanFrameWords pack(std::uint32_t identifier_word, const CanFrame& frame,
                             bool most_significant_first) {
    CanFrameWords words{identifier_word, static_cast<std::uint32_t>(frame.length) << length_shift, 0U, 0U};
    for (std::size_t byte = 0U; byte < 8U && byte < frame.length; ++byte) {
        words[2U + byte / 4U] |= static_cast<std::uint32_t>(frame.data[byte])
                                 << byte_shift(byte, most_significant_first);
    }
    return words;
}

// Length and data alone. A length code above 8 stands for 8 (ISO 11898-1).
constexpr void unpack(const CanFrameWords& words, CanFrame& frame, bool most_significant_first) {
    const std::uint32_t code = words[1] >> length_shift;
    frame.length = static_cast<std::uint8_t>(code < 8U ? code : 8U);
    for (std::size_t byte = 0U; byte < frame.length; ++byte) {
        frame.data[byte] = static_cast<std::uint8_t>(
            (words[2U + byte / 4U] >> byte_shift(byte, most_significant_first)) & 0xFFU);
    }
}

}  // namespace detail

// UG1087, TXFIFO_ID and RXFIFO_ID: identifier bits 28 to 18 (standard: 10 to 0) in 31 to 21, substitute
// remote request in 20, extension in 19, identifier bits 17 to 0 in 18 to 1, remote request in 0. Data: first
// byte in bits 31 to 24.
struct SiliconCanFrameLayout {
    static constexpr CanFrameWords pack(const CanFrame& frame) {
        return detail::pack(identifier_word(frame), frame, true);
    }
    // False for what is no data frame.
    static constexpr bool unpack(const CanFrameWords& words, CanFrame& frame) {
        const std::uint32_t word = words[0];
        frame.extended = (word & extension) != 0U;
        const std::uint32_t upper = word >> 21U;
        frame.identifier = frame.extended ? (upper << 18U) | ((word >> 1U) & 0x3'FFFFU) : upper;
        detail::unpack(words, frame, true);
        return (word & (frame.extended ? remote_request : substitute_remote_request)) == 0U;
    }
    // Lets data frames with these standard identifiers through and nothing else.
    static constexpr CanFilter filter(const CanAcceptance& accepted) {
        return CanFilter{(accepted.mask << 21U) | substitute_remote_request | extension,
                         accepted.identifier << 21U};
    }

 private:
    static constexpr std::uint32_t substitute_remote_request{1U << 20U};
    static constexpr std::uint32_t extension{1U << 19U};
    static constexpr std::uint32_t remote_request{1U << 0U};

    static constexpr std::uint32_t identifier_word(const CanFrame& frame) {
        return frame.extended ? ((frame.identifier >> 18U) << 21U) | substitute_remote_request | extension |
                                    ((frame.identifier & 0x3'FFFFU) << 1U)
                              : frame.identifier << 21U;
    }
};

}  // namespace rsi::hal::zynqmp_r5
