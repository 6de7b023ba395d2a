// Signals that carry an integer, a flag or an enumeration: the same number on our side and on the bus.
#pragma once

#include <cstdint>

#include "rsi/can_dbc/codec/bit_field.hpp"
#include "rsi/can_dbc/codec/signal_status.hpp"

namespace rsi::can_dbc {

struct IntegerSignal {
    BitField field;
    std::int64_t minimum;
    std::int64_t maximum;
    std::int64_t start_value;
};

// An enumeration with an enumerator `not_available` has its number in `not_available`.
struct EnumerationSignal {
    BitField field;
    std::int64_t start_value;
    bool has_not_available;
    std::int64_t not_available;
};

// Saturates to the signal's range. `Integer` is bool or an integer of up to 32 bits.
template <typename Integer>
[[gnu::always_inline]] constexpr void write_signal(const IntegerSignal& signal, Integer value,
                                                   std::uint8_t* payload) {
    const auto wide = static_cast<std::int64_t>(value);
    const std::int64_t floored = wide < signal.minimum ? signal.minimum : wide;
    write_bits(signal.field, floored > signal.maximum ? signal.maximum : floored, payload);
}

// `value` is the start value unless the status is valid.
template <typename Integer>
[[gnu::always_inline]] constexpr void read_signal(const IntegerSignal& signal, const std::uint8_t* payload,
                                                  Integer& value, SignalStatus& status) {
    const std::int64_t raw = read_bits(signal.field, payload);
    const bool in_range = raw >= signal.minimum && raw <= signal.maximum;
    status = in_range ? SignalStatus::valid : SignalStatus::out_of_range;
    value = static_cast<Integer>(in_range ? raw : signal.start_value);
}

// A value that is no enumerator is sent as the start value.
template <typename Enumeration>
[[gnu::always_inline]] constexpr void write_enumeration(const EnumerationSignal& signal,
                                                        bool (*is_known)(Enumeration), Enumeration value,
                                                        std::uint8_t* payload) {
    write_bits(signal.field, is_known(value) ? static_cast<std::int64_t>(value) : signal.start_value,
               payload);
}

// `value` is the start value when the status is out_of_range.
template <typename Enumeration>
[[gnu::always_inline]] constexpr void read_enumeration(const EnumerationSignal& signal,
                                                       bool (*is_known)(Enumeration),
                                                       const std::uint8_t* payload, Enumeration& value,
                                                       SignalStatus& status) {
    const std::int64_t raw = read_bits(signal.field, payload);
    value = static_cast<Enumeration>(raw);
    if (!is_known(value)) {
        value = static_cast<Enumeration>(signal.start_value);
        status = SignalStatus::out_of_range;
    } else if (signal.has_not_available && raw == signal.not_available) {
        status = SignalStatus::not_available;
    } else {
        status = SignalStatus::valid;
    }
}

}  // namespace rsi::can_dbc
