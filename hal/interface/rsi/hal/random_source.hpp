// Random source: numbers that cannot be predicted from outside, for seeds.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rsi::hal {

class RandomSource {
 public:
    RandomSource(const RandomSource&) = delete;
    RandomSource& operator=(const RandomSource&) = delete;

    // Called within a cycle, so it returns at once. Fills `bytes` from a source fit for cryptography; false
    // where there are none at present, and then `bytes` means nothing.
    virtual bool fill(std::uint8_t* bytes, std::size_t length) noexcept = 0;

 protected:
    RandomSource() = default;
    ~RandomSource() = default;
};

}  // namespace rsi::hal
