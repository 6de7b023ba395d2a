// The diagnostic memory: how long each code looks before it says so, how long it takes to heal, what it keeps
// of its first occurrence, and in which order the codes are reported. The table is that of
// docs/safety.md.
#include "rsi/ecu/monitoring/diagnostic_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <set>
#include <vector>

#include "tests/support/memory_damage.hpp"

namespace monitoring_diagnostic_memory_test {
namespace {

using rsi::monitoring::DiagnosticCode;
using rsi::monitoring::DiagnosticMemory;
using rsi::monitoring::DiagnosticRecord;
using rsi::monitoring::EventStatus;
using rsi::monitoring::set_of;

// In cycles; `confirmed` with the fault in each of them, `healed` without it in any.
struct StatedDebounce {
    DiagnosticCode code;
    int confirmed;
    int healed;
};

constexpr StatedDebounce stated_debounces[] = {
    {DiagnosticCode::imu_lost, 1, 10},
    {DiagnosticCode::roll_angle_lost, 1, 10},
    {DiagnosticCode::vehicle_motion_lost, 1, 10},
    {DiagnosticCode::imu_damaged, 3, 100},
    {DiagnosticCode::roll_angle_damaged, 3, 100},
    {DiagnosticCode::vehicle_motion_damaged, 3, 100},
    {DiagnosticCode::lateral_acceleration_invalid, 3, 5},
    {DiagnosticCode::vertical_acceleration_invalid, 3, 5},
    {DiagnosticCode::roll_rate_invalid, 3, 5},
    {DiagnosticCode::roll_angle_invalid, 3, 5},
    {DiagnosticCode::yaw_rate_invalid, 3, 5},
    {DiagnosticCode::speed_invalid, 3, 5},
    {DiagnosticCode::steering_invalid, 3, 5},
    {DiagnosticCode::bank_angle_invalid, 3, 5},
    {DiagnosticCode::lateral_acceleration_jump, 3, 50},
    {DiagnosticCode::vertical_acceleration_jump, 3, 50},
    {DiagnosticCode::roll_rate_jump, 3, 50},
    {DiagnosticCode::roll_angle_jump, 3, 50},
    {DiagnosticCode::yaw_rate_jump, 3, 50},
    {DiagnosticCode::speed_jump, 3, 50},
    {DiagnosticCode::steering_jump, 3, 50},
    {DiagnosticCode::lateral_acceleration_stuck, 1, 20},
    {DiagnosticCode::vertical_acceleration_stuck, 1, 20},
    {DiagnosticCode::roll_rate_stuck, 1, 20},
    {DiagnosticCode::roll_angle_stuck, 1, 20},
    {DiagnosticCode::yaw_rate_stuck, 1, 20},
    {DiagnosticCode::speed_stuck, 1, 20},
    {DiagnosticCode::steering_stuck, 1, 20},
    {DiagnosticCode::vertical_acceleration_offset, 3, 100},
    {DiagnosticCode::roll_rate_contradicts_roll_angle, 3, 100},
    {DiagnosticCode::roll_rate_offset, 3, 100},
    {DiagnosticCode::lateral_acceleration_contradicts_yaw_rate, 1, 100},
    {DiagnosticCode::roll_sensor_contradicts_observer, 1, 100},
    {DiagnosticCode::yaw_rate_contradicts_lateral_acceleration, 1, 100},
    {DiagnosticCode::parameters_refused, 1, 1},
    {DiagnosticCode::parameters_damaged, 1, 100},
    {DiagnosticCode::estimate_out_of_range, 1, 100},
    {DiagnosticCode::output_not_finite, 1, 100},
    {DiagnosticCode::cycle_overrun, 1, 100},
    {DiagnosticCode::cycle_stall, 1, 100},
    {DiagnosticCode::clock_jump, 1, 100},
    {DiagnosticCode::bus_error, 3, 100},
    {DiagnosticCode::receive_overflow, 1, 100},
    {DiagnosticCode::roll_angle_reference_wrong, 1, 500},
    {DiagnosticCode::lateral_acceleration_gain, 1, 20},
    {DiagnosticCode::memory_restored, 1, 100},
    {DiagnosticCode::imu_two_senders, 1, 100},
    {DiagnosticCode::roll_angle_two_senders, 1, 100},
    {DiagnosticCode::vehicle_motion_two_senders, 1, 100},
    {DiagnosticCode::own_identifier_received, 1, 100},
    {DiagnosticCode::imu_held_back, 1, 100},
    {DiagnosticCode::stored_parameters_refused, 1, 1},
    {DiagnosticCode::storage_failed, 1, 1},
    {DiagnosticCode::vehicle_mass_invalid, 3, 5},
    {DiagnosticCode::vehicle_mass_jump, 3, 50},
    {DiagnosticCode::vehicle_mass_contradicts_load, 3, 100},
};

class ADiagnosticMemory : public ::testing::Test {
 protected:
    void report(DiagnosticCode code, bool failed, int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            memory.report(code, failed);
        }
    }

    // Seen for as long as any code takes.
    void confirm(DiagnosticCode code) { report(code, true, 3); }

    DiagnosticMemory memory;
};

TEST_F(ADiagnosticMemory, ConfirmsAtOnceWhatWasDebouncedElsewhere) {
    memory.confirm(DiagnosticCode::speed_jump);
    EXPECT_TRUE(memory.confirmed(DiagnosticCode::speed_jump));
    EXPECT_EQ(memory.next().code, DiagnosticCode::speed_jump);
    report(DiagnosticCode::speed_jump, false, 50);  // and heals as any other
    EXPECT_EQ(memory.status(DiagnosticCode::speed_jump), EventStatus::healed);
}

TEST_F(ADiagnosticMemory, ConfirmsAndHealsEachCodeAfterTheStatedCycles) {
    std::set<DiagnosticCode> codes;
    for (const StatedDebounce& stated : stated_debounces) {
        SCOPED_TRACE(static_cast<int>(stated.code));
        EXPECT_TRUE(codes.insert(stated.code).second);
        report(stated.code, true, stated.confirmed - 1);
        EXPECT_EQ(memory.status(stated.code), stated.confirmed > 1 ? EventStatus::set : EventStatus::none);
        report(stated.code, true, 1);
        EXPECT_EQ(memory.status(stated.code), EventStatus::confirmed);
        EXPECT_TRUE(memory.confirmed(stated.code));
        report(stated.code, false, stated.healed - 1);
        EXPECT_EQ(memory.status(stated.code), EventStatus::confirmed);
        report(stated.code, false, 1);
        EXPECT_EQ(memory.status(stated.code), EventStatus::healed);
        EXPECT_FALSE(memory.confirmed(stated.code));
    }
    EXPECT_EQ(codes.size(), rsi::monitoring::diagnostic_code_count - 1U);  // all but `none`
}

TEST_F(ADiagnosticMemory, KeepsEachCodeConfirmedAsLongAsTheFaultIsThere) {
    for (const StatedDebounce& stated : stated_debounces) {
        confirm(stated.code);
        for (int cycle = 0; cycle < 200; ++cycle) {
            memory.report(stated.code, true);
            ASSERT_EQ(memory.status(stated.code), EventStatus::confirmed) << static_cast<int>(stated.code);
        }
    }
}

// A cycle with the fault counts two, a good one takes one away: two, one, three, two, four, three, five,
// four, and the ninth cycle, the fifth with the fault, makes six.
TEST_F(ADiagnosticMemory, ConfirmsAFaultOfEverySecondCycleInTheNinthCycle) {
    constexpr DiagnosticCode code = DiagnosticCode::bus_error;
    for (int cycle = 1; cycle < 9; ++cycle) {
        memory.report(code, cycle % 2 == 1);
        EXPECT_EQ(memory.status(code), EventStatus::set) << cycle;
    }
    memory.report(code, true);
    EXPECT_EQ(memory.status(code), EventStatus::confirmed);
}

TEST_F(ADiagnosticMemory, ReportsAnEntryThatItHasWhateverBitOfItHasChanged) {
    memory.report(DiagnosticCode::speed_stuck, true);
    memory.report(DiagnosticCode::roll_angle_lost, true);
    static_cast<void>(memory.next());
    for (std::size_t byte = 0U; byte < sizeof memory; ++byte) {
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            DiagnosticMemory damaged = memory;
            rsi_test::flip(damaged, byte, bit);
            for (int cycle = 0; cycle < 3; ++cycle) {
                EXPECT_LT(static_cast<std::size_t>(damaged.next().code),
                          rsi::monitoring::diagnostic_code_count)
                    << byte << ' ' << bit;
            }
        }
    }
}

// The set is that of one cycle.
TEST_F(ADiagnosticMemory, KnowsWhichChecksHaveRunInACycle) {
    EXPECT_EQ(memory.tested_codes(), 0U);
    memory.add_tested(set_of(DiagnosticCode::imu_lost, DiagnosticCode::speed_jump));
    memory.add_tested(set_of(DiagnosticCode::storage_failed));
    EXPECT_EQ(memory.tested_codes(),
              set_of(DiagnosticCode::imu_lost, DiagnosticCode::speed_jump, DiagnosticCode::storage_failed));
    memory.begin_cycle({});
    EXPECT_EQ(memory.tested_codes(), 0U);
}

// 127 is a code that is confirmed, and stays so until it heals.
TEST_F(ADiagnosticMemory, CountsTowardsTheConfirmation) {
    const auto counters_of = [&](DiagnosticCode code, std::initializer_list<bool> cycles) {
        std::vector<int> counters;
        for (const bool failed : cycles) {
            memory.report(code, failed);
            counters.push_back(memory.fault_detection_counter(code));
        }
        return counters;
    };
    EXPECT_EQ(memory.fault_detection_counter(DiagnosticCode::speed_jump), 0U);
    EXPECT_EQ(counters_of(DiagnosticCode::speed_jump, {true, false, false, true, true, false, true, false}),
              (std::vector<int>{42, 21, 0, 42, 84, 63, 105, 84}));
    EXPECT_EQ(counters_of(DiagnosticCode::speed_jump, {true, false, true}),
              (std::vector<int>{127, 127, 127}));
    EXPECT_EQ(counters_of(DiagnosticCode::imu_lost, {true}), (std::vector<int>{127}));
    report(DiagnosticCode::imu_lost, false, 10);
    EXPECT_EQ(memory.fault_detection_counter(DiagnosticCode::imu_lost), 0U) << "healed";
}

TEST_F(ADiagnosticMemory, BeginsCountsAnewThatHaveNotConfirmedTheirCode) {
    const auto all = ~rsi::monitoring::CodeSet{0U};
    memory.report(DiagnosticCode::speed_jump, true);
    memory.report(DiagnosticCode::imu_damaged, true);
    memory.report(DiagnosticCode::imu_lost, true);
    memory.report(DiagnosticCode::roll_angle_lost, true);
    report(DiagnosticCode::roll_angle_lost, false, 10);
    memory.restart(set_of(DiagnosticCode::speed_jump));
    EXPECT_EQ(memory.status(DiagnosticCode::speed_jump), EventStatus::none);
    EXPECT_EQ(memory.status(DiagnosticCode::imu_damaged), EventStatus::set) << "it was not asked for";
    EXPECT_EQ(memory.active_codes(), set_of(DiagnosticCode::imu_damaged, DiagnosticCode::imu_lost));
    memory.restart(all);
    EXPECT_EQ(memory.status(DiagnosticCode::imu_lost), EventStatus::confirmed);
    EXPECT_EQ(memory.status(DiagnosticCode::roll_angle_lost), EventStatus::healed);
    EXPECT_EQ(memory.active_codes(), set_of(DiagnosticCode::imu_lost));
    report(DiagnosticCode::imu_damaged, true, 2);
    EXPECT_FALSE(memory.confirmed(DiagnosticCode::imu_damaged)) << "nothing of before counts";
    memory.report(DiagnosticCode::imu_damaged, true);
    EXPECT_TRUE(memory.confirmed(DiagnosticCode::imu_damaged));
    report(DiagnosticCode::imu_damaged, false, 100);
    memory.report(DiagnosticCode::imu_damaged, true);
    memory.restart(all);
    EXPECT_EQ(memory.status(DiagnosticCode::imu_damaged), EventStatus::healed)
        << "it has been confirmed before";
    report(DiagnosticCode::imu_lost, false, 9);
    memory.restart(all);
    report(DiagnosticCode::imu_lost, false, 1);
    EXPECT_FALSE(memory.confirmed(DiagnosticCode::imu_lost)) << "healing goes on";
}

TEST_F(ADiagnosticMemory, KnowsTheSetsOfActiveAndConfirmedCodes) {
    constexpr DiagnosticCode slow = DiagnosticCode::speed_invalid;  // 3 cycles, heals in 5
    constexpr DiagnosticCode last = DiagnosticCode::lateral_acceleration_gain;
    EXPECT_EQ(memory.active_codes(), 0U);
    memory.report(slow, true);
    EXPECT_EQ(memory.active_codes(), rsi::monitoring::set_of(slow));
    EXPECT_EQ(memory.confirmed_codes(), 0U);
    EXPECT_TRUE(memory.active(slow));
    EXPECT_FALSE(memory.active(last));
    memory.report(slow, true);
    memory.report(slow, true);
    memory.report(last, true);
    EXPECT_EQ(memory.active_codes(), rsi::monitoring::set_of(slow, last));
    EXPECT_EQ(memory.confirmed_codes(), rsi::monitoring::set_of(slow, last));
    for (int cycle = 0; cycle < 5; ++cycle) {
        memory.report(slow, false);
    }
    EXPECT_FALSE(memory.active(slow));
    EXPECT_EQ(memory.active_codes(), rsi::monitoring::set_of(last));
    EXPECT_EQ(memory.confirmed_codes(), rsi::monitoring::set_of(last));
}

TEST_F(ADiagnosticMemory, ForgetsASightingAfterTwiceAsManyGoodCycles) {
    constexpr DiagnosticCode code = DiagnosticCode::bus_error;
    report(code, true, 2);
    report(code, false, 3);
    EXPECT_EQ(memory.status(code), EventStatus::set);
    report(code, false, 1);
    EXPECT_EQ(memory.status(code), EventStatus::none);
    report(code, false, 50);  // good cycles are not saved up against a later fault
    report(code, true, 3);
    EXPECT_EQ(memory.status(code), EventStatus::confirmed);
}

TEST_F(ADiagnosticMemory, HealsByGoodCyclesInARowOnlyAndFromThereDebouncesAnew) {
    constexpr DiagnosticCode code = DiagnosticCode::speed_invalid;
    confirm(code);
    report(code, false, 4);
    report(code, true, 1);
    report(code, false, 4);
    EXPECT_EQ(memory.status(code), EventStatus::confirmed);
    report(code, false, 1);
    EXPECT_EQ(memory.status(code), EventStatus::healed);
    report(code, true, 2);
    EXPECT_EQ(memory.status(code), EventStatus::set);
    report(code, true, 1);
    EXPECT_EQ(memory.status(code), EventStatus::confirmed);
    report(code, false, 5);
    report(code, true, 1);
    report(code, false, 2);  // seen, and gone again
    EXPECT_EQ(memory.status(code), EventStatus::healed);
}

TEST_F(ADiagnosticMemory, LeavesEveryOtherCodeAsItIs) {
    confirm(DiagnosticCode::speed_jump);
    for (const StatedDebounce& other : stated_debounces) {
        if (other.code != DiagnosticCode::speed_jump) {
            EXPECT_EQ(memory.status(other.code), EventStatus::none);
        }
    }
    EXPECT_EQ(memory.status(DiagnosticCode::none), EventStatus::none);
}

TEST_F(ADiagnosticMemory, KeepsWhatWasMeasuredAtTheFirstConfirmationAndNothingLater) {
    constexpr DiagnosticCode code = DiagnosticCode::bus_error;
    for (const float cycle : {1.0F, 2.0F, 3.0F}) {  // confirmed in the third
        memory.begin_cycle({cycle, 10.0F + cycle, 20.0F + cycle, 30.0F + cycle});
        memory.report(code, true);
    }
    memory.begin_cycle({4.0F, 14.0F, 24.0F, 34.0F});
    report(code, false, 100);
    confirm(code);
    const DiagnosticRecord record = memory.next();
    EXPECT_EQ(record.code, code);
    EXPECT_EQ(record.status, EventStatus::confirmed);
    EXPECT_EQ(record.occurrences, 2U);
    EXPECT_EQ(record.first.lateral_acceleration_mps2, 3.0F);
    EXPECT_EQ(record.first.roll_rate_radps, 13.0F);
    EXPECT_EQ(record.first.roll_angle_rad, 23.0F);
    EXPECT_EQ(record.first.speed_mps, 33.0F);
}

TEST_F(ADiagnosticMemory, HasMeasuredNothingOfACodeThatIsOnlySet) {
    memory.begin_cycle({1.0F, 2.0F, 3.0F, 4.0F});
    memory.report(DiagnosticCode::bus_error, true);
    const DiagnosticRecord record = memory.next();
    EXPECT_EQ(record.code, DiagnosticCode::bus_error);
    EXPECT_EQ(record.status, EventStatus::set);
    EXPECT_EQ(record.occurrences, 0U);
    EXPECT_TRUE(std::isnan(record.first.lateral_acceleration_mps2));
    EXPECT_TRUE(std::isnan(record.first.roll_rate_radps));
    EXPECT_TRUE(std::isnan(record.first.roll_angle_rad));
    EXPECT_TRUE(std::isnan(record.first.speed_mps));
}

TEST_F(ADiagnosticMemory, TellsTheOnlyEntryInEveryCycleWhicheverItIs) {
    for (const DiagnosticCode code :
         {DiagnosticCode::imu_lost, DiagnosticCode::vehicle_mass_contradicts_load}) {
        memory = {};
        confirm(code);
        for (int cycle = 0; cycle < 5; ++cycle) {
            EXPECT_EQ(memory.next().code, code);
        }
    }
}

// Codes with something to report come one a cycle, in the order of the codes, and the first follows the
// last.
TEST_F(ADiagnosticMemory, TellsAllEntriesRoundAndRound) {
    for (const StatedDebounce& entry : stated_debounces) {
        confirm(entry.code);
    }
    std::set<DiagnosticCode> unreported;
    for (std::size_t cycle = 1U; cycle < rsi::monitoring::diagnostic_code_count; ++cycle) {
        EXPECT_TRUE(unreported.insert(memory.next().code).second);
    }
    for (int round = 0; round < 2; ++round) {
        for (std::size_t code = 1U; code < rsi::monitoring::diagnostic_code_count; ++code) {
            EXPECT_EQ(memory.next().code, static_cast<DiagnosticCode>(code));
        }
    }
}

TEST_F(ADiagnosticMemory, TellsEachConfirmationAtOnceAndOnlyOnce) {
    confirm(DiagnosticCode::imu_lost);
    confirm(DiagnosticCode::speed_jump);
    confirm(DiagnosticCode::clock_jump);
    for (int cycle = 0; cycle < 5; ++cycle) {
        memory.next();  // three unreported, then two of the round
    }
    confirm(DiagnosticCode::roll_rate_jump);
    EXPECT_EQ(memory.next().code, DiagnosticCode::roll_rate_jump);
    EXPECT_EQ(memory.next().code, DiagnosticCode::clock_jump);  // the round goes on
    EXPECT_EQ(memory.next().code, DiagnosticCode::imu_lost);

    report(DiagnosticCode::clock_jump, false, 100);
    confirm(DiagnosticCode::clock_jump);  // again is unreported too
    EXPECT_EQ(memory.next().code, DiagnosticCode::clock_jump);
    EXPECT_EQ(memory.next().code, DiagnosticCode::roll_rate_jump);
}

}  // namespace
}  // namespace monitoring_diagnostic_memory_test
