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
// added. It has several lanes, to which the words go in turn, and turns with each word: changes of two words
// in different lanes never cancel each other, those of one lane only by chance. A copy that is not what was
// kept is not taken for the object.
template <typename Object>
class MemoryGuard {
 public:
    explicit MemoryGuard(const Object& object) noexcept { keep(object); }

    // Saves the object's content as the reference. Call it after each intended change.
    void keep(const Object& object) noexcept {
        copy(bytes_of(object), bytes_of(kept_));
        sum_ = sum_of(bytes_of(object));
        is_lost_ = false;
    }

    // Call it before each use. True when object or sum have changed since keep(); the object is then
    // restored.
    bool restore(Object& object) noexcept {
        const Sum sum = sum_of(bytes_of(object));
        const bool changed = is_lost_ || (difference(sum, sum_) != 0U);
        is_lost_ = changed && (is_lost_ || !mend(object, sum));
        is_failing_ = is_lost_ || (changed && restored_);
        restored_ = changed;
        return changed;
    }

    // Two consecutive calls had to restore the object, or the copy has changed as well, or memory does not
    // take it: a permanent fault.
    bool is_failing() const noexcept { return is_failing_; }

    // Neither object nor copy is what was kept. A caller that keeps what is made of it would trust it from
    // then on.
    bool is_lost() const noexcept { return is_lost_; }

 private:
    using Word = MemoryWord;
    using Bytes = std::array<unsigned char, sizeof(Object)>;

    // Few enough for registers. Words of a lane that are turned alike are 128 apart.
    static constexpr std::size_t lanes = 4U;
    using Sum = std::array<Word, lanes>;

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

    // False where neither object nor copy can be trusted. If these two agree, the sum was wrong.
    [[gnu::cold, gnu::noinline]] bool mend(Object& object, const Sum& sum) noexcept {
        const Sum sum_of_copy = sum_of(bytes_of(kept_));
        if (difference(sum_of_copy, sum) == 0U) {
            sum_ = sum;
            return true;
        }
        copy(bytes_of(kept_), bytes_of(object));
        return (difference(sum_of_copy, sum_) | difference(sum_of(bytes_of(object)), sum_)) == 0U;
    }

    static void copy(const unsigned char* from, unsigned char* to) noexcept {
        constexpr std::size_t rest = sizeof(Object) % copied_at_once;
        constexpr std::size_t in_blocks = sizeof(Object) - rest;
        for (std::size_t at = 0U; at < in_blocks; at += copied_at_once) {
            std::memcpy(to + at, from + at, copied_at_once);
        }
        std::memcpy(to + in_blocks, from + in_blocks, rest);
    }

    // One instruction of Arm's.
    static void add(Word word, Word& lane) noexcept { lane = ((lane >> 1U) | (lane << 31U)) + word; }

    template <std::size_t... index>
    static void add_words(const unsigned char* bytes, Sum& sum, std::index_sequence<index...>) noexcept {
        Sum now = sum;
        (add(memory_word_at(bytes + index * sizeof(Word)), now[index % lanes]), ...);
        sum = now;
    }

    template <std::size_t... lane>
    static Word difference(const Sum& a, const Sum& b, std::index_sequence<lane...>) noexcept {
        return (0U | ... | (a[lane] ^ b[lane]));
    }
    // 0: they are the same.
    static Word difference(const Sum& a, const Sum& b) noexcept {
        return difference(a, b, std::make_index_sequence<lanes>{});
    }

    // Once in an image: it is long.
    [[gnu::noinline]] static Sum sum_of(const unsigned char* bytes) noexcept {
        constexpr std::size_t rest = sizeof(Object) % summed_at_once;
        constexpr std::size_t in_blocks = sizeof(Object) - rest;
        Sum sum{};
        for (std::size_t at = 0U; at < in_blocks; at += summed_at_once) {
            add_words(bytes + at, sum, std::make_index_sequence<summed_at_once / sizeof(Word)>{});
        }
        add_words(bytes + in_blocks, sum, std::make_index_sequence<rest / sizeof(Word)>{});
        return sum;
    }

    alignas(Word) Bytes kept_{};
    Sum sum_{};
    bool restored_{false};
    bool is_failing_{false};
    bool is_lost_{false};
};

}  // namespace rsi::monitoring
