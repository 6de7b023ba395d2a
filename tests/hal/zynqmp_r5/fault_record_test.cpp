// Knowledge after a reset.
#include "hal/zynqmp_r5/fault_record.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace rsi::hal::zynqmp_r5 {
namespace {

// Memory after power-on holds anything.
FaultRecord noise() {
    FaultRecord record;
    std::memset(&record, 0xA5, sizeof(record));
    return record;
}

constexpr Fault data_abort{ResetReason::data_abort, 0x0010'1234U, 0x4000'0000U, 0x0DU, 0x1FU};

TEST(FaultRecord, AfterPowerOnNothingIsKnown) {
    FaultRecord record = noise();
    EXPECT_FALSE(is_valid(record));
    EXPECT_EQ(begin_run(record), ResetReason::power_on);
    EXPECT_TRUE(is_valid(record));
    FaultRecord zeros{};
    EXPECT_EQ(begin_run(zeros), ResetReason::power_on);
}

TEST(FaultRecord, AResetWithoutARecordCameFromOutside) {
    FaultRecord record = noise();
    begin_run(record);
    EXPECT_EQ(begin_run(record), ResetReason::outside);
    EXPECT_EQ(begin_run(record), ResetReason::outside);
    EXPECT_EQ(record.resets, 2U);
}

TEST(FaultRecord, AFaultIsToldOnceAndItsDetailsStay) {
    FaultRecord record = noise();
    begin_run(record);
    record_fault(data_abort, record);
    EXPECT_EQ(begin_run(record), ResetReason::data_abort);
    EXPECT_EQ(record.instruction, 0x0010'1234U);
    EXPECT_EQ(record.data, 0x4000'0000U);
    EXPECT_EQ(record.status, 0x0DU);
    EXPECT_EQ(record.program_status, 0x1FU);
    EXPECT_EQ(record.resets, 1U);
    EXPECT_EQ(begin_run(record), ResetReason::outside);
}

TEST(FaultRecord, AFaultBeforeTheFirstRunIsTold) {
    FaultRecord record = noise();
    record_fault(data_abort, record);
    EXPECT_EQ(begin_run(record), ResetReason::data_abort);
    EXPECT_EQ(record.resets, 1U);
}

TEST(FaultRecord, EveryReasonIsTold) {
    for (std::uint32_t reason = 1U; reason <= static_cast<std::uint32_t>(ResetReason::start_without_reset);
         ++reason) {
        FaultRecord record = noise();
        record_fault(Fault{static_cast<ResetReason>(reason)}, record);
        EXPECT_EQ(begin_run(record), static_cast<ResetReason>(reason));
    }
}

TEST(FaultRecord, AnyChangedBitMakesItWorthless) {
    FaultRecord good = noise();
    begin_run(good);
    record_fault(data_abort, good);
    for (std::size_t bit = 0U; bit < 8U * sizeof(good); ++bit) {
        FaultRecord record = good;
        unsigned char bytes[sizeof(record)];
        std::memcpy(bytes, &record, sizeof(record));
        bytes[bit / 8U] = static_cast<unsigned char>(bytes[bit / 8U] ^ (1U << (bit % 8U)));
        std::memcpy(&record, bytes, sizeof(record));
        EXPECT_EQ(begin_run(record), ResetReason::power_on) << "bit " << bit;
    }
}

TEST(FaultRecord, ARightCheckSumAloneMakesNothingValid) {
    FaultRecord good{};
    begin_run(good);
    FaultRecord other_magic = good;
    ++other_magic.magic;
    other_magic.check = detail::check_of(other_magic);
    EXPECT_EQ(begin_run(other_magic), ResetReason::power_on);
    FaultRecord no_reason = good;
    no_reason.reason = static_cast<std::uint32_t>(ResetReason::start_without_reset) + 1U;
    no_reason.check = detail::check_of(no_reason);
    EXPECT_EQ(begin_run(no_reason), ResetReason::power_on);
}

TEST(FaultRecord, TheCountOfResetsStaysAtItsLargestValue) {
    FaultRecord record{};
    begin_run(record);
    record.resets = 0xFFFF'FFFEU;
    record.check = detail::check_of(record);
    for (int reset = 0; reset < 3; ++reset) {
        EXPECT_NE(begin_run(record), ResetReason::power_on);
        EXPECT_EQ(record.resets, 0xFFFF'FFFFU);
    }
}

}  // namespace
}  // namespace rsi::hal::zynqmp_r5
