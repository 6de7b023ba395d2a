// A count that outlives a loss of power, in a record that cannot be mistaken.
#include "rsi/ecu/access/stored_count.hpp"

#include <gtest/gtest.h>

#include "tests/access/cut_storage.hpp"

namespace testing_access {
namespace {

using rsi::access::CountState;
using rsi_test::CutStorage;

using rsi::access::CountOf;

constexpr CountOf what = CountOf::wrong_keys;

TEST(AStoredCount, IsAbsentBeforeTheFirstWrite) {
    CutStorage storage;
    std::uint32_t count = 77U;
    EXPECT_EQ(rsi::access::read_count(storage, what, count), CountState::absent);
    EXPECT_EQ(count, 77U);
}

TEST(AStoredCount, IsReadAsItWasWritten) {
    for (const std::uint32_t written : {0U, 1U, 0x12345678U, 0xFFFFFFFFU}) {
        CutStorage storage;
        ASSERT_TRUE(rsi::access::write_count(storage, what, written));
        std::uint32_t count = 77U;
        EXPECT_EQ(rsi::access::read_count(storage, what, count), CountState::good);
        EXPECT_EQ(count, written);
    }
}

TEST(AStoredCount, HasItsBytesInTheirPlaces) {
    CutStorage storage;
    ASSERT_TRUE(rsi::access::write_count(storage, what, 0x0D0C0B0AU));
    const std::vector<std::uint8_t> expected{'R',   'S',   'I',   'K',   0x0AU, 0x0BU,
                                             0x0CU, 0x0DU, 0xF5U, 0xF4U, 0xF3U, 0xF2U};
    EXPECT_EQ(storage.record(), expected);
    EXPECT_EQ(expected.size(), rsi::access::stored_count_length);
}

TEST(AStoredCount, IsDamagedWithAnyBitFlippedErasedOrUnderAnotherTag) {
    CutStorage storage;
    ASSERT_TRUE(rsi::access::write_count(storage, what, 5U));
    std::uint32_t count = 77U;
    for (std::size_t bit = 0U; bit < 8U * rsi::access::stored_count_length; ++bit) {
        std::uint8_t& byte = storage.record()[bit / 8U];
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
        EXPECT_EQ(rsi::access::read_count(storage, what, count), CountState::damaged) << bit;
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
    }
    EXPECT_EQ(rsi::access::read_count(storage, CountOf::section_versions, count), CountState::damaged);
    for (const std::uint8_t erased : {std::uint8_t{0U}, std::uint8_t{0xFFU}}) {
        storage.record().assign(rsi::access::stored_count_length, erased);
        EXPECT_EQ(rsi::access::read_count(storage, what, count), CountState::damaged);
    }
    EXPECT_EQ(count, 77U);
}

// Only what was never written counts as new: a record that cannot be read may have counted anything.
TEST(AStoredCount, IsDamagedWhereTheMemoryDoesNotGiveItOrGivesOneOfAnotherLength) {
    std::uint32_t count = 77U;
    for (const std::size_t length :
         {std::size_t{1U}, std::size_t{5U}, rsi::access::stored_count_length + 1U}) {
        CutStorage storage;
        storage.record().assign(length, 0U);
        EXPECT_EQ(rsi::access::read_count(storage, what, count), CountState::damaged) << length;
    }
    CutStorage storage;
    ASSERT_TRUE(rsi::access::write_count(storage, what, 5U));
    storage.set_unreadable(true);
    EXPECT_EQ(rsi::access::read_count(storage, what, count), CountState::damaged);
    EXPECT_EQ(count, 77U);
}

TEST(AStoredCount, SaysWhenTheStorageDoesNotTakeIt) {
    CutStorage storage;
    storage.refuse(true);
    EXPECT_FALSE(rsi::access::write_count(storage, what, 1U));
}

}  // namespace
}  // namespace testing_access
