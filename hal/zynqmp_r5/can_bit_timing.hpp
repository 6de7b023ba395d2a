// Bit timing of the CAN controller, computed at compile time from its clock (ISO 11898-1, clause 11.3).
#pragma once

#include <cstdint>

namespace rsi::hal::zynqmp_r5 {

// As the registers hold it: each number is one less than what it stands for.
struct CanBitTiming {
    std::uint32_t prescaler_register{0U};
    std::uint32_t timing_register{0U};
};

// One bit is a synchronisation quantum, `before_sample` quanta, the sample point, and `after_sample` quanta.
struct CanBitSegments {
    std::uint32_t prescaler{1U};      // clock periods of a quantum, 1 to 256
    std::uint32_t before_sample{1U};  // 1 to 16
    std::uint32_t after_sample{1U};   // 1 to 8
    std::uint32_t jump_width{1U};     // quanta by which a bit may be moved to follow an edge, 1 to 4

    constexpr std::uint32_t quanta() const { return 1U + before_sample + after_sample; }
    // In thousandths of the bit.
    constexpr std::uint32_t sample_point_permille() const {
        return (1000U * (1U + before_sample)) / quanta();
    }
    constexpr std::uint32_t bit_rate(std::uint32_t clock_hz) const {
        return clock_hz / (prescaler * quanta());
    }
    constexpr CanBitTiming registers() const {
        return CanBitTiming{prescaler - 1U,
                            ((jump_width - 1U) << 7U) | ((after_sample - 1U) << 4U) | (before_sample - 1U)};
    }
};

// 87.5 % is what CiA 301 recommends.
inline constexpr std::uint32_t wanted_sample_point_permille{875U};

// The segments whose bit rate is exact and whose sample point is nearest to the wanted one, of 16 to 25
// quanta: enough of them to place the sample point well. A prescaler of 0 means that the clock gives no such
// bit rate.
constexpr CanBitSegments can_bit_segments(std::uint32_t clock_hz, std::uint32_t bit_rate) {
    CanBitSegments best{0U, 1U, 1U, 1U};
    std::uint32_t smallest_deviation = 1000U;
    for (std::uint32_t quanta = 25U; quanta >= 16U; --quanta) {
        const std::uint32_t prescaler = clock_hz / (bit_rate * quanta);
        if (prescaler < 1U || prescaler > 256U || prescaler * bit_rate * quanta != clock_hz) {
            continue;
        }
        for (std::uint32_t after = 2U; after <= 8U; ++after) {
            const std::uint32_t before = quanta - 1U - after;
            if (before > 16U) {
                continue;
            }
            const CanBitSegments segments{prescaler, before, after, after < 4U ? after : 4U};
            const std::uint32_t point = segments.sample_point_permille();
            const std::uint32_t deviation = point > wanted_sample_point_permille
                                                ? point - wanted_sample_point_permille
                                                : wanted_sample_point_permille - point;
            if (deviation < smallest_deviation) {
                smallest_deviation = deviation;
                best = segments;
            }
        }
    }
    return best;
}

// The registers for one of the four usual bit rates; refused by the compiler when the clock does not give it
// exactly with a sample point of 80 to 90 %.
template <std::uint32_t clock_hz, std::uint32_t bit_rate>
constexpr CanBitTiming can_bit_timing() {
    static_assert(
        bit_rate == 125'000U || bit_rate == 250'000U || bit_rate == 500'000U || bit_rate == 1'000'000U,
        "the bit rate is none of 125, 250, 500 and 1000 kbit/s");
    constexpr CanBitSegments segments = can_bit_segments(clock_hz, bit_rate);
    static_assert(segments.prescaler != 0U, "the CAN clock gives no exact bit timing for this bit rate");
    static_assert(segments.prescaler == 0U || segments.bit_rate(clock_hz) == bit_rate);
    static_assert(segments.sample_point_permille() >= 800U && segments.sample_point_permille() <= 900U,
                  "the sample point is not within 80 and 90 %");
    return segments.registers();
}

}  // namespace rsi::hal::zynqmp_r5
