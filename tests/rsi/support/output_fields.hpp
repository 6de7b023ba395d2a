// The numbers of the outputs by name, and comparisons over all of them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "rsi/output_table.hpp"

namespace rsi_test {

inline std::uint32_t bits_of(float value) {
    std::uint32_t bits = 0U;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
}

inline bool all_finite(const rsi_outputs& outputs) {
    for (const rsi::NumberOutput& field : rsi::number_outputs) {
        if (field.presence != rsi::Presence::sometimes && !std::isfinite(outputs.*field.member)) {
            return false;
        }
    }
    return true;
}

inline bool all_not_available(const rsi_outputs& outputs) {
    for (const rsi::NumberOutput& field : rsi::number_outputs) {
        if (!std::isnan(outputs.*field.member)) {
            return false;
        }
    }
    return true;
}

// The same state and the same bits.
inline ::testing::AssertionResult identical(const rsi_outputs& a, const rsi_outputs& b) {
    for (const rsi::CodeOutput& code : rsi::code_outputs) {
        if (a.*code.member != b.*code.member) {
            return ::testing::AssertionFailure()
                   << code.name << ": " << a.*code.member << " against " << b.*code.member;
        }
    }
    for (const rsi::NumberOutput& field : rsi::number_outputs) {
        if (bits_of(a.*field.member) != bits_of(b.*field.member)) {
            return ::testing::AssertionFailure()
                   << field.name << ": " << a.*field.member << " against " << b.*field.member;
        }
    }
    return ::testing::AssertionSuccess();
}

}  // namespace rsi_test
