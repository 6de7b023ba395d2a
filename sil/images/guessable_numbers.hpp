// Guessable numbers: what a bench has in place of a random source, where neither the emulated machine nor the
// silicon has a generator that this project drives. Fit for no product.
#pragma once

#include "hal/interface/clock.hpp"
#include "hal/interface/random_source.hpp"

namespace sil {

// They follow from the moments at which they were asked for, in counts of the free-running timer: other seeds
// each time, which a listener on the bus finds by trying.
class GuessableNumbers final : public hal::RandomSource {
 public:
    // `clock` must outlive this object.
    explicit GuessableNumbers(const hal::Clock& clock) noexcept : clock_{clock} {}

    bool fill(std::uint8_t* bytes, std::size_t length) noexcept override {
        state_ ^= static_cast<std::uint32_t>(clock_.now().nanoseconds);
        for (std::size_t place = 0U; place < length; ++place) {
            state_ =
                state_ * 1664525U + 1013904223U;  // of Numerical Recipes; its upper bits are the better ones
            bytes[place] = static_cast<std::uint8_t>(state_ >> 24U);
        }
        return true;
    }

 private:
    const hal::Clock& clock_;
    std::uint32_t state_{0U};
};

}  // namespace sil
