// Parameter guard: checks the parameters in RAM by a checksum, a quarter of them in each cycle.
#pragma once

#include <cstddef>
#include <utility>

#include "rsi/ecu/monitoring/memory_word.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

// Fletcher checksum: the second sum depends on the order, so it detects exchanged words too. A pass takes
// five cycles, so a change is detected after at most 90 ms.
class ParameterGuard {
 public:
    // Takes these parameters as the reference.
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
        // Keeps the index in range even if its memory is damaged; the sum is then wrong, which is detected.
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

    static constexpr std::size_t slice_count = 5U;
    static constexpr std::size_t word_count = sizeof(rsi::Parameters) / sizeof(MemoryWord);
    static constexpr std::size_t words_of_slice = word_count / slice_count;
    static_assert(sizeof(rsi::Parameters) % (slice_count * sizeof(MemoryWord)) == 0U,
                  "the guard takes whole words, as many in each cycle");

    static void add(const rsi::Parameters& parameters, std::size_t slice, Sums& sums) noexcept {
        const auto* const bytes = static_cast<const unsigned char*>(static_cast<const void*>(&parameters));
        add_each(bytes + slice * words_of_slice * sizeof(MemoryWord), sums,
                 std::make_index_sequence<words_of_slice>{});
    }

    // Unrolled, because the overhead of a loop would double the run time.
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
