// The learnt load outlives a restart, in a record that cannot be mistaken.
#include "rsi/ecu/application/load_keeper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/memory_storage.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/ecu/application/crc32.hpp"
#include "rsi/ecu/application/little_endian.hpp"
#include "rsi/ecu/application/load_record.hpp"
#include "rsi/ecu/application/parameter_section.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "tests/access/cut_storage.hpp"
#include "tests/application/bench.hpp"

extern "C" const unsigned char rsi_parameter_section[rsi::application::section::length];

namespace testing_application {
namespace {

using rsi::application::Learnt;
using rsi::application::load_record_length;
using rsi::application::LoadKeeper;
using rsi::application::LoadRecord;
using Storage = rsi::hal::MemoryStorage<load_record_length>;

constexpr rsi::LearntLoad learnt{0.4F, 0.02F, -0.1F};
constexpr int cycles_in_a_minute = 6000;

TEST(TheLoadsRecord, GivesBackWhatWasLearnt) {
    const LoadRecord record = rsi::application::write_load_record({learnt, 0.7F}, 77U);
    Learnt read{};
    ASSERT_TRUE(rsi::application::read_load_record(record, 77U, read));
    EXPECT_EQ(read.load.excess, learnt.excess);
    EXPECT_EQ(read.load.excess_deviation, learnt.excess_deviation);
    EXPECT_EQ(read.load.offset_mps2, learnt.offset_mps2);
    EXPECT_EQ(read.lateral_offset_mps2, 0.7F);
}

// As the table of its places says, on every target.
TEST(TheLoadsRecord, HasItsBytesInTheirPlaces) {
    const LoadRecord record = rsi::application::write_load_record({{1.0F, 0.25F, -2.0F}, 0.5F}, 0x04030201U);
    const std::array<std::uint8_t, 24> expected{'R', 'S', 'I',   'M',   1U, 2U, 3U,    4U,
                                                0U,  0U,  0x80U, 0x3FU, 0U, 0U, 0x80U, 0x3EU,
                                                0U,  0U,  0U,    0xC0U, 0U, 0U, 0U,    0x3FU};
    for (std::size_t byte = 0U; byte < expected.size(); ++byte) {
        EXPECT_EQ(record[byte], expected[byte]) << byte;
    }
}

TEST(TheLoadsRecord, IsNoneWithAnyByteChangedOrErased) {
    const LoadRecord good = rsi::application::write_load_record({learnt, 0.0F}, 77U);
    EXPECT_TRUE(rsi::application::is_load_record(good));
    for (std::size_t byte = 0U; byte < good.size(); ++byte) {
        LoadRecord record = good;
        record[byte] ^= 0x10U;
        EXPECT_FALSE(rsi::application::is_load_record(record)) << byte;
    }
    for (const std::uint8_t erased : {std::uint8_t{0x00U}, std::uint8_t{0xFFU}}) {
        LoadRecord record{};
        record.fill(erased);
        EXPECT_FALSE(rsi::application::is_load_record(record));
    }
}

TEST(TheLoadsRecord, IsRefusedOfOtherParameters) {
    const LoadRecord record = rsi::application::write_load_record({learnt, 0.0F}, 77U);
    Learnt read{{0.1F, 0.1F, 0.1F}, 0.1F};
    EXPECT_FALSE(rsi::application::read_load_record(record, 78U, read));
    EXPECT_EQ(read.load.excess, 0.1F);
    EXPECT_EQ(read.lateral_offset_mps2, 0.1F);
}

TEST(TheLoadsRecord, IsNoneWithoutItsMagicThoughItsChecksumIsGood) {
    LoadRecord record = rsi::application::write_load_record({learnt, 0.0F}, 77U);
    record[0] ^= 1U;
    rsi::application::put_u32(record.data(), 24U, rsi::application::crc32(record.data(), 24U));
    EXPECT_FALSE(rsi::application::is_load_record(record));
}

// Found again by a reader of the record elsewhere.
TEST(TheParametersCheckWord, IsTheCrc32OfTheirBytesInTheOrderOfTheirTables) {
    const rsi::Parameters parameters = large_suv();
    std::vector<std::uint8_t> bytes;
    const auto append = [&bytes](std::uint32_t word) {
        for (const std::uint32_t shift : {0U, 8U, 16U, 24U}) {
            bytes.push_back(static_cast<std::uint8_t>(word >> shift));
        }
    };
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        append(rsi::application::float_bits(parameters.*field.member));
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        append(static_cast<std::uint32_t>(parameters.*field.member));
    }
    EXPECT_EQ(rsi::application::check_word_of(parameters),
              rsi::application::crc32(bytes.data(), bytes.size()));
}

TEST(TheParametersCheckWord, IsAnotherForEachParameterThatChanges) {
    const rsi::Parameters parameters = large_suv();
    const std::uint32_t word = rsi::application::check_word_of(parameters);
    EXPECT_EQ(rsi::application::check_word_of(parameters), word);
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        rsi::Parameters changed = parameters;
        changed.*field.member = std::nextafterf(changed.*field.member, 1.0e30F);
        EXPECT_NE(rsi::application::check_word_of(changed), word) << field.name;
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        rsi::Parameters changed = parameters;
        changed.*field.member += 1;
        EXPECT_NE(rsi::application::check_word_of(changed), word) << field.name;
    }
}

class Keeping : public ::testing::Test {
 protected:
    Keeping() {
        component.init(large_suv());
        keeper.use(storage);
        keeper.restore(large_suv(), component, monitor, true);
    }
    void keep(const rsi::LearntLoad& load, int cycles, float lateral_offset_mps2 = 0.0F) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            keeper.keep(load, lateral_offset_mps2);
        }
    }

    Storage storage{};
    rsi::Component component{};
    rsi::monitoring::InputMonitor monitor{};
    LoadKeeper keeper{};
};

TEST_F(Keeping, StoresAtMostOnceAMinute) {
    keep(learnt, cycles_in_a_minute - 1);
    EXPECT_EQ(storage.writes(), 0U);
    keep(learnt, 1);
    EXPECT_EQ(storage.writes(), 1U);
    const rsi::LearntLoad more{0.5F, 0.02F, 0.0F};
    keep(more, cycles_in_a_minute - 1);
    EXPECT_EQ(storage.writes(), 1U);
    keep(more, 1);
    EXPECT_EQ(storage.writes(), 2U);
}

TEST_F(Keeping, StoresNothingThatIsNotKnownOrNotNew) {
    keep({0.4F, 0.051F, 0.0F}, 2 * cycles_in_a_minute);
    keep({0.029F, 0.02F, 0.0F}, 2 * cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 0U);
    keep({0.031F, 0.049F, 0.0F}, 2 * cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 1U);
    keep({0.031F - 0.029F, 0.02F, 0.0F}, 2 * cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 1U);
}

TEST_F(Keeping, StoresALoadThatHasBeenTakenOff) {
    keep(learnt, cycles_in_a_minute);
    keep({learnt.excess - 0.031F, 0.02F, 0.0F}, cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 2U);
}

TEST_F(Keeping, DoesNotStoreAgainWhatItHasBroughtBack) {
    keep(learnt, cycles_in_a_minute);
    rsi::Component restarted;
    ASSERT_EQ(restarted.init(large_suv()).accepted, 1);
    LoadKeeper other;
    other.use(storage);
    other.restore(large_suv(), restarted, monitor, false);
    for (int cycle = 0; cycle < 2 * cycles_in_a_minute; ++cycle) {
        other.keep(restarted.learnt_load(), 0.0F);
    }
    EXPECT_EQ(storage.writes(), 1U);
}

TEST_F(Keeping, WaitsForAMinuteAfterAStartToo) {
    keep(learnt, cycles_in_a_minute - 1);
    keeper.restore(large_suv(), component, monitor, false);
    keep(learnt, cycles_in_a_minute - 1);
    EXPECT_EQ(storage.writes(), 0U);
}

TEST_F(Keeping, TriesAgainWhileTheStorageIsBusy) {
    storage.set_busy(true);
    keep(learnt, cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 0U);
    storage.set_busy(false);
    keep(learnt, 1);
    EXPECT_EQ(storage.writes(), 1U);
}

// Not a hundred times a second, for as long as it refuses.
TEST_F(Keeping, TriesARefusingStorageEverMoreRarely) {
    rsi_test::CutStorage refusing;
    refusing.refuse(true);
    keeper.use(refusing);
    keep(learnt, cycles_in_a_minute);
    EXPECT_EQ(refusing.tries(), 1);
    EXPECT_FALSE(keeper.is_failing()) << "it may be busy";
    keep(learnt, 511);
    EXPECT_EQ(refusing.tries(), 10);
    EXPECT_TRUE(keeper.is_failing());
    keep(learnt, 60 * cycles_in_a_minute);
    EXPECT_LE(refusing.tries(), 10 + 64) << "once a minute in the end";
    EXPECT_GE(refusing.tries(), 10 + 60);
    refusing.refuse(false);
    keep(learnt, cycles_in_a_minute);
    EXPECT_EQ(refusing.writes(), 1);
    EXPECT_FALSE(keeper.is_failing());
}

TEST_F(Keeping, FailsWhereARecordCannotBeRead) {
    rsi_test::CutStorage unreadable;
    keeper.use(unreadable);
    keeper.restore(large_suv(), component, monitor, false);
    EXPECT_FALSE(keeper.is_failing()) << "nothing was ever stored";
    unreadable.set_unreadable(true);
    keeper.restore(large_suv(), component, monitor, false);
    EXPECT_TRUE(keeper.is_failing());
    unreadable.set_unreadable(false);
    keeper.restore(large_suv(), component, monitor, false);
    EXPECT_FALSE(keeper.is_failing());
}

// The memory gave it, and it is not what was kept.
TEST_F(Keeping, FailsWhereARecordIsDamagedAndNotWhereItIsOfOtherParameters) {
    keep(learnt, cycles_in_a_minute);
    rsi::Parameters others = large_suv();
    others.sprung_mass_kg += 1.0F;
    keeper.restore(others, component, monitor, false);
    EXPECT_FALSE(keeper.is_failing());
    storage.damage(9U);
    keeper.restore(large_suv(), component, monitor, false);
    EXPECT_TRUE(keeper.is_failing());
}

TEST_F(Keeping, FailsNoLongerOnceARecordIsTaken) {
    rsi_test::CutStorage lost;
    lost.set_unreadable(true);
    lost.refuse(true);
    keeper.use(lost);
    keeper.restore(large_suv(), component, monitor, false);
    keep(learnt, cycles_in_a_minute);
    ASSERT_EQ(lost.tries(), 1);
    EXPECT_TRUE(keeper.is_failing()) << "refused, it is as lost as it was";
    lost.refuse(false);
    keep(learnt, 1);
    ASSERT_EQ(lost.writes(), 1);
    EXPECT_FALSE(keeper.is_failing());
}

// As one of another layout, from before an update: its code must not stay because nothing new is learnt.
TEST_F(Keeping, StoresInPlaceOfALostRecordThoughNothingIsNew) {
    const std::array<std::uint8_t, 24> of_before{};
    ASSERT_TRUE(storage.write(of_before.data(), of_before.size()));
    keeper.restore(large_suv(), component, monitor, false);
    ASSERT_TRUE(keeper.is_failing());
    keep(component.learnt_load(), cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 2U);
    EXPECT_FALSE(keeper.is_failing());
    keep(component.learnt_load(), 2 * cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 2U);
}

// A component that refuses what was kept does not have it, so that it is new to the storage.
TEST_F(Keeping, StoresAgainWhatAComponentHasNotTakenBack) {
    keep(learnt, cycles_in_a_minute);
    ASSERT_EQ(storage.writes(), 1U);
    rsi::Component not_started;
    keeper.restore(large_suv(), not_started, monitor, false);
    EXPECT_EQ(not_started.learnt_load().excess, 0.0F);
    keep(learnt, cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 2U);
}

// A load learnt with other parameters is not used: the same number is then new.
TEST_F(Keeping, StoresAgainAfterARestartWithOtherParameters) {
    keep(learnt, cycles_in_a_minute);
    ASSERT_EQ(storage.writes(), 1U);
    rsi::Parameters other = large_suv();
    other.sprung_mass_kg += 1.0F;
    ASSERT_EQ(component.init(other).accepted, 1);
    keeper.restore(other, component, monitor, false);
    EXPECT_EQ(component.learnt_load().excess, 0.0F);
    keep(learnt, cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 2U);
}

TEST_F(Keeping, StoresForTheParametersThatItFollows) {
    rsi::Parameters other = large_suv();
    other.warning_on = 0.95F;
    keeper.follow(other);
    keep(learnt, cycles_in_a_minute);
    LoadRecord record{};
    ASSERT_EQ(storage.read(record.data(), record.size()), rsi::hal::Reading::stored);
    Learnt read{};
    EXPECT_TRUE(rsi::application::read_load_record(record, rsi::application::check_word_of(other), read));
    EXPECT_FALSE(
        rsi::application::read_load_record(record, rsi::application::check_word_of(large_suv()), read));
}

TEST_F(Keeping, BringsItBackAfterARestartDoubtedOrNot) {
    keep(learnt, cycles_in_a_minute);
    for (const bool doubted : {true, false}) {
        rsi::Component restarted;
        ASSERT_EQ(restarted.init(large_suv()).accepted, 1);
        LoadKeeper other;
        other.use(storage);
        other.restore(large_suv(), restarted, monitor, doubted);
        EXPECT_FLOAT_EQ(restarted.learnt_load().excess, (doubted ? 0.5F : 1.0F) * learnt.excess);
        EXPECT_EQ(restarted.learnt_load().excess_deviation > 0.15F, doubted);
    }
}

TEST_F(Keeping, BringsNothingBackOfOtherParametersOrFromADamagedRecord) {
    keep(learnt, cycles_in_a_minute);
    rsi::Parameters others = large_suv();
    others.sprung_mass_kg += 1.0F;
    const auto excess_after = [this](const rsi::Parameters& parameters) {
        rsi::Component restarted;
        EXPECT_EQ(restarted.init(parameters).accepted, 1);
        LoadKeeper other;
        other.use(storage);
        other.restore(parameters, restarted, monitor, false);
        return restarted.learnt_load().excess;
    };
    EXPECT_EQ(excess_after(others), 0.0F);
    storage.damage(9U);
    EXPECT_EQ(excess_after(large_suv()), 0.0F);
}

TEST_F(Keeping, StoresAnOffsetThatIsAnother) {
    keep({}, 2 * cycles_in_a_minute, 0.099F);
    EXPECT_EQ(storage.writes(), 0U);
    keep({}, cycles_in_a_minute, -0.5F);
    EXPECT_EQ(storage.writes(), 1U);
    keep({}, 2 * cycles_in_a_minute, -0.59F);
    EXPECT_EQ(storage.writes(), 1U);
    keep({}, 1, -0.61F);
    EXPECT_EQ(storage.writes(), 2U);
    keep({}, cycles_in_a_minute, -0.5F);
    EXPECT_EQ(storage.writes(), 3U);
}

// Each is stored as it was known, though only the other is new.
TEST_F(Keeping, StoresTheLoadThatIsKnownWithAnOffsetAndTheOtherWayRound) {
    const auto stored = [this] {
        LoadRecord record{};
        EXPECT_EQ(storage.read(record.data(), record.size()), rsi::hal::Reading::stored);
        Learnt read{};
        EXPECT_TRUE(rsi::application::read_load_record(record, keeper.parameters_check_word(), read));
        return read;
    };
    keep(learnt, cycles_in_a_minute, 0.5F);
    EXPECT_EQ(stored().load.excess, learnt.excess);
    EXPECT_EQ(stored().lateral_offset_mps2, 0.5F);
    keep({0.1F, 0.2F, 0.3F}, cycles_in_a_minute, 1.0F);
    EXPECT_EQ(stored().load.excess, learnt.excess) << "not known";
    EXPECT_EQ(stored().lateral_offset_mps2, 1.0F);
    keep({0.1F, 0.02F, 0.3F}, cycles_in_a_minute, 1.05F);
    EXPECT_EQ(stored().load.excess, 0.1F);
    EXPECT_EQ(stored().lateral_offset_mps2, 1.05F);
}

TEST_F(Keeping, BringsTheOffsetBackEvenDoubtedAndDoesNotStoreItAgain) {
    keep({}, cycles_in_a_minute, 0.8F);
    keeper.restore(large_suv(), component, monitor, true);
    EXPECT_EQ(monitor.lateral_offset().learnt_mps2(), 0.8F);
    keep({}, 2 * cycles_in_a_minute, 0.8F);
    EXPECT_EQ(storage.writes(), 1U);
}

TEST_F(Keeping, BringsNoOffsetBackThatIsOutOfRangeOrOfOtherParameters) {
    keep({}, cycles_in_a_minute, 0.8F);
    rsi::Parameters others = large_suv();
    others.sprung_mass_kg += 1.0F;
    keeper.restore(others, component, monitor, false);
    EXPECT_EQ(monitor.lateral_offset().learnt_mps2(), 0.0F);
    keeper.follow(large_suv());
    keep({}, cycles_in_a_minute, 4.0F);
    keeper.restore(large_suv(), component, monitor, false);
    EXPECT_EQ(monitor.lateral_offset().learnt_mps2(), 0.0F);
    keep({}, cycles_in_a_minute, 0.8F);
    EXPECT_EQ(storage.writes(), 3U) << "what was not taken back is new";
}

TEST(AKeeperWithoutAStorage, DoesNothing) {
    rsi::Component component;
    ASSERT_EQ(component.init(large_suv()).accepted, 1);
    rsi::monitoring::InputMonitor monitor;
    LoadKeeper keeper;
    keeper.restore(large_suv(), component, monitor, true);
    for (int cycle = 0; cycle < 2 * cycles_in_a_minute; ++cycle) {
        keeper.keep(learnt, 1.0F);
    }
    EXPECT_EQ(component.learnt_load().excess, 0.0F);
}

// The control unit as a whole, on a bus of its own, started after a reset or a loss of power.
class AnEcuWithAStorage {
 public:
    explicit AnEcuWithAStorage(rsi::hal::ResetReason reason) {
        ecu_.use_storage(storage);
        ecu_.set_reset_reason(reason);
    }
    // The load learnt before the start, with these parameters.
    void had_learnt(const rsi::LearntLoad& load, const rsi::Parameters& parameters,
                    float lateral_offset_mps2 = 0.0F) {
        const LoadRecord record = rsi::application::write_load_record(
            {load, lateral_offset_mps2}, rsi::application::check_word_of(parameters));
        EXPECT_TRUE(storage.write(record.data(), record.size()));
    }
    rsi::application::RolloverEcu& ecu() { return ecu_; }

    void hear(const rsi::hal::CanFrame& frame) { bus_.endpoint(1U).send(frame); }
    void hear_all_sensors(const Motion& motion = {}) {
        Bench bench;
        bench.drive(motion);
        bench.run_cycles(1);
        for (const Sensor sensor : all_sensors) {
            hear(bench.last_frame(sensor));
        }
    }
    void hear_mass(float mass_kg, unsigned counter) {
        hear(frame_of(rsi::can_dbc::VehicleMass{mass_kg}, counter));
    }
    float load_excess_in_the_first_cycle() {
        hear_all_sensors();
        ecu_.step(0U);
        return ecu_.outputs().load_excess;
    }

    Storage storage{};

 private:
    rsi::hal::VirtualClock clock_{};
    rsi::hal::MemoryBus<2U> bus_{clock_};
    NoWatchdog watchdog_{};
    rsi::application::RolloverEcu ecu_{bus_.endpoint(0U), clock_, watchdog_};
};

float excess_at_start(rsi::hal::ResetReason reason) {
    AnEcuWithAStorage unit{reason};
    unit.had_learnt(learnt, large_suv());
    EXPECT_EQ(unit.ecu().init(large_suv()).accepted, 1);
    return unit.load_excess_in_the_first_cycle();
}

TEST(TheEcu, StartsWithTheLoadThatItsStorageHoldsAndDoubtsItAfterALossOfPower) {
    EXPECT_NEAR(excess_at_start(rsi::hal::ResetReason::power_on), 0.5F * learnt.excess, 0.001F);
    EXPECT_NEAR(excess_at_start(rsi::hal::ResetReason::outside), learnt.excess, 0.001F);
    EXPECT_NEAR(excess_at_start(rsi::hal::ResetReason::data_abort), learnt.excess, 0.001F);
}

TEST(TheEcu, StartsWithTheOffsetOfItsAccelerometerAfterALossOfPowerToo) {
    AnEcuWithAStorage unit{rsi::hal::ResetReason::power_on};
    unit.had_learnt(learnt, large_suv(), 1.0F);
    EXPECT_EQ(unit.ecu().init(large_suv()).accepted, 1);
    unit.hear_all_sensors();
    unit.ecu().step(0U);
    EXPECT_NEAR(unit.ecu().inputs().lateral_specific_force_mps2, -1.0F, 0.01F);
}

TEST(TheEcu, ReportsAMemoryThatLosesRecords) {
    using rsi::monitoring::DiagnosticCode;
    AnEcuWithAStorage unit{rsi::hal::ResetReason::outside};
    const std::array<std::uint8_t, 3> cut{};
    ASSERT_TRUE(unit.storage.write(cut.data(), cut.size()));
    ASSERT_EQ(unit.ecu().init(large_suv()).accepted, 1);
    unit.ecu().step(0U);
    EXPECT_TRUE(unit.ecu().diagnostic_memory().confirmed(DiagnosticCode::storage_failed));
}

TEST(TheEcu, ReportsTheOtherMemoriesOfThePlatformToo) {
    using rsi::monitoring::DiagnosticCode;
    AnEcuWithAStorage unit{rsi::hal::ResetReason::outside};
    ASSERT_EQ(unit.ecu().init(large_suv()).accepted, 1);
    unit.ecu().step(0U);
    EXPECT_FALSE(unit.ecu().diagnostic_memory().confirmed(DiagnosticCode::storage_failed));
    unit.ecu().report_storage(true);
    unit.ecu().step(0U);
    EXPECT_TRUE(unit.ecu().diagnostic_memory().confirmed(DiagnosticCode::storage_failed));
    unit.ecu().report_storage(false);
    unit.ecu().step(0U);
    EXPECT_FALSE(unit.ecu().diagnostic_memory().confirmed(DiagnosticCode::storage_failed));
}

TEST(TheEcu, StartsWithThatLoadWhereItsParametersAreASectionToo) {
    rsi::Parameters parameters{};
    rsi::application::read_parameter_section(rsi_parameter_section, rsi::application::section::length,
                                             parameters);
    AnEcuWithAStorage unit{rsi::hal::ResetReason::outside};
    unit.had_learnt(learnt, parameters);
    unit.ecu().init(rsi_parameter_section, rsi::application::section::length);
    EXPECT_NEAR(unit.load_excess_in_the_first_cycle(), learnt.excess, 0.001F);
}

// 130 kg more than a moment ago; also for parameters to which it was changed while it ran.
class ALoadThatIsPutOn : public ::testing::TestWithParam<bool> {};

TEST_P(ALoadThatIsPutOn, IsStoredAfterAMinute) {
    AnEcuWithAStorage unit{rsi::hal::ResetReason::outside};
    unit.had_learnt({0.4F, 0.02F, 0.0F}, large_suv());
    ASSERT_EQ(unit.ecu().init(large_suv()).accepted, 1);
    rsi::Parameters used = large_suv();
    if (GetParam()) {
        used.warning_on = 0.95F;
        rsi::ParameterChange change;
        ASSERT_EQ(change.begin(large_suv(), used).accepted, 1);
        ASSERT_TRUE(change.prepare());
        unit.ecu().change(change);
    }
    Motion standing;
    standing.vehicle_motion.speed_kmh = 0.0F;
    unit.hear_all_sensors(standing);
    unit.hear_mass(2370.0F, 0U);
    unit.ecu().step(0U);
    unit.hear_all_sensors(standing);
    unit.hear_mass(2500.0F, 1U);
    for (int cycle = 2; cycle < cycles_in_a_minute; ++cycle) {
        unit.ecu().step(0U);
    }
    EXPECT_EQ(unit.storage.writes(), 1U);
    unit.ecu().step(0U);
    ASSERT_EQ(unit.storage.writes(), 2U);
    LoadRecord record{};
    Learnt stored{};
    ASSERT_EQ(unit.storage.read(record.data(), record.size()), rsi::hal::Reading::stored);
    ASSERT_TRUE(rsi::application::read_load_record(record, rsi::application::check_word_of(used), stored));
    EXPECT_NEAR(stored.load.excess, 0.4F + 130.0F / 2060.0F, 0.001F);
}
INSTANTIATE_TEST_SUITE_P(Parameters, ALoadThatIsPutOn, ::testing::Bool());

}  // namespace
}  // namespace testing_application
