// Memory guard: detects bit errors in an object by a sum, and restores it from a copy.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "rsi/ecu/monitoring/memory_word.hpp"

namespace rsi::monitoring {

// The sum over all words of the object detects any single bit error, and covers every member, whatever is
// added.
template <typename Object>
class MemoryGuard {
 public:
    explicit MemoryGuard(const Object& object) noexcept { keep(object); }

    // Saves the object's content as the reference. Call it after each intended change.
    void keep(const Object& object) noexcept {
        copy(bytes_of(object), bytes_of(kept_));
        sum_ = sum_of(object);
    }

    // Call it before each use. True when object or sum have changed since keep(); the object is then
    // restored.
    bool restore(Object& object) noexcept {
        const bool changed = (sum_of(object) != sum_);
        is_failing_ = changed && restored_;
        restored_ = changed;
        if (changed) {
            copy(bytes_of(kept_), bytes_of(object));
        }
        return changed;
    }

    // Two consecutive calls had to restore the object: a permanent fault of the memory.
    bool is_failing() const noexcept { return is_failing_; }

 private:
    using Word = MemoryWord;
    using Bytes = std::array<unsigned char, sizeof(Object)>;

    static_assert(std::is_trivially_destructible_v<Object>, "it owns nothing: its bytes are all of it");
    static_assert(sizeof(Object) % sizeof(Word) == 0U, "the guard takes whole words");
    static_assert(alignof(Object) % alignof(Word) == 0U);

    // Bytes. Unrolled, because the overhead of a loop over words would double the run time.
    static constexpr std::size_t copied_at_once = 64U;
    static constexpr std::size_t summed_at_once = 128U;

    template <typename Type>
    static unsigned char* bytes_of(Type& object) noexcept {
        return static_cast<unsigned char*>(
            __builtin_assume_aligned(static_cast<void*>(&object), alignof(Word)));
    }
    template <typename Type>
    static const unsigned char* bytes_of(const Type& object) noexcept {
        return static_cast<const unsigned char*>(
            __builtin_assume_aligned(static_cast<const void*>(&object), alignof(Word)));
    }

    static void copy(const unsigned char* from, unsigned char* to) noexcept {
        constexpr std::size_t rest = sizeof(Object) % copied_at_once;
        constexpr std::size_t in_blocks = sizeof(Object) - rest;
        for (std::size_t at = 0U; at < in_blocks; at += copied_at_once) {
            std::memcpy(to + at, from + at, copied_at_once);
        }
        std::memcpy(to + in_blocks, from + in_blocks, rest);
    }

    template <std::size_t... index>
    static Word sum_of_words(const unsigned char* bytes, std::index_sequence<index...>) noexcept {
        return (0U + ... + memory_word_at(bytes + index * sizeof(Word)));
    }

    static Word sum_of(const Object& object) noexcept {
        constexpr std::size_t rest = sizeof(Object) % summed_at_once;
        constexpr std::size_t in_blocks = sizeof(Object) - rest;
        const unsigned char* const bytes = bytes_of(object);
        Word sum = sum_of_words(bytes + in_blocks, std::make_index_sequence<rest / sizeof(Word)>{});
        for (std::size_t at = 0U; at < in_blocks; at += summed_at_once) {
            sum += sum_of_words(bytes + at, std::make_index_sequence<summed_at_once / sizeof(Word)>{});
        }
        return sum;
    }

    alignas(Word) Bytes kept_{};
    Word sum_{0U};
    bool restored_{false};
    bool is_failing_{false};
};

}  // namespace rsi::monitoring
