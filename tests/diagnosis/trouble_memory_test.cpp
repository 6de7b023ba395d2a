// The trouble memory: status bytes of ISO 14229-1 over operation cycles, ageing, snapshots.
#include "rsi/ecu/diagnosis/trouble_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace testing_diagnosis {
namespace {

using rsi::diagnosis::FreezeFrame;
using rsi::diagnosis::Storing;
using rsi::diagnosis::trouble_code_count;
using rsi::diagnosis::TroubleMemory;
using rsi::diagnosis::TroubleSnapshots;
using rsi::monitoring::CodeSet;
using rsi::monitoring::DiagnosticCode;
using rsi::monitoring::set_of;
using rsi::monitoring::Snapshot;
namespace status = rsi::diagnosis::status;

constexpr std::size_t row_of(DiagnosticCode code) {
    return static_cast<std::size_t>(code) - 1U;
}
constexpr std::size_t imu = row_of(DiagnosticCode::imu_lost);
constexpr std::size_t gain = row_of(DiagnosticCode::lateral_acceleration_gain);
constexpr std::size_t last_row = row_of(DiagnosticCode::vehicle_mass_contradicts_load);
constexpr CodeSet imu_failed = set_of(DiagnosticCode::imu_lost);
constexpr CodeSet gain_failed = set_of(DiagnosticCode::lateral_acceleration_gain);
constexpr CodeSet all = (CodeSet{2U} << trouble_code_count) - 2U;
constexpr int heal_of_imu = 10;
constexpr int heal_of_gain = 20;
constexpr int longest_heal = 500;
constexpr std::uint8_t failing = status::test_failed | status::failed_this_cycle | status::pending |
                                 status::confirmed | status::failed_since_clear;

// A number of a snapshot.
int number_in(const FreezeFrame& frame, std::size_t place) {
    return static_cast<std::int16_t>(frame.at(place) * 256U + frame.at(place + 1U));
}
unsigned seconds_in(const FreezeFrame& frame) {
    return frame[8] * 256U + frame[9];
}
template <typename Bytes>
unsigned word_in(const Bytes& bytes, std::size_t place = 0U) {
    unsigned word = 0U;
    for (std::size_t byte = place; byte < place + 4U; ++byte) {
        word = word * 256U + bytes.at(byte);
    }
    return word;
}

class Troubles : public ::testing::Test {
 protected:
    Troubles() {
        memory_.start(true);
        memory_.stored();
    }
    // `tested`: checks that run; `active`: codes that are about to fail.
    void run(int cycles, CodeSet failed = 0U, const Snapshot& measured = {}) {
        turn(cycles, failed, 0U, 0U, measured);
    }
    void run_tests(int cycles, CodeSet tested, CodeSet failed = 0U, CodeSet active = 0U) {
        turn(cycles, failed, tested, active, {});
    }
    unsigned status_of(std::size_t row) const { return memory_.state(row).status; }
    // A whole operation cycle, good or with a failure.
    void drive(CodeSet failed = 0U) {
        memory_.start(true);
        run_tests(longest_heal, all);
        run(1, failed);
    }

    TroubleMemory memory_{};
    unsigned checksum_{0U};

 private:
    void turn(int cycles, CodeSet failed, CodeSet tested, CodeSet active, const Snapshot& measured) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            memory_.update({failed, failed | active, tested}, measured, checksum_);
        }
    }
};

TEST_F(Troubles, NothingIsKnownAtFirst) {
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        EXPECT_EQ(status_of(row), 0x50U);
        EXPECT_EQ(memory_.snapshots(row), nullptr);
    }
}

TEST_F(Troubles, AFailureSetsItsBitsAndOnlyItsOwn) {
    run(1, imu_failed);
    EXPECT_EQ(status_of(imu), failing);
    EXPECT_EQ(status_of(imu), 0x2FU);
    EXPECT_EQ(memory_.state(imu).occurrences, 1U);
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        EXPECT_TRUE(row == imu || status_of(row) == 0x50U);
    }
    run(1);
    EXPECT_EQ(status_of(imu), 0x2EU);
    run(1, set_of(DiagnosticCode::vehicle_mass_contradicts_load));
    EXPECT_EQ(status_of(last_row), 0x2FU);
}

TEST_F(Troubles, EachFailureIsCountedOnceAndTheCountStands) {
    run(5, imu_failed);
    EXPECT_EQ(memory_.state(imu).occurrences, 1U);
    for (int time = 0; time < 300; ++time) {
        run(1);
        run(1, imu_failed);
    }
    EXPECT_EQ(memory_.state(imu).occurrences, 255U);
    memory_.stored();
    run(1);
    run(1, imu_failed);
    EXPECT_EQ(memory_.state(imu).occurrences, 255U);
    EXPECT_EQ(memory_.storing(), Storing::not_needed) << "nothing that counts further";
    memory_.start(true);
    memory_.stored();
    run(1, imu_failed);
    EXPECT_EQ(memory_.storing(), Storing::now) << "the first of an operation cycle";
}

TEST_F(Troubles, ResetsAreCountedOverStartsAndNotOverOperationCycles) {
    for (unsigned reset = 0U; reset < TroubleMemory::most_resets; ++reset) {
        EXPECT_TRUE(memory_.takes_reset());
        memory_.stored();
        memory_.count_reset();
        EXPECT_EQ(memory_.storing(), Storing::now);
        memory_.start(false);
    }
    EXPECT_FALSE(memory_.takes_reset());
    TroubleMemory other;
    other.restore(memory_.stored_data());
    other.start(false);
    EXPECT_FALSE(other.takes_reset());
    other.start(true);
    EXPECT_TRUE(other.takes_reset());
}

// After as many good tests as heal it: each code by itself.
TEST_F(Troubles, ATestIsCompletedAfterAsManyCyclesAsHealItsCode) {
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        const CodeSet code = CodeSet{2U} << row;
        const int heal = rsi::monitoring::debounce_of(static_cast<DiagnosticCode>(row + 1U)).heal;
        ASSERT_LE(heal, longest_heal) << "what can be counted";
        memory_.stored();
        run_tests(heal - 1, code);
        EXPECT_EQ(status_of(row), 0x50U) << row;
        EXPECT_EQ(memory_.storing(), Storing::not_needed);
        run_tests(1, code);
        EXPECT_EQ(status_of(row), 0x00U) << row;
        EXPECT_EQ(memory_.storing(), Storing::later);
        memory_.stored();
        run_tests(longest_heal, code);
        EXPECT_EQ(memory_.storing(), Storing::not_needed) << "once";
    }
}

// A restored record that is complete has nothing left to count, whatever was open before.
TEST_F(Troubles, AStartCountsOnlyTheTestsThatItsRecordLacks) {
    run_tests(longest_heal, all);
    TroubleMemory other;
    other.start(true);
    other.restore(memory_.stored_data());
    other.start(false);
    other.stored();
    for (int cycle = 0; cycle < longest_heal; ++cycle) {
        other.update({0U, 0U, all}, {}, 0U);
    }
    EXPECT_EQ(other.storing(), Storing::not_needed);
}

TEST_F(Troubles, ATestThatHasFailedIsNotCompletedAsWell) {
    run(1, imu_failed);
    memory_.stored();
    run_tests(longest_heal, imu_failed);
    EXPECT_EQ(memory_.storing(), Storing::not_needed);
}

TEST_F(Troubles, AStartForgetsWhichCodesWereJustCleared) {
    memory_.clear_all();
    ASSERT_NE(memory_.cleared_codes(), 0U);
    memory_.start(false);
    EXPECT_EQ(memory_.cleared_codes(), 0U);
}

TEST_F(Troubles, ACheckThatDoesNotRunCompletesNothing) {
    run(10000);
    run_tests(longest_heal, all & ~gain_failed);
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        EXPECT_EQ(status_of(row), (row == gain) ? 0x50U : 0x00U) << row;
    }
    run_tests(heal_of_gain - 1, gain_failed);
    run(100);  // it may pause
    EXPECT_EQ(status_of(gain), 0x50U);
    run_tests(1, gain_failed);
    EXPECT_EQ(status_of(gain), 0x00U);
}

// A fault that stays does not keep the others from being judged.
TEST_F(Troubles, ATestIsCompletedWhileAnotherCodeFails) {
    run_tests(longest_heal, all, imu_failed);
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        EXPECT_EQ(status_of(row), (row == imu) ? failing : 0x00U) << row;
    }
}

// A code that is about to be confirmed is not good, and good tests count in a row.
TEST_F(Troubles, GoodTestsCountInARow) {
    run_tests(longest_heal, imu_failed, 0U, imu_failed);
    EXPECT_EQ(status_of(imu), 0x50U) << "it never was good";
    run_tests(heal_of_imu - 1, imu_failed | gain_failed);
    run_tests(1, imu_failed, 0U, imu_failed);
    run_tests(heal_of_imu - 1, imu_failed);
    EXPECT_EQ(status_of(imu), 0x50U);
    run_tests(1, imu_failed, 0U, imu_failed);
    run_tests(heal_of_imu, imu_failed);
    EXPECT_EQ(status_of(imu), 0x00U);
    run_tests(heal_of_gain - heal_of_imu + 1, gain_failed);
    EXPECT_EQ(status_of(gain), 0x00U) << "the others' counts went on";
}

TEST_F(Troubles, ANewOperationCycleBeginsTheTestsAnew) {
    run(1, imu_failed);
    memory_.start(true);
    EXPECT_EQ(status_of(imu), 0x6CU) << "pending and confirmed stay, and that it failed since it was cleared";
    EXPECT_EQ(memory_.storing(), Storing::now);
    drive();
    memory_.start(true);
    EXPECT_EQ(status_of(imu), 0x68U) << "a cycle tested and without failure: no longer pending";
}

// After a repair it is judged without another start.
TEST_F(Troubles, AClearedCodeIsJudgedAnewInTheSameCycle) {
    run_tests(longest_heal, all);
    memory_.clear(imu);
    EXPECT_EQ(memory_.cleared_codes(), imu_failed);
    EXPECT_EQ(status_of(imu), status::cleared);
    run_tests(heal_of_imu - 1, all);
    EXPECT_EQ(memory_.cleared_codes(), 0U) << "told once";
    EXPECT_EQ(status_of(imu), status::cleared);
    EXPECT_EQ(status_of(gain), 0U);
    run_tests(1, all);
    EXPECT_EQ(status_of(imu), 0U);
    memory_.clear_all();
    EXPECT_EQ(memory_.cleared_codes(), all);
    run_tests(heal_of_gain - 1, all);
    EXPECT_EQ(status_of(imu), 0U);
    EXPECT_EQ(status_of(gain), status::cleared);
    run_tests(1, all);
    EXPECT_EQ(status_of(gain), 0U);
}

// A reset within an operation cycle is no new one.
TEST_F(Troubles, AResetIsNoNewCycle) {
    run(1, imu_failed);
    memory_.stored();
    memory_.start(false);
    EXPECT_EQ(status_of(imu), 0x2EU);
    EXPECT_EQ(memory_.storing(), Storing::not_needed);
    run(1, imu_failed);
    EXPECT_EQ(status_of(imu), 0x2FU);
    EXPECT_EQ(memory_.state(imu).occurrences, 2U);
    memory_.stored();
    run_tests(heal_of_gain - 1, gain_failed);
    memory_.start(false);
    run_tests(1, gain_failed);
    EXPECT_EQ(status_of(gain), 0x50U) << "the test begins anew";
    run_tests(heal_of_gain - 1, gain_failed);
    EXPECT_EQ(memory_.storing(), Storing::later);
    EXPECT_EQ(status_of(gain), 0x00U);
    memory_.stored();
    memory_.start(false);
    run_tests(longest_heal, gain_failed);
    EXPECT_EQ(memory_.storing(), Storing::not_needed) << "it has been completed";
}

TEST_F(Troubles, ACodeIsForgottenAfterFortyGoodCycles) {
    run(1, imu_failed | gain_failed);
    drive();
    EXPECT_EQ(memory_.state(imu).ageing, 0U) << "the cycle in which it failed";
    for (int cycle = 1; cycle < 40; ++cycle) {
        drive();
        EXPECT_EQ(memory_.state(imu).ageing, cycle);
    }
    EXPECT_EQ(status_of(imu), 0x28U);
    EXPECT_NE(memory_.snapshots(imu), nullptr);
    memory_.start(true);
    EXPECT_EQ(status_of(imu), 0x60U);
    EXPECT_EQ(memory_.state(imu).occurrences, 0U);
    EXPECT_EQ(memory_.state(imu).ageing, 0U);
    EXPECT_EQ(memory_.snapshots(imu), nullptr);
    EXPECT_EQ(status_of(gain), 0x60U);
}

TEST_F(Troubles, ARepairedCodeAgesWhileAnotherFaultStays) {
    run(1, imu_failed | gain_failed);
    for (int cycle = 0; cycle < 40; ++cycle) {
        memory_.start(true);
        run_tests(longest_heal, all, gain_failed);
    }
    EXPECT_EQ(memory_.state(imu).ageing, 39U);
    EXPECT_EQ(memory_.state(gain).ageing, 0U);
    memory_.start(true);
    EXPECT_EQ(status_of(imu), 0x60U) << "forgotten";
    EXPECT_EQ(status_of(gain), 0x6CU) << "failed in each cycle";
}

TEST_F(Troubles, ACycleWithoutTheTestDoesNotAge) {
    run(1, imu_failed | gain_failed);
    memory_.start(true);
    run_tests(1000, imu_failed);  // not driven
    memory_.start(true);
    EXPECT_EQ(memory_.state(imu).ageing, 1U);
    EXPECT_EQ(memory_.state(gain).ageing, 0U);
    EXPECT_EQ(status_of(gain), 0x6CU);
}

TEST_F(Troubles, AFailureAgesFromTheBeginning) {
    run(1, imu_failed);
    for (int cycle = 0; cycle < 20; ++cycle) {
        drive();
    }
    drive(imu_failed);
    EXPECT_EQ(memory_.state(imu).ageing, 0U);
    memory_.start(true);
    EXPECT_EQ(memory_.state(imu).ageing, 0U);
    EXPECT_EQ(status_of(imu), 0x6CU);
}

TEST_F(Troubles, ACodeThatNeverFailedDoesNotAge) {
    drive();
    drive();
    memory_.start(true);
    EXPECT_EQ(memory_.state(imu).ageing, 0U);
    EXPECT_EQ(status_of(imu), 0x40U);
}

TEST_F(Troubles, KeepsTheFirstAndTheLastSnapshot) {
    run(298);
    run(1, imu_failed, {1.234F, -0.5F, 0.0256F, 33.336F});
    run(1);
    run(150);
    run(1, imu_failed, {-2.0F, NAN, 1.0e9F, -1.0e9F});
    const TroubleSnapshots* const kept = memory_.snapshots(imu);
    ASSERT_NE(kept, nullptr);
    EXPECT_EQ(number_in(kept->first, 0U), 123);
    EXPECT_EQ(number_in(kept->first, 2U), -500);
    EXPECT_EQ(number_in(kept->first, 4U), 26);
    EXPECT_EQ(number_in(kept->first, 6U), 3334);
    EXPECT_EQ(seconds_in(kept->first), 2U);
    EXPECT_EQ(number_in(kept->last, 0U), -200);
    EXPECT_EQ(number_in(kept->last, 2U), -32768);
    EXPECT_EQ(number_in(kept->last, 4U), 32767);
    EXPECT_EQ(number_in(kept->last, 6U), -32767);
    EXPECT_EQ(seconds_in(kept->last), 4U);
}

// To the nearest step, on both sides of zero; zero is a number like others.
TEST_F(Troubles, SnapshotsAreRounded) {
    const auto kept = [&](const Snapshot& measured) {
        run(1);
        run(1, imu_failed, measured);
        return memory_.snapshots(imu)->last;
    };
    const FreezeFrame large = kept({1.2352F, -0.50052F, -0.02547F, 33.3347F});
    EXPECT_EQ(number_in(large, 0U), 124);
    EXPECT_EQ(number_in(large, 2U), -501);
    EXPECT_EQ(number_in(large, 4U), -25);
    EXPECT_EQ(number_in(large, 6U), 3333);
    const FreezeFrame small = kept({0.007F, -0.0007F, 0.0F, -0.003F});
    EXPECT_EQ(number_in(small, 0U), 1);
    EXPECT_EQ(number_in(small, 2U), -1);
    EXPECT_EQ(number_in(small, 4U), 0);
    EXPECT_EQ(number_in(small, 6U), 0);
}

TEST_F(Troubles, TheTimeOfASnapshotIsThatSinceTheStart) {
    run(500);
    memory_.start(true);
    run(98);
    run(1, imu_failed);
    EXPECT_EQ(seconds_in(memory_.snapshots(imu)->last), 0U);
    run(1);
    run(1, imu_failed);
    EXPECT_EQ(seconds_in(memory_.snapshots(imu)->last), 1U);
}

// A workshop tells by them in which of many journeys, and with which calibration, a fault was seen.
TEST_F(Troubles, ASnapshotHasTheOperationCycleAndTheCalibration) {
    EXPECT_EQ(word_in(memory_.operation_cycles()), 1U);
    checksum_ = 0x89ABCDEFU;
    run(1, imu_failed);
    for (int cycle = 0; cycle < 300; ++cycle) {
        memory_.start(true);
    }
    memory_.start(false);
    checksum_ = 0x01234567U;
    run(1, imu_failed);
    EXPECT_EQ(word_in(memory_.operation_cycles()), 301U) << "a reset is no new cycle";
    const TroubleSnapshots* const kept = memory_.snapshots(imu);
    ASSERT_NE(kept, nullptr);
    EXPECT_EQ(word_in(kept->first, 10U), 1U);
    EXPECT_EQ(word_in(kept->first, 14U), 0x89ABCDEFU);
    EXPECT_EQ(word_in(kept->last, 10U), 301U);
    EXPECT_EQ(word_in(kept->last, 14U), 0x01234567U);
    TroubleMemory other{};
    other.restore(memory_.stored_data());
    EXPECT_EQ(word_in(other.operation_cycles()), 301U);
    memory_.clear_all();
    EXPECT_EQ(word_in(memory_.operation_cycles()), 301U) << "it is of the ECU, not of a code";
    TroubleMemory::Stored old{};
    old.operation_cycles = {0x01U, 0xFFU, 0xFFU, 0xFFU};
    other.restore(old);
    other.start(true);
    EXPECT_EQ(word_in(other.operation_cycles()), 0x02000000U);
}

TEST_F(Troubles, TheTimeOfASnapshotStandsAtItsLargest) {
    memory_.set_recording(false);  // as quick as it goes
    run(6553600);
    memory_.set_recording(true);
    run(1, imu_failed);
    EXPECT_EQ(seconds_in(memory_.snapshots(imu)->first), 65535U);
}

TEST_F(Troubles, SnapshotsOfWhatFailsAreNotDisplaced) {
    CodeSet failed = 0U;
    for (std::size_t row = 0U; row < TroubleMemory::snapshot_places + 1U; ++row) {
        failed |= CodeSet{2U} << row;
        run(1, failed);
    }
    EXPECT_NE(memory_.snapshots(0U), nullptr);
    EXPECT_NE(memory_.snapshots(TroubleMemory::snapshot_places - 1U), nullptr);
    EXPECT_EQ(memory_.snapshots(TroubleMemory::snapshot_places), nullptr);
    EXPECT_EQ(status_of(TroubleMemory::snapshot_places), failing);

    failed &= ~(CodeSet{2U} << 3U);
    run(1, failed);
    run(1, failed | gain_failed);
    EXPECT_EQ(memory_.snapshots(3U), nullptr);
    EXPECT_NE(memory_.snapshots(gain), nullptr);
}

TEST_F(Troubles, AHealedCodeKeepsItsSnapshotsWhileThereIsRoom) {
    for (std::size_t row = 0U; row < TroubleMemory::snapshot_places; ++row) {
        run(1, CodeSet{2U} << row);
    }
    for (std::size_t row = 0U; row < TroubleMemory::snapshot_places; ++row) {
        EXPECT_NE(memory_.snapshots(row), nullptr) << row;
    }
}

TEST_F(Troubles, ClearingOneLeavesTheOthers) {
    run(1, imu_failed | gain_failed);
    run(1);
    memory_.stored();
    memory_.clear(imu);
    EXPECT_EQ(status_of(imu), 0x50U);
    EXPECT_EQ(memory_.state(imu).occurrences, 0U);
    EXPECT_EQ(memory_.snapshots(imu), nullptr);
    EXPECT_EQ(status_of(gain), 0x2EU);
    EXPECT_NE(memory_.snapshots(gain), nullptr);
    EXPECT_EQ(memory_.storing(), Storing::now);
}

TEST_F(Troubles, ACodeThatStillFailsFailsAnewAfterClearing) {
    run(1, imu_failed | gain_failed);
    memory_.clear_all();
    EXPECT_EQ(status_of(imu), 0x50U);
    EXPECT_EQ(status_of(gain), 0x50U);
    run(1, imu_failed);
    EXPECT_EQ(status_of(imu), failing);
    EXPECT_EQ(status_of(gain), 0x50U);
    EXPECT_EQ(memory_.state(imu).occurrences, 1U);
}

TEST_F(Troubles, NothingIsRecordedWhileItIsOff) {
    run(1, imu_failed);
    memory_.set_recording(false);
    run_tests(1000, all, gain_failed);
    EXPECT_EQ(status_of(imu), failing);
    EXPECT_EQ(status_of(gain), 0x50U);
    EXPECT_EQ(status_of(last_row), 0x50U);
    memory_.set_recording(true);
    run(1, gain_failed);
    EXPECT_EQ(status_of(imu), 0x2EU);
    EXPECT_EQ(status_of(gain), failing);
}

TEST_F(Troubles, ARepeatedFailureIsStoredLater) {
    run(1, imu_failed);
    EXPECT_EQ(memory_.storing(), Storing::now);
    memory_.stored();
    run(1);
    EXPECT_EQ(memory_.storing(), Storing::not_needed);
    run(1, imu_failed);
    EXPECT_EQ(memory_.storing(), Storing::later);
    run(1, imu_failed | gain_failed);
    EXPECT_EQ(memory_.storing(), Storing::now);
    run(1);
    run(1, imu_failed);
    EXPECT_EQ(memory_.storing(), Storing::now) << "what is to be stored at once stays so";
}

TEST_F(Troubles, ComesBackFromItsBytes) {
    run(123);
    run(1, imu_failed, {1.0F, -2.0F, 0.3F, 40.0F});
    run(200);
    run(1, imu_failed | gain_failed, {-1.0F, 2.0F, -0.3F, 4.0F});
    TroubleMemory other{};
    other.restore(memory_.stored_data());
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        EXPECT_EQ(other.state(row).status, memory_.state(row).status);
        EXPECT_EQ(other.state(row).occurrences, memory_.state(row).occurrences);
        EXPECT_EQ(other.state(row).ageing, memory_.state(row).ageing);
    }
    EXPECT_EQ(seconds_in(other.snapshots(imu)->last), 3U);
    EXPECT_EQ(number_in(other.snapshots(imu)->first, 2U), -2000);
}

TEST_F(Troubles, AnUnknownCodeHasNoSnapshot) {
    TroubleMemory::Stored stored{};
    stored.states.fill({0xFFU, 0xFFU, 0xFFU});
    stored.snapshots.fill({0xFFU, {}, {}});
    memory_.restore(stored);
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        EXPECT_EQ(memory_.snapshots(row), nullptr);
        EXPECT_EQ(status_of(row), 0x7FU) << "bit 7 is not available";
    }
    stored.snapshots.fill({65U, {}, {}});  // of a longer table
    memory_.restore(stored);
    run(1);
    run(1, imu_failed);
    EXPECT_NE(memory_.snapshots(imu), nullptr) << "its place is free";
    stored.snapshots[0].code = static_cast<std::uint8_t>(trouble_code_count);
    memory_.restore(stored);
    EXPECT_NE(memory_.snapshots(last_row), nullptr);
}

}  // namespace
}  // namespace testing_diagnosis
