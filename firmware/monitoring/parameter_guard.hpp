// Parameter guard: a check word over the parameters in memory, computed anew a slice a cycle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "rsi/types.hpp"

namespace monitoring {

// Two sums, as Fletcher's: the second weighs each word by its place, so any one changed bit shows, and two
// that were exchanged show. A pass takes four cycles; a change is seen in the cycle that ends the pass after
// it, 30 to 70 ms later.
class ParameterGuard {
 public:
    // What the parameters are from now on.
    void start(const rsi::Parameters& parameters) noexcept {
        expected_ = Sums{};
        add(parameters, 0U, word_count, expected_);
        sums_ = Sums{};
        next_ = 0U;
        damaged_ = false;
    }

    // One cycle; true from the first pass that found a change.
    bool is_damaged(const rsi::Parameters& parameters) noexcept {
        const std::size_t end = (next_ + slice < word_count) ? next_ + slice : word_count;
        add(parameters, next_, end, sums_);
        next_ = end;
        if (next_ == word_count) {
            damaged_ = damaged_ || (sums_.plain != expected_.plain) || (sums_.weighted != expected_.weighted);
            sums_ = Sums{};
            next_ = 0U;
        }
        return damaged_;
    }

 private:
    struct Sums {
        std::uint32_t plain{0U};
        std::uint32_t weighted{0U};
    };

    static constexpr std::size_t word_count = sizeof(rsi::Parameters) / sizeof(std::uint32_t);
    static constexpr std::size_t slice = (word_count + 3U) / 4U;
    static_assert(sizeof(rsi::Parameters) % sizeof(std::uint32_t) == 0U, "the guard takes whole words");

    static void add(const rsi::Parameters& parameters, std::size_t begin, std::size_t end,
                    Sums& sums) noexcept {
        std::array<std::uint32_t, word_count> words{};
        std::memcpy(words.data(), &parameters, sizeof(words));
        for (std::size_t word = begin; word < end; ++word) {
            sums.plain += words[word];
            sums.weighted += sums.plain;
        }
    }

    Sums expected_{};
    Sums sums_{};
    std::size_t next_{0U};
    bool damaged_{false};
};

}  // namespace monitoring
