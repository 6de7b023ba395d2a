// Takes values out of the bytes that libFuzzer gives, front to back, so that an inserted or copied byte moves
// the rest as it moves the steps of a sequence. Beyond the end everything is zero.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace fuzz {

class ByteReader {
 public:
    ByteReader(const std::uint8_t* bytes, std::size_t size) : bytes_{bytes}, left_{size} {}

    bool empty() const { return left_ == 0U; }

    // An arithmetic type from its bytes, whatever they are; not for bool.
    template <typename Value>
    Value take() {
        Value value{};
        take_into(&value, sizeof value);
        return value;
    }

    // From 0 to `limit` - 1, at most 256 of them.
    unsigned below(unsigned limit) { return take<std::uint8_t>() % limit; }

    bool one_in(unsigned count) { return below(count) == 1U; }

    void take_into(void* target, std::size_t size) {
        const std::size_t count = std::min(size, left_);
        if (count != 0U) {
            std::memcpy(target, bytes_, count);
            bytes_ += count;
            left_ -= count;
        }
    }

 private:
    const std::uint8_t* bytes_;
    std::size_t left_;
};

}  // namespace fuzz
