// The record in memory that no start clears: whatever that memory holds at power-on, it is none.
#include "hal/memory/retained_record.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace {

using Memory = rsi::hal::RetainedMemory<8U>;
using Record = std::array<std::uint8_t, 4>;
using rsi::hal::Reading;

TEST(RetainedRecord, HasNothingInMemoryOfOneByteOverAndOver) {
    for (unsigned byte = 0U; byte <= 0xFFU; ++byte) {
        Memory memory;
        std::memset(&memory, static_cast<int>(byte), sizeof memory);
        rsi::hal::RetainedRecord<8U> record{memory};
        Record read{1U, 2U, 3U, 4U};
        for (const std::size_t length : {std::size_t{0U}, read.size()}) {
            const Reading expected = (byte == 0U) ? Reading::never_written : Reading::unreadable;
            EXPECT_EQ(record.read(read.data(), length), expected) << byte;
        }
        EXPECT_EQ(read, (Record{1U, 2U, 3U, 4U}));
    }
}

TEST(RetainedRecord, OutlivesTheObjectThatWroteIt) {
    Memory memory{};
    for (const Record& written : {Record{1U, 2U, 3U, 4U}, Record{9U, 8U, 7U, 6U}}) {
        EXPECT_TRUE(rsi::hal::RetainedRecord<8U>{memory}.write(written.data(), written.size()));
        rsi::hal::RetainedRecord<8U> after{memory};
        Record read{};
        ASSERT_EQ(after.read(read.data(), read.size()), Reading::stored);
        EXPECT_EQ(read, written);
        EXPECT_EQ(after.read(read.data(), 3U), Reading::unreadable) << "another length than was written";
    }
}

TEST(RetainedRecord, TakesNothingThatIsTooLongAndReadsNoSuchLength) {
    Memory memory{};
    rsi::hal::RetainedRecord<8U> record{memory};
    std::array<std::uint8_t, 9> bytes{};
    EXPECT_FALSE(record.write(bytes.data(), bytes.size()));
    EXPECT_TRUE(record.write(bytes.data(), 8U));
    memory.length = 9U;
    memory.inverted_length = ~memory.length;
    EXPECT_EQ(record.read(bytes.data(), bytes.size()), Reading::unreadable);
}

// Half of its head set, as by a loss of power: a record was there.
TEST(RetainedRecord, WithHalfOfItsHeadIsUnreadable) {
    for (const bool first : {true, false}) {
        Memory memory{};
        (first ? memory.length : memory.inverted_length) = 4U;
        rsi::hal::RetainedRecord<8U> record{memory};
        Record read{};
        EXPECT_EQ(record.read(read.data(), read.size()), Reading::unreadable);
    }
}

}  // namespace
