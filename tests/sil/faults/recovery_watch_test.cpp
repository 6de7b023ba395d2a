// The time from the end of a fault to the agreement of both ECUs, at every limit.
#include "sil/studies/faults/recovery_watch.hpp"

#include <gtest/gtest.h>

namespace recovery_watch_test {
namespace {

constexpr std::uint64_t over = 50U;
constexpr bool stands = true;

// A fault that ends with cycle 50 of a drive.
class Recovery {
 public:
    Recovery() { watch_.begin(over); }

    Recovery& cycles(int count, bool agrees, bool standing = false) {
        for (int cycle = 0; cycle < count; ++cycle) {
            watch_.cycle(number_++, agrees, standing);
        }
        return *this;
    }
    const sil::RecoveryWatch& watch() const { return watch_; }

 private:
    sil::RecoveryWatch watch_{};
    std::uint64_t number_{0U};
};

// Until the fault is over.
Recovery fault(bool agrees = false) {
    return Recovery{}.cycles(static_cast<int>(over), agrees);
}

TEST(RecoveryWatch, AgreementHasToLastASecond) {
    EXPECT_FALSE(fault().cycles(100, true).watch().has_recovered());
    EXPECT_TRUE(fault().cycles(101, true).watch().has_recovered());
    EXPECT_EQ(fault().cycles(101, true).watch().driven_ms(), 0);
}

TEST(RecoveryWatch, CountsFromTheEndOfTheFault) {
    EXPECT_FALSE(fault(true).cycles(100, true).watch().has_recovered()) << "agreement while it was there";
    EXPECT_TRUE(fault(true).cycles(101, true).watch().has_recovered());
}

TEST(RecoveryWatch, MeasuresTheDriveToTheLastDisagreement) {
    const Recovery late = fault().cycles(7, false).cycles(50, true).cycles(3, false).cycles(100, true);
    EXPECT_FALSE(late.watch().has_recovered());
    const Recovery back = Recovery{late}.cycles(1, true);
    EXPECT_TRUE(back.watch().has_recovered());
    EXPECT_EQ(back.watch().driven_ms(), 600);
}

TEST(RecoveryWatch, EventsAfterRecoveryNoLongerCount) {
    const Recovery back = fault().cycles(2, false).cycles(101, true).cycles(2000, false);
    EXPECT_TRUE(back.watch().has_recovered());
    EXPECT_EQ(back.watch().driven_ms(), 20);
    EXPECT_FALSE(back.watch().is_past_limit());
}

TEST(RecoveryWatch, GivesUpAfterTenSecondsOfDriving) {
    EXPECT_FALSE(fault().cycles(999, false).watch().is_past_limit());
    EXPECT_TRUE(fault().cycles(1000, false).watch().is_past_limit());
    EXPECT_FALSE(fault().cycles(1000, false).watch().has_recovered());
    EXPECT_FALSE(fault().cycles(999, false).cycles(5000, false, stands).watch().is_past_limit());
}

TEST(RecoveryWatch, TimeAtAStandstillIsNoTimeOfDriving) {
    const Recovery back = fault().cycles(300, false, stands).cycles(4, false).cycles(101, true);
    EXPECT_TRUE(back.watch().has_recovered());
    EXPECT_EQ(back.watch().driven_ms(), 40);
}

TEST(RecoveryWatch, TellsOfFaultsThatEndAtAStandstill) {
    EXPECT_TRUE(fault().cycles(1, false, stands).watch().was_over_at_standstill());
    EXPECT_TRUE(fault().cycles(1, false, stands).cycles(9, false).watch().was_over_at_standstill());
    EXPECT_FALSE(fault().cycles(1, false).cycles(9, false, stands).watch().was_over_at_standstill());
    EXPECT_FALSE(Recovery{}.cycles(50, false, stands).cycles(1, false).watch().was_over_at_standstill());
}

TEST(RecoveryWatch, TellsOfRecoveryBeforeTheVehicleMovesAgain) {
    EXPECT_TRUE(fault().cycles(101, true, stands).watch().has_recovered_at_standstill());
    EXPECT_FALSE(fault().cycles(100, true, stands).watch().has_recovered_at_standstill());
    EXPECT_FALSE(fault().cycles(101, true).watch().has_recovered_at_standstill());
    EXPECT_FALSE(fault().cycles(1, true).cycles(100, true, stands).watch().has_recovered_at_standstill());
    EXPECT_FALSE(fault().cycles(100, true, stands).cycles(1, true).watch().has_recovered_at_standstill());
}

TEST(RecoveryWatch, BeginsAnewWithTheNextFault) {
    sil::RecoveryWatch watch;
    watch.begin(0U);
    for (std::uint64_t cycle = 0U; cycle < 101U; ++cycle) {
        watch.cycle(cycle, true, stands);
    }
    ASSERT_TRUE(watch.has_recovered_at_standstill());
    watch.begin(200U);
    EXPECT_FALSE(watch.has_recovered());
    EXPECT_FALSE(watch.was_over_at_standstill());
    EXPECT_FALSE(watch.has_recovered_at_standstill());
}

}  // namespace
}  // namespace recovery_watch_test
