// Memory storage: a record that outlives the object that wrote it, though not the process; for tests and
// simulation.
#pragma once

#include <algorithm>
#include <array>

#include "rsi/hal/storage.hpp"

namespace rsi::hal {

template <std::size_t capacity>
class MemoryStorage final : public Storage {
 public:
    Reading read(std::uint8_t* bytes, std::size_t length) noexcept override {
        if (length_ == 0U) {
            return Reading::never_written;
        }
        if (length != length_) {
            return Reading::unreadable;
        }
        std::copy_n(bytes_.begin(), length, bytes);
        return Reading::stored;
    }

    bool write(const std::uint8_t* bytes, std::size_t length) noexcept override {
        if (is_busy_ || (length > capacity)) {
            return false;
        }
        std::copy_n(bytes, length, bytes_.begin());
        length_ = length;
        ++writes_;
        return true;
    }

    // Takes no record while it is.
    void set_busy(bool is_busy) noexcept { is_busy_ = is_busy; }

    // As a worn cell would: the first bit of the byte turned over.
    void damage(std::size_t byte) noexcept { bytes_.at(byte) ^= 1U; }

    unsigned writes() const noexcept { return writes_; }

 private:
    std::array<std::uint8_t, capacity> bytes_{};
    std::size_t length_{0U};  // of the record, 0 before the first
    bool is_busy_{false};
    unsigned writes_{0U};
};

}  // namespace rsi::hal
