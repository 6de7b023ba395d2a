// The memory guard: no bit of an object can change unseen, and none stays changed.
#include "rsi/ecu/monitoring/memory_guard.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "rsi/component.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/support/large_suv.h"
#include "tests/support/memory_damage.hpp"

namespace {

using rsi::monitoring::MemoryGuard;

// Numbers that all differ, so that an exchanged or repeated block shows.
template <typename Object>
Object filled() {
    static_assert(sizeof(Object) <= 256U * sizeof(std::uint32_t));
    std::array<std::uint32_t, 256U> words{};
    std::uint32_t word = 1U;
    for (std::uint32_t& one : words) {
        word = 1664525U * word + 1013904223U;
        one = word;
    }
    Object object{};
    std::memcpy(&object, words.data(), sizeof object);
    return object;
}

template <std::size_t words>
using Words = std::array<std::uint32_t, words>;

// Less than what is copied or summed at once, as much, with a rest, and several times as much.
template <typename Object>
class AMemoryGuard : public ::testing::Test {};
using Sizes = ::testing::Types<Words<1U>, Words<15U>, Words<16U>, Words<17U>, Words<48U>, Words<61U>,
                               Words<127U>, Words<128U>, Words<129U>, Words<256U>>;
TYPED_TEST_SUITE(AMemoryGuard, Sizes, );  // the empty argument: what clang asks of a macro before C++20

TYPED_TEST(AMemoryGuard, FindsNothingWhereNothingHasChanged) {
    TypeParam object = filled<TypeParam>();
    MemoryGuard<TypeParam> guard{object};
    const TypeParam before = object;
    for (int cycle = 0; cycle < 3; ++cycle) {
        EXPECT_FALSE(guard.restore(object));
        EXPECT_FALSE(guard.is_failing());
    }
    EXPECT_EQ(object, before);
}

TYPED_TEST(AMemoryGuard, RestoresEveryBit) {
    const TypeParam before = filled<TypeParam>();
    for (std::size_t byte = 0U; byte < sizeof(TypeParam); ++byte) {
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            rsi_test::Fenced<TypeParam> fenced;
            fenced.object = before;
            MemoryGuard<TypeParam> guard{fenced.object};
            rsi_test::flip(fenced.object, byte, bit);
            ASSERT_TRUE(guard.restore(fenced.object));
            ASSERT_EQ(fenced.object, before);
            ASSERT_TRUE(fenced.is_whole());
            ASSERT_FALSE(guard.restore(fenced.object));
        }
    }
}

TYPED_TEST(AMemoryGuard, KeepsWhatTheOwnerHasMadeOfIt) {
    TypeParam object{};
    MemoryGuard<TypeParam> guard{object};
    object = filled<TypeParam>();
    const TypeParam made = object;
    guard.keep(object);
    EXPECT_FALSE(guard.restore(object));
    object.back() ^= 4U;
    EXPECT_TRUE(guard.restore(object));
    EXPECT_EQ(object, made);
}

// For any changed bit of the guard itself, the object stays as it is.
TYPED_TEST(AMemoryGuard, DoesNoHarmWhereItIsItselfDamaged) {
    const TypeParam before = filled<TypeParam>();
    const MemoryGuard<TypeParam> sound{before};
    constexpr std::size_t kept_and_sum = sizeof(TypeParam) + 4U * sizeof(std::uint32_t);
    for (std::size_t byte = 0U; byte < kept_and_sum; ++byte) {
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            TypeParam object = before;
            MemoryGuard<TypeParam> guard = sound;
            rsi_test::flip(guard, byte, bit);
            EXPECT_EQ(guard.restore(object), byte >= sizeof(TypeParam));
            EXPECT_EQ(object, before);
            EXPECT_FALSE(guard.is_failing());
        }
    }
}

// Two words that are exchanged, or changed by as much in opposite directions: a plain sum would stay the
// same.
TYPED_TEST(AMemoryGuard, FindsChangesThatCompensateEachOther) {
    const TypeParam before = filled<TypeParam>();
    const std::size_t words = before.size();
    for (std::size_t one = 0U; one < words; ++one) {
        for (std::size_t other = one + 1U; (other < words) && (other < one + 32U); ++other) {
            TypeParam object = before;
            MemoryGuard<TypeParam> guard{object};
            std::swap(object[one], object[other]);
            ASSERT_TRUE(guard.restore(object)) << one << ' ' << other;
            ASSERT_EQ(object, before);
            object[one] += 0x0080'0000U;
            object[other] -= 0x0080'0000U;
            ASSERT_TRUE(guard.restore(object)) << one << ' ' << other;
            object[one] ^= 0x8000'0000U;
            object[other] ^= 0x8000'0000U;
            ASSERT_TRUE(guard.restore(object)) << one << ' ' << other;
            ASSERT_EQ(object, before);
        }
    }
}

// The copy is summed, too: where it has changed as well, neither of them is to be trusted.
TYPED_TEST(AMemoryGuard, IsFailingWhereItsCopyHasChangedToo) {
    TypeParam object = filled<TypeParam>();
    MemoryGuard<TypeParam> guard{object};
    rsi_test::flip(guard, sizeof(TypeParam) - 1U, 3U);
    EXPECT_FALSE(guard.restore(object)) << "the object is as it was";
    object.front() ^= 1U;
    for (int cycle = 0; cycle < 3; ++cycle) {  // until something else is kept
        EXPECT_TRUE(guard.restore(object));
        EXPECT_TRUE(guard.is_failing());
        EXPECT_TRUE(guard.is_lost());
    }
    guard.keep(object);
    EXPECT_FALSE(guard.restore(object));
    EXPECT_FALSE(guard.is_failing());
    EXPECT_FALSE(guard.is_lost());
}

// A bit that stays as it is, whatever is written.
TYPED_TEST(AMemoryGuard, IsFailingWhereTheMemoryHoldsNothing) {
    TypeParam object{};
    MemoryGuard<TypeParam> guard{object};
    for (int cycle = 0; cycle < 4; ++cycle) {
        object.front() |= 8U;
        EXPECT_TRUE(guard.restore(object));
        EXPECT_EQ(guard.is_failing(), cycle > 0);
    }
    EXPECT_FALSE(guard.restore(object));
    EXPECT_FALSE(guard.is_failing());
    object.front() |= 8U;
    EXPECT_TRUE(guard.restore(object));
    EXPECT_FALSE(guard.is_failing());
}

// Constants and state alike.
TEST(AMemoryGuardOfTheComponent, RestoresEveryBit) {
    rsi::Component component;
    ASSERT_EQ(component.init(rsi_test_large_suv()).accepted, 1);
    rsi::Inputs inputs = rsi_test::at_rest();
    inputs.lateral_specific_force_mps2 = 2.0F;
    rsi::Outputs outputs{};
    for (int sample = 0; sample < 50; ++sample) {
        component.step(inputs, outputs);
    }
    MemoryGuard<rsi::Component> guard{component};
    std::array<unsigned char, sizeof component> before{};
    std::memcpy(before.data(), &component, sizeof component);
    for (std::size_t byte = 0U; byte < sizeof component; ++byte) {
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            rsi_test::flip(component, byte, bit);
            ASSERT_TRUE(guard.restore(component)) << byte << ' ' << bit;
            ASSERT_EQ(std::memcmp(&component, before.data(), sizeof component), 0) << byte << ' ' << bit;
            ASSERT_FALSE(guard.restore(component));
        }
    }
}

}  // namespace
