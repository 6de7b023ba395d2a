// Diagnostic codes: how they are set, confirmed and healed, and in which order they are reported.
#include "rsi/ecu/monitoring/diagnostic_memory.hpp"

#include <gtest/gtest.h>

#include "rsi/ecu/monitoring/diagnostic_event.hpp"
#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

using rsi::monitoring::Debounce;
using rsi::monitoring::DiagnosticCode;
using rsi::monitoring::DiagnosticEvent;
using rsi::monitoring::DiagnosticMemory;
using rsi::monitoring::EventStatus;
using rsi::monitoring::Snapshot;

constexpr Debounce three_and_five{3U, 5U};

void update(DiagnosticEvent& event, bool failed, int cycles) {
    for (int cycle = 0; cycle < cycles; ++cycle) {
        event.update(failed, three_and_five);
    }
}

TEST(DiagnosticEvent, IsSetThenConfirmedThenHealed) {
    DiagnosticEvent event;
    update(event, false, 3);
    EXPECT_EQ(event.status(), EventStatus::none);
    update(event, true, 2);
    EXPECT_EQ(event.status(), EventStatus::set);
    EXPECT_TRUE(event.update(true, three_and_five));
    EXPECT_TRUE(event.confirmed());
    EXPECT_FALSE(event.update(true, three_and_five));  // confirmed once
    update(event, false, 4);
    EXPECT_TRUE(event.confirmed());
    update(event, true, 1);  // not five in a row
    update(event, false, 4);
    EXPECT_TRUE(event.confirmed());
    update(event, false, 1);
    EXPECT_EQ(event.status(), EventStatus::healed);
    EXPECT_EQ(event.occurrences(), 1U);
    update(event, true, 1);
    EXPECT_EQ(event.status(), EventStatus::set);
    update(event, false, 2);
    EXPECT_EQ(event.status(), EventStatus::healed);
}

TEST(DiagnosticEvent, OfEverySecondCycleIsConfirmedOfEveryThirdNever) {
    DiagnosticEvent second;
    DiagnosticEvent third;
    for (int cycle = 0; cycle < 300; ++cycle) {
        second.update(cycle % 2 == 0, three_and_five);
        third.update(cycle % 3 == 0, three_and_five);
        EXPECT_NE(third.status(), EventStatus::confirmed);
    }
    EXPECT_EQ(second.status(), EventStatus::confirmed);
}

TEST(DiagnosticEvent, CountsUpTo31Occurrences) {
    DiagnosticEvent event;
    for (int occurrence = 1; occurrence <= 40; ++occurrence) {
        update(event, true, 3);
        update(event, false, 5);
        EXPECT_EQ(event.occurrences(), occurrence < 31 ? occurrence : 31);
    }
}

// An inactive code may be passed over, so inactive and active must be distinguished exactly.
TEST(DiagnosticMemory, RestsWhenNoCodeIsSetOrConfirmed) {
    constexpr DiagnosticCode one = DiagnosticCode::speed_invalid;     // 3 cycles, 5 good ones heal
    constexpr DiagnosticCode other = DiagnosticCode::roll_rate_jump;  // set, then forgotten
    DiagnosticMemory memory;
    memory.report(one, false);
    EXPECT_TRUE(memory.no_active_codes());
    memory.report(other, true);
    EXPECT_FALSE(memory.no_active_codes());
    for (int cycle = 0; cycle < 3; ++cycle) {
        memory.report(one, true);
        memory.report(other, false);
        EXPECT_FALSE(memory.no_active_codes());
    }
    EXPECT_EQ(memory.status(other), EventStatus::none);
    EXPECT_TRUE(memory.confirmed(one));
    for (int good = 1; good <= 5; ++good) {
        memory.report(one, false);
        EXPECT_EQ(memory.no_active_codes(), good == 5);
    }
    EXPECT_EQ(memory.status(one), EventStatus::healed);
}

TEST(DiagnosticMemory, KeepsWhatWasMeasuredTheFirstTime) {
    DiagnosticMemory memory;
    const auto occur = [&memory](float speed_mps) {
        memory.begin_cycle(Snapshot{1.0F, 2.0F, 3.0F, speed_mps});
        memory.report(DiagnosticCode::cycle_stall, true);
        for (int cycle = 0; cycle < 100; ++cycle) {
            memory.report(DiagnosticCode::cycle_stall, false);
        }
    };
    occur(10.0F);
    occur(20.0F);
    const rsi::monitoring::DiagnosticRecord record = memory.next();
    EXPECT_EQ(record.code, DiagnosticCode::cycle_stall);
    EXPECT_EQ(record.status, EventStatus::healed);
    EXPECT_EQ(record.occurrences, 2U);
    EXPECT_EQ(record.first.speed_mps, 10.0F);
    EXPECT_EQ(record.first.lateral_acceleration_mps2, 1.0F);
}

TEST(DiagnosticMemory, TellsNothingOfNothing) {
    DiagnosticMemory memory;
    EXPECT_EQ(memory.next().code, DiagnosticCode::none);
    EXPECT_EQ(memory.next().status, EventStatus::none);
}

TEST(DiagnosticMemory, TellsNewsAtOnceAndTheRestRoundAndRound) {
    DiagnosticMemory memory;
    memory.report(DiagnosticCode::imu_lost, true);
    memory.report(DiagnosticCode::clock_jump, true);
    memory.report(DiagnosticCode::cycle_stall, true);
    for (int unreported = 0; unreported < 3; ++unreported) {
        memory.next();
    }
    EXPECT_EQ(memory.next().code, DiagnosticCode::imu_lost);
    EXPECT_EQ(memory.next().code, DiagnosticCode::cycle_stall);
    memory.report(DiagnosticCode::cycle_overrun, true);
    memory.report(DiagnosticCode::imu_damaged, true);
    memory.report(DiagnosticCode::imu_damaged, true);
    memory.report(DiagnosticCode::imu_damaged, true);
    EXPECT_EQ(memory.next().code, DiagnosticCode::imu_damaged);
    EXPECT_EQ(memory.next().code, DiagnosticCode::cycle_overrun);
    EXPECT_EQ(memory.next().code, DiagnosticCode::clock_jump);
    EXPECT_EQ(memory.next().code, DiagnosticCode::imu_lost);
}

// A code that is about to be confirmed, cleared: nothing of before counts.
TEST(TheEcusDiagnosticMemory, BeginsTheDebounceOfAClearedCodeAnew) {
    Bench bench;
    bench.run_until_ready();
    Motion motion;
    motion.vehicle_motion.yaw_rate_deg_per_s = rsi::can_dbc::not_available;
    bench.drive(motion);
    bench.run_cycles(1);
    bench.restart_debounce(0U);
    EXPECT_EQ(bench.diagnostic_memory().status(DiagnosticCode::yaw_rate_invalid), EventStatus::set);
    bench.restart_debounce(rsi::monitoring::set_of(DiagnosticCode::yaw_rate_invalid));
    EXPECT_EQ(bench.diagnostic_memory().status(DiagnosticCode::yaw_rate_invalid), EventStatus::none);
    bench.run_cycles(2);
    EXPECT_FALSE(bench.diagnostic_memory().confirmed(DiagnosticCode::yaw_rate_invalid));
    bench.run_cycles(1);
    EXPECT_TRUE(bench.diagnostic_memory().confirmed(DiagnosticCode::yaw_rate_invalid));
}

}  // namespace
}  // namespace testing_application
