// Signals that carry a physical value: float on our side, a scaled integer on the bus.
#pragma once

#include <cstdint>

#include "rsi/can_dbc/codec/bit_field.hpp"
#include "rsi/can_dbc/codec/signal_status.hpp"

namespace rsi::can_dbc {

// value = (raw * numerator + shift) / denominator, which is the DBC file's raw * factor + offset. With these
// three exact in float, a raw value of up to 24 bits decodes to the float nearest to the decimal value, and a
// compiler that fuses multiplication and addition gives the same bits. If the DBC file's factor is no such
// fraction, the denominator is 1 and the others are rounded.
//
// `Raw` is std::int32_t for fields of up to 24 bits, else std::int64_t, so that no conversion can overflow.
template <typename Raw>
struct PhysicalSignal {
    BitField field;
    float numerator;
    float shift;
    float denominator;
    float minimum;
    float maximum;
    Raw raw_at_minimum;  // the outermost codes within [minimum, maximum]; with a negative factor the first is
    Raw raw_at_maximum;  // the larger
    Raw raw_for_nan;     // the "not available" code, or the start value of a signal that has no such code
    bool has_not_available;
};

// The nearest integer; halves go away from zero. `value` must lie within Raw.
template <typename Raw>
constexpr Raw round_half_away_from_zero(float value) {
    const auto whole = static_cast<Raw>(value);            // towards zero
    const float rest = value - static_cast<float>(whole);  // exact
    if (rest >= 0.5F) {
        return whole + 1;
    }
    return rest <= -0.5F ? whole - 1 : whole;
}

// The code of any float: rounded, saturated to the signal's range; NaN gives `raw_for_nan`.
template <typename Raw>
constexpr Raw raw_from_physical(const PhysicalSignal<Raw>& signal, float value) {
    if (value != value) {
        return signal.raw_for_nan;
    }
    if (value <= signal.minimum) {
        return signal.raw_at_minimum;
    }
    if (value >= signal.maximum) {
        return signal.raw_at_maximum;
    }
    const float scaled = (value * signal.denominator - signal.shift) / signal.numerator;
    const auto raw = round_half_away_from_zero<Raw>(scaled);
    const bool rising = signal.raw_at_minimum <= signal.raw_at_maximum;
    const Raw lowest = rising ? signal.raw_at_minimum : signal.raw_at_maximum;
    const Raw highest = rising ? signal.raw_at_maximum : signal.raw_at_minimum;
    if (raw < lowest) {
        return lowest;
    }
    return raw > highest ? highest : raw;
}

template <typename Raw>
constexpr SignalStatus status_of_raw(const PhysicalSignal<Raw>& signal, Raw raw) {
    if (signal.has_not_available && raw == signal.raw_for_nan) {
        return SignalStatus::not_available;
    }
    const bool rising = signal.raw_at_minimum <= signal.raw_at_maximum;
    const Raw lowest = rising ? signal.raw_at_minimum : signal.raw_at_maximum;
    const Raw highest = rising ? signal.raw_at_maximum : signal.raw_at_minimum;
    return raw < lowest || raw > highest ? SignalStatus::out_of_range : SignalStatus::valid;
}

template <typename Raw>
constexpr float physical_from_raw(const PhysicalSignal<Raw>& signal, Raw raw) {
    return (static_cast<float>(raw) * signal.numerator + signal.shift) / signal.denominator;
}

template <typename Raw>
[[gnu::always_inline]] constexpr void write_signal(const PhysicalSignal<Raw>& signal, float value,
                                                   std::uint8_t* payload) {
    write_bits(signal.field, raw_from_physical(signal, value), payload);
}

// `value` is NaN unless the status is valid, so that it cannot be used by oversight.
template <typename Raw>
[[gnu::always_inline]] constexpr void read_signal(const PhysicalSignal<Raw>& signal,
                                                  const std::uint8_t* payload, float& value,
                                                  SignalStatus& status) {
    const auto raw = static_cast<Raw>(read_bits(signal.field, payload));
    status = status_of_raw(signal, raw);
    value = status == SignalStatus::valid ? physical_from_raw(signal, raw) : not_available;
}

}  // namespace rsi::can_dbc
