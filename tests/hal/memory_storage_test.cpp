// The record in memory that stands for one that outlives a loss of power.
#include "hal/memory/memory_storage.hpp"

#include <gtest/gtest.h>

namespace {

using Record = std::array<std::uint8_t, 4>;
using rsi::hal::Reading;

TEST(MemoryStorage, HasNothingBeforeTheFirstWrite) {
    rsi::hal::MemoryStorage<8U> storage;
    Record read{1U, 2U, 3U, 4U};
    EXPECT_EQ(storage.read(read.data(), read.size()), Reading::never_written);
    EXPECT_EQ(read, (Record{1U, 2U, 3U, 4U}));
    EXPECT_EQ(storage.read(read.data(), 1U), Reading::never_written);
}

TEST(MemoryStorage, GivesBackWhatWasWrittenLast) {
    rsi::hal::MemoryStorage<8U> storage;
    Record read{};
    for (const Record& record : {Record{1U, 2U, 3U, 4U}, Record{9U, 8U, 7U, 6U}}) {
        ASSERT_TRUE(storage.write(record.data(), record.size()));
        ASSERT_EQ(storage.read(read.data(), read.size()), Reading::stored);
        EXPECT_EQ(read, record);
    }
    EXPECT_EQ(storage.writes(), 2U);
    EXPECT_EQ(storage.read(read.data(), 3U), Reading::unreadable);
}

TEST(MemoryStorage, TakesNothingWhileBusyNorWhatIsTooLong) {
    rsi::hal::MemoryStorage<4U> storage;
    const std::array<std::uint8_t, 5> longer{};
    EXPECT_FALSE(storage.write(longer.data(), longer.size()));
    storage.set_busy(true);
    EXPECT_FALSE(storage.write(longer.data(), 4U));
    storage.set_busy(false);
    EXPECT_TRUE(storage.write(longer.data(), 4U));
    EXPECT_EQ(storage.writes(), 1U);
}

TEST(MemoryStorage, CanBeDamaged) {
    rsi::hal::MemoryStorage<4U> storage;
    Record record{};
    ASSERT_TRUE(storage.write(record.data(), record.size()));
    storage.damage(2U);
    ASSERT_EQ(storage.read(record.data(), record.size()), Reading::stored);
    EXPECT_EQ(record, (Record{0U, 0U, 1U, 0U}));
}

}  // namespace
