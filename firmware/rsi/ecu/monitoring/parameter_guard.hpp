// Parameter guard: a check word over the parameters in memory, computed anew a slice a cycle.
#pragma once

#include <cstddef>
#include <utility>

#include "rsi/ecu/monitoring/memory_word.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// Two sums, as Fletcher's: the second weighs each word by its place, so any one changed bit shows, and two
// that were exchanged show. A pass takes four cycles; a change is seen in the cycle that ends the pass after
// it, 30 to 70 ms later.
class ParameterGuard {
 public:
    // Takes these parameters as right from now on.
    void start(const rsi::Parameters& parameters) noexcept {
        expected_ = Sums{};
        for (std::size_t slice = 0U; slice < slice_count; ++slice) {
            add(parameters, slice, expected_);
        }
        sums_ = Sums{};
        next_ = 0U;
        damaged_ = false;
    }

    // One cycle; true from the first pass that found a change.
    bool is_damaged(const rsi::Parameters& parameters) noexcept {
        // A number that memory has changed makes a wrong sum, and no more.
        const std::size_t slice = (next_ < slice_count) ? next_ : 0U;
        add(parameters, slice, sums_);
        next_ = slice + 1U;
        if (next_ == slice_count) {
            damaged_ = damaged_ || (sums_.plain != expected_.plain) || (sums_.weighted != expected_.weighted);
            sums_ = Sums{};
            next_ = 0U;
        }
        return damaged_;
    }

 private:
    struct Sums {
        MemoryWord plain{0U};
        MemoryWord weighted{0U};
    };

    static constexpr std::size_t slice_count = 4U;
    static constexpr std::size_t word_count = sizeof(rsi::Parameters) / sizeof(MemoryWord);
    static constexpr std::size_t words_of_slice = word_count / slice_count;
    static_assert(sizeof(rsi::Parameters) % (slice_count * sizeof(MemoryWord)) == 0U,
                  "the guard takes whole words, as many in each cycle");

    static void add(const rsi::Parameters& parameters, std::size_t slice, Sums& sums) noexcept {
        const auto* const bytes = static_cast<const unsigned char*>(static_cast<const void*>(&parameters));
        add_each(bytes + slice * words_of_slice * sizeof(MemoryWord), sums,
                 std::make_index_sequence<words_of_slice>{});
    }

    // Without a loop, which would be half of the work.
    template <std::size_t... index>
    static void add_each(const unsigned char* bytes, Sums& sums, std::index_sequence<index...>) noexcept {
        Sums now = sums;
        (add_word(bytes + index * sizeof(MemoryWord), now), ...);
        sums = now;
    }

    static void add_word(const unsigned char* bytes, Sums& sums) noexcept {
        sums.plain += memory_word_at(bytes);
        sums.weighted += sums.plain;
    }

    Sums expected_{};
    Sums sums_{};
    std::size_t next_{0U};
    bool damaged_{false};
};

}  // namespace rsi::monitoring
