// A storage whose power is cut at a chosen write, which may then be done, not be done, or be torn.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rsi/hal/storage.hpp"

namespace rsi_test {

namespace hal = rsi::hal;

class CutStorage final : public rsi::hal::Storage {
 public:
    // Content left by the write at which power goes: that many of its bytes, and behind them those of before.
    struct Cut {
        int at_write;  // counted from 1; 0: never
        std::size_t bytes_written;
    };

    // An empty record is one that was never written.
    hal::Reading read(std::uint8_t* bytes, std::size_t length) noexcept override {
        ++reads_;
        if (is_unreadable_ || (record_.size() != length && !record_.empty())) {
            return hal::Reading::unreadable;
        }
        std::copy(record_.begin(), record_.end(), bytes);
        return record_.empty() ? hal::Reading::never_written : hal::Reading::stored;
    }

    bool write(const std::uint8_t* bytes, std::size_t length) noexcept override {
        ++tries_;
        if (refuses_) {
            return false;
        }
        ++writes_;
        if (writes_ != cut_.at_write) {
            record_.assign(bytes, bytes + length);
            return true;
        }
        has_power_ = false;
        if (cut_.bytes_written > 0U) {
            record_.resize(length);
            std::copy_n(bytes, std::min(length, cut_.bytes_written), record_.begin());
        }
        return true;
    }

    void cut_power_at(Cut cut) {
        cut_ = cut;
        writes_ = 0;
        has_power_ = true;
    }
    void refuse(bool refuses) { refuses_ = refuses; }
    void set_unreadable(bool is_unreadable) { is_unreadable_ = is_unreadable; }
    int reads() const { return reads_; }
    // Times that it was asked to take a record, whether it has or not.
    int tries() const { return tries_; }
    bool has_power() const { return has_power_; }
    int writes() const { return writes_; }
    std::vector<std::uint8_t>& record() { return record_; }

 private:
    std::vector<std::uint8_t> record_;
    Cut cut_{0, 0U};
    int writes_{0};
    bool has_power_{true};
    bool refuses_{false};
    bool is_unreadable_{false};
    int reads_{0};
    int tries_{0};
};

}  // namespace rsi_test
