// Retained record: a storage in memory that no start clears. It outlives a reset, and no loss of power: a
// product has EEPROM or flash.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/hal/storage.hpp"

namespace rsi::hal {

// Nothing initialises it; at power-on it holds zeros, or anything. Only zeros are known to be a new one.
template <std::size_t capacity>
struct RetainedMemory {
    std::uint32_t length;
    std::uint32_t inverted_length;
    std::array<std::uint8_t, capacity> bytes;
};

template <std::size_t capacity>
class RetainedRecord final : public Storage {
 public:
    // `memory` must outlive this object, which owns it exclusively.
    explicit RetainedRecord(RetainedMemory<capacity>& memory) noexcept : memory_{memory} {}

    Reading read(std::uint8_t* bytes, std::size_t length) noexcept override {
        if ((memory_.length == 0U) && (memory_.inverted_length == 0U)) {
            return Reading::never_written;
        }
        const bool is_there = (memory_.inverted_length == ~memory_.length) && (memory_.length == length);
        if (!is_there || (length > capacity)) {
            return Reading::unreadable;
        }
        std::copy_n(memory_.bytes.begin(), length, bytes);
        return Reading::stored;
    }

    bool write(const std::uint8_t* bytes, std::size_t length) noexcept override {
        if (length > capacity) {
            return false;
        }
        std::copy_n(bytes, length, memory_.bytes.begin());
        memory_.length = static_cast<std::uint32_t>(length);
        memory_.inverted_length = ~memory_.length;
        return true;
    }

 private:
    RetainedMemory<capacity>& memory_;
};

}  // namespace rsi::hal
