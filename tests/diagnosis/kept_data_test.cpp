// Data that outlive a loss of power: at any write, at most the newest entry is lost.
#include "rsi/ecu/diagnosis/kept_data.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/diagnosis/tester.hpp"

namespace testing_diagnosis {
namespace {

using rsi::application::RecordState;
using rsi::diagnosis::KeptData;
using rsi::monitoring::CodeSet;
using rsi_test::CutStorage;

constexpr CodeSet bit_of(std::size_t row) {
    return CodeSet{2U} << row;
}

// An ECU with two places, through whose life one may cut the power.
struct Life {
    explicit Life(Memories& memories) : data{memories.one, memories.other} {
        data.restore();
        data.codes().start(true);
    }
    void run(int cycles, CodeSet failed = 0U) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            data.codes().update({failed, failed, ~failed}, {}, 0U);
            data.end_cycle();
        }
    }
    bool has_power(const Memories& memories) const {
        return memories.one.has_power() && memories.other.has_power();
    }
    std::set<std::size_t> known() {
        std::set<std::size_t> rows;
        for (std::size_t row = 0U; row < rsi::diagnosis::trouble_code_count; ++row) {
            if ((data.codes().state(row).status & rsi::diagnosis::status::confirmed) != 0U) {
                rows.insert(row);
            }
        }
        return rows;
    }

    KeptData data;
};

TEST(KeptData, AnEmptyMemoryIsNone) {
    Memories memories;
    Life life{memories};
    EXPECT_TRUE(life.known().empty());
    EXPECT_EQ(life.data.written().vehicle_number[0], 0U);
}

TEST(KeptData, EntriesAndWrittenDataComeBack) {
    Memories memories;
    {
        Life life{memories};
        life.run(200);
        life.run(1, bit_of(3U));
        life.data.written().vehicle_number.fill('V');
        life.data.written().programming_date = {0x20U, 0x26U, 0x11U, 0x25U};
        life.data.codes().request_storing(rsi::diagnosis::Storing::now);
        life.run(200);
    }
    Life life{memories};
    EXPECT_EQ(life.known(), (std::set<std::size_t>{3U}));
    EXPECT_EQ(life.data.written().vehicle_number[16], 'V');
    EXPECT_EQ(life.data.written().programming_date[3], 0x25U);
}

// A cycle that begins is stored at once, else it would age the codes again and again.
TEST(KeptData, TheFirstRecordIsWrittenInTheFirstCycle) {
    Memories memories;
    Life life{memories};
    life.run(1);
    EXPECT_EQ(memories.one.writes() + memories.other.writes(), 1);
}

// The place may still be busy with the record before.
TEST(KeptData, RecordsAreASecondApartAndTakeTurns) {
    Memories memories;
    Life life{memories};
    life.run(1);
    life.run(99, bit_of(0U));
    EXPECT_EQ(memories.one.writes() + memories.other.writes(), 1);
    life.run(1, bit_of(0U));
    EXPECT_EQ(memories.one.writes(), 1);
    EXPECT_EQ(memories.other.writes(), 1);
    EXPECT_TRUE(life.data.is_stored());
}

TEST(KeptData, ACountAloneIsStoredOnceAMinute) {
    Memories memories;
    Life life{memories};
    life.run(350);
    life.run(200);
    life.run(1, bit_of(0U));  // for the first time: at once
    const int writes = memories.one.writes() + memories.other.writes();
    for (int time = 0; time < 2999; ++time) {
        life.run(1);
        life.run(1, bit_of(0U));
    }
    life.run(1);
    EXPECT_EQ(memories.one.writes() + memories.other.writes(), writes);
    life.run(1, bit_of(0U));
    EXPECT_EQ(memories.one.writes() + memories.other.writes(), writes + 1);
}

// It would wear the memory out.
TEST(KeptData, NothingIsStoredWhereNothingHasChanged) {
    Memories memories;
    Life life{memories};
    life.run(1);
    EXPECT_EQ(memories.one.writes() + memories.other.writes(), 1);
    life.run(6000);
    EXPECT_EQ(memories.one.writes() + memories.other.writes(), 2) << "tests that are completed, in a minute";
    const int writes = memories.one.writes() + memories.other.writes();
    life.run(20000);
    EXPECT_EQ(memories.one.writes() + memories.other.writes(), writes);
    life.run(1, bit_of(0U));
    EXPECT_EQ(memories.one.writes() + memories.other.writes(), writes + 1) << "but what is new at once";
}

TEST(KeptData, ABusyPlaceIsAskedAgain) {
    Memories memories;
    memories.refuse(true);
    Life life{memories};
    life.run(62);
    EXPECT_FALSE(life.data.is_stored());
    memories.refuse(false);
    life.run(64);
    EXPECT_TRUE(life.data.is_stored());
    EXPECT_FALSE(life.data.is_failing());
}

// At a pace of its own, and never in every cycle.
TEST(KeptData, APlaceThatRefusesIsAskedEverMoreRarelyAndIsAFailure) {
    Memories memories;
    memories.refuse(true);
    Life life{memories};
    life.run(511);
    EXPECT_EQ(memories.one.tries() + memories.other.tries(), 9);
    EXPECT_FALSE(life.data.is_failing());
    life.run(1);
    EXPECT_TRUE(life.data.is_failing());
    life.run(600000);
    EXPECT_LE(memories.one.tries() + memories.other.tries(), 10 + 104);
    memories.refuse(false);
    life.run(6000);
    EXPECT_TRUE(life.data.is_stored());
    EXPECT_FALSE(life.data.is_failing());
}

TEST(KeptData, RecordsOfWhichNoneCanBeReadAreAFailure) {
    Memories memories;
    {
        Life life{memories};
        EXPECT_FALSE(life.data.is_failing()) << "nothing was ever stored";
        life.run(150, bit_of(1U));
        life.run(150, bit_of(1U) | bit_of(2U));
    }
    memories.other.set_unreadable(true);
    EXPECT_FALSE(Life{memories}.data.is_failing()) << "as after a loss of power";
    memories.one.record().pop_back();
    memories.refuse(true);
    Life life{memories};
    life.run(1);
    EXPECT_TRUE(life.data.is_failing()) << "refused, they are as lost as they were";
    life.data.report_section_memory(true);
    EXPECT_TRUE(life.data.is_failing());
    life.data.report_section_memory(false);
    EXPECT_TRUE(life.data.is_failing()) << "that of this one stays";
    memories.refuse(false);
    life.run(1);
    EXPECT_TRUE(life.data.is_stored());
    EXPECT_FALSE(life.data.is_failing()) << "a record has been taken since";
    life.data.report_section_memory(true);
    EXPECT_TRUE(life.data.is_failing());
    life.data.report_section_memory(false);
    EXPECT_FALSE(life.data.is_failing());
}

// Every write of a life with ten codes, one after the other, cut at the beginning, at the end, and at bytes
// between.
TEST(KeptData, ALossOfPowerAtAnyWriteLosesAtMostTheNewestEntry) {
    constexpr std::size_t codes = 10U;
    int cuts = 0;
    for (const std::size_t bytes :
         {std::size_t{0U}, std::size_t{1U}, std::size_t{7U}, std::size_t{8U}, std::size_t{100U},
          KeptData::record_length - 1U, KeptData::record_length}) {
        for (int at_write = 1; at_write <= 7; ++at_write) {
            for (const bool in_first : {true, false}) {
                Memories memories;
                (in_first ? memories.one : memories.other).cut_power_at({at_write, bytes});
                std::set<std::size_t> stored;
                std::size_t newest = codes;
                {
                    Life life{memories};
                    life.run(350);
                    CodeSet failed = 0U;
                    for (std::size_t row = 0U; (row < codes) && life.has_power(memories); ++row) {
                        failed |= bit_of(row);
                        newest = row;
                        for (int cycle = 0; (cycle < 150) && life.has_power(memories); ++cycle) {
                            life.run(1, failed);
                        }
                        if (life.has_power(memories)) {
                            stored.insert(row);
                        }
                    }
                    if (life.has_power(memories)) {
                        continue;  // there were fewer writes
                    }
                }
                ++cuts;
                memories.one.cut_power_at({0, 0U});
                memories.other.cut_power_at({0, 0U});
                Life life{memories};
                std::set<std::size_t> all = stored;
                all.insert(newest);
                const std::set<std::size_t> known = life.known();
                EXPECT_TRUE(known == stored || known == all || (stored.empty() && known.empty()))
                    << "cut at write " << at_write << " after " << bytes << " bytes: " << known.size()
                    << " of " << stored.size() << " known";
                // And it goes on: what comes next is kept.
                life.run(150, bit_of(20U));
                Life next{memories};
                EXPECT_EQ(next.known().count(20U), 1U);
            }
        }
    }
    EXPECT_GE(cuts, 70);
}

TEST(KeptData, EveryDamagedByteIsNoticedAndTheOtherRecordUsed) {
    Memories memories;
    {
        Life life{memories};
        life.run(150, bit_of(1U));
        life.run(150, bit_of(1U) | bit_of(2U));
    }
    for (std::size_t byte = 0U; byte < KeptData::record_length; ++byte) {
        Memories damaged;
        damaged.one.record() = memories.one.record();
        damaged.other.record() = memories.other.record();
        CutStorage& newer = (memories.one.record()[KeptData::record_length - 8U] >
                             memories.other.record()[KeptData::record_length - 8U])
                                ? damaged.one
                                : damaged.other;
        newer.record()[byte] ^= 0x40U;
        Life life{damaged};
        EXPECT_EQ(life.known(), (std::set<std::size_t>{1U})) << byte;
    }
}

TEST(KeptData, ARecordOfAnotherLayoutIsNotRead) {
    Memories memories;
    rsi::application::AlternatingRecord<rsi::diagnosis::KeptPayload> record{memories.one, memories.other};
    rsi::diagnosis::KeptPayload payload{};
    payload.codes.states.fill({rsi::diagnosis::status::failure, 1U, 0U});
    payload.layout = rsi::diagnosis::KeptPayload::present_layout + 1U;
    ASSERT_TRUE(record.write(payload));
    EXPECT_TRUE(Life{memories}.known().empty());
    EXPECT_TRUE(Life{memories}.data.is_failing());
    payload.layout = rsi::diagnosis::KeptPayload::present_layout;
    ASSERT_TRUE(record.write(payload));
    EXPECT_EQ(Life{memories}.known().size(), rsi::diagnosis::trouble_code_count);
}

// Before snapshots had the operation cycle: shorter, under the same name of the layout or not.
TEST(KeptData, AnOlderAndShorterRecordIsRefusedAndReported) {
    struct Older {
        std::array<std::uint8_t, 379> bytes{};
    };
    for (const std::uint8_t layout : Bytes{1U, rsi::diagnosis::KeptPayload::present_layout}) {
        Memories memories;
        rsi::application::AlternatingRecord<Older> record{memories.one, memories.other};
        Older older{};
        older.bytes.fill(rsi::diagnosis::status::failure);
        older.bytes[0] = layout;
        ASSERT_TRUE(record.write(older));
        Life life{memories};
        EXPECT_TRUE(life.known().empty());
        EXPECT_EQ(life.data.codes().operation_cycles()[3], 1U);
        EXPECT_TRUE(life.data.is_failing()) << "what was there is lost";
        life.run(200);
        EXPECT_FALSE(life.data.is_failing());
        EXPECT_EQ(Life{memories}.data.codes().operation_cycles()[3], 2U) << "written anew";
    }
}

// An update that adds codes must not take away the vehicle's number, nor the codes that there were.
TEST(KeptData, ARecordDoesNotDependOnHowManyCodesThereAre) {
    EXPECT_EQ(KeptData::record_length, 1U + 3U * 63U + 8U * 37U + 4U + 21U + 12U);
}

// The sequence number may begin again at zero.
TEST(AlternatingRecord, TheNewerOneIsKnownBeyondTheLargestNumber) {
    using Record = rsi::application::AlternatingRecord<std::uint8_t>;
    Memories memories;
    const auto record_with = [](std::uint32_t sequence, std::uint8_t byte) {
        Bytes record(Record::length);
        record[0] = byte;
        rsi::application::put_u32(record.data(), 1U, 0x44495352U);
        rsi::application::put_u32(record.data(), 5U, sequence);
        rsi::application::put_u32(record.data(), 9U, rsi::application::crc32(record.data(), 9U));
        return record;
    };
    const auto newest = [&](std::uint32_t one, std::uint32_t other) {
        memories.one.record() = record_with(one, 1U);
        memories.other.record() = record_with(other, 2U);
        Record record{memories.one, memories.other};
        std::uint8_t payload = 0U;
        EXPECT_EQ(record.read(payload), RecordState::good);
        return unsigned{payload};
    };
    EXPECT_EQ(newest(7U, 8U), 2U);
    EXPECT_EQ(newest(8U, 7U), 1U);
    EXPECT_EQ(newest(0xFFFFFFF0U, 0xFFFFFFF1U), 2U);
    EXPECT_EQ(newest(0xFFFFFFFFU, 0U), 2U);
    EXPECT_EQ(newest(0U, 0xFFFFFFFFU), 1U);

    // And the older one is what the next record replaces.
    Record record{memories.one, memories.other};
    std::uint8_t payload = 0U;
    ASSERT_EQ(record.read(payload), RecordState::good);
    ASSERT_TRUE(record.write(3U));
    EXPECT_EQ(memories.one.record()[0], 1U);
    EXPECT_EQ(memories.other.record()[0], 3U);
}

TEST(AlternatingRecord, AnEmptyMemoryLeavesThePayloadAsItWas) {
    Memories memories;
    rsi::application::AlternatingRecord<std::uint8_t> record{memories.one, memories.other};
    std::uint8_t payload = 7U;
    EXPECT_EQ(record.read(payload), RecordState::never_written);
    EXPECT_EQ(payload, 7U);
}

// Other data in such a memory may have a checksum of the same kind.
TEST(AlternatingRecord, ARecordOfAnotherKindIsNotRead) {
    using Record = rsi::application::AlternatingRecord<std::uint8_t>;
    Memories memories;
    Bytes foreign(Record::length, 1U);
    rsi::application::put_u32(foreign.data(), 9U, rsi::application::crc32(foreign.data(), 9U));
    memories.one.record() = foreign;
    Record record{memories.one, memories.other};
    std::uint8_t payload = 7U;
    EXPECT_EQ(record.read(payload), RecordState::unreadable);
}

// A memory that has filled the bytes and then says that they are not to be trusted.
class DoubtfulStorage final : public rsi::hal::Storage {
 public:
    rsi::hal::Reading read(std::uint8_t* bytes, std::size_t length) noexcept override {
        std::copy_n(record.begin(), std::min(length, record.size()), bytes);
        return rsi::hal::Reading::unreadable;
    }
    bool write(const std::uint8_t* bytes, std::size_t length) noexcept override {
        record.assign(bytes, bytes + length);
        return true;
    }

    Bytes record{};
};

TEST(AlternatingRecord, AnUnreadableRecordIsNotTaken) {
    DoubtfulStorage one;
    DoubtfulStorage other;
    rsi::application::AlternatingRecord<std::uint8_t> record{one, other};
    ASSERT_TRUE(record.write(3U));
    std::uint8_t payload = 7U;
    EXPECT_EQ(record.read(payload), RecordState::unreadable);
    EXPECT_EQ(payload, 7U);
}

}  // namespace
}  // namespace testing_diagnosis
