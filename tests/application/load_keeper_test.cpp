// What has been learnt of the load outlives a restart, in a record that cannot be mistaken.
#include "application/load_keeper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "application/load_record.hpp"
#include "application/rollover_ecu.hpp"
#include "hal/memory/memory_bus.hpp"
#include "hal/memory/memory_storage.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

using application::load_record_length;
using application::LoadKeeper;
using application::LoadRecord;
using Storage = hal::MemoryStorage<load_record_length>;

constexpr rsi::LearntLoad learnt{0.4F, 0.02F, -0.1F};
constexpr int cycles_in_a_minute = 6000;

TEST(TheLoadsRecord, GivesBackWhatWasLearnt) {
    const LoadRecord record = application::write_load_record(learnt, 77U);
    rsi::LearntLoad read{};
    ASSERT_TRUE(application::read_load_record(record, 77U, read));
    EXPECT_EQ(read.excess, learnt.excess);
    EXPECT_EQ(read.excess_deviation, learnt.excess_deviation);
    EXPECT_EQ(read.offset_mps2, learnt.offset_mps2);
}

// As the table of its places says, on every target.
TEST(TheLoadsRecord, HasItsBytesInTheirPlaces) {
    const LoadRecord record = application::write_load_record({1.0F, 0.25F, -2.0F}, 0x04030201U);
    const std::array<std::uint8_t, 20> expected{'R',   'S',   'I', 'L', 1U,    2U,    3U, 4U, 0U, 0U,
                                                0x80U, 0x3FU, 0U,  0U,  0x80U, 0x3EU, 0U, 0U, 0U, 0xC0U};
    for (std::size_t byte = 0U; byte < expected.size(); ++byte) {
        EXPECT_EQ(record[byte], expected[byte]) << byte;
    }
}

TEST(TheLoadsRecord, IsRefusedWithAnyByteChangedErasedOrOfOtherParameters) {
    const LoadRecord good = application::write_load_record(learnt, 77U);
    rsi::LearntLoad read{0.1F, 0.1F, 0.1F};
    for (std::size_t byte = 0U; byte < good.size(); ++byte) {
        LoadRecord record = good;
        record[byte] ^= 0x10U;
        EXPECT_FALSE(application::read_load_record(record, 77U, read)) << byte;
    }
    for (const std::uint8_t erased : {std::uint8_t{0x00U}, std::uint8_t{0xFFU}}) {
        LoadRecord record{};
        record.fill(erased);
        EXPECT_FALSE(application::read_load_record(record, 77U, read));
    }
    EXPECT_FALSE(application::read_load_record(good, 78U, read));
    EXPECT_EQ(read.excess, 0.1F);
}

TEST(TheParametersCheckWord, IsAnotherForEachParameterThatChanges) {
    const rsi::Parameters parameters = large_suv();
    const std::uint32_t word = application::check_word_of(parameters);
    EXPECT_EQ(application::check_word_of(parameters), word);
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        rsi::Parameters changed = parameters;
        changed.*field.member = std::nextafterf(changed.*field.member, 1.0e30F);
        EXPECT_NE(application::check_word_of(changed), word) << field.name;
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        rsi::Parameters changed = parameters;
        changed.*field.member += 1;
        EXPECT_NE(application::check_word_of(changed), word) << field.name;
    }
}

class Keeping : public ::testing::Test {
 protected:
    Keeping() {
        component.init(large_suv());
        keeper.use(storage);
        keeper.restore(large_suv(), component, true);
    }
    void keep(const rsi::LearntLoad& load, int cycles) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            keeper.keep(load);
        }
    }

    Storage storage{};
    rsi::Component component{};
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

TEST_F(Keeping, TriesAgainWhileTheStorageIsBusy) {
    storage.set_busy(true);
    keep(learnt, 2 * cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 0U);
    storage.set_busy(false);
    keep(learnt, 1);
    EXPECT_EQ(storage.writes(), 1U);
}

// A component that refuses what was kept does not have it, so that it is news to the storage.
TEST_F(Keeping, StoresAgainWhatAComponentHasNotTakenBack) {
    keep(learnt, cycles_in_a_minute);
    ASSERT_EQ(storage.writes(), 1U);
    rsi::Component not_started;
    keeper.restore(large_suv(), not_started, false);
    EXPECT_EQ(not_started.learnt_load().excess, 0.0F);
    keep(learnt, cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 2U);
}

// What was learnt with other parameters is not there: the same number is news then.
TEST_F(Keeping, StoresAgainAfterARestartWithOtherParameters) {
    keep(learnt, cycles_in_a_minute);
    ASSERT_EQ(storage.writes(), 1U);
    rsi::Parameters other = large_suv();
    other.sprung_mass_kg += 1.0F;
    ASSERT_EQ(component.init(other).accepted, 1);
    keeper.restore(other, component, false);
    EXPECT_EQ(component.learnt_load().excess, 0.0F);
    keep(learnt, cycles_in_a_minute);
    EXPECT_EQ(storage.writes(), 2U);
}

TEST_F(Keeping, BringsItBackAfterARestartDoubtedOrNot) {
    keep(learnt, cycles_in_a_minute);
    for (const bool doubted : {true, false}) {
        rsi::Component restarted;
        ASSERT_EQ(restarted.init(large_suv()).accepted, 1);
        LoadKeeper other;
        other.use(storage);
        other.restore(large_suv(), restarted, doubted);
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
        other.restore(parameters, restarted, false);
        return restarted.learnt_load().excess;
    };
    EXPECT_EQ(excess_after(others), 0.0F);
    storage.damage(9U);
    EXPECT_EQ(excess_after(large_suv()), 0.0F);
}

TEST(AKeeperWithoutAStorage, DoesNothing) {
    rsi::Component component;
    ASSERT_EQ(component.init(large_suv()).accepted, 1);
    LoadKeeper keeper;
    keeper.restore(large_suv(), component, true);
    for (int cycle = 0; cycle < 2 * cycles_in_a_minute; ++cycle) {
        keeper.keep(learnt);
    }
    EXPECT_EQ(component.learnt_load().excess, 0.0F);
}

// The control unit as a whole: its storage is read at its start. What it says of the load in its first cycle.
float excess_at_start(hal::ResetReason reason) {
    Storage storage;
    const LoadRecord record = application::write_load_record(learnt, application::check_word_of(large_suv()));
    EXPECT_TRUE(storage.write(record.data(), record.size()));
    hal::VirtualClock clock;
    hal::MemoryBus<2U> bus{clock};
    NoWatchdog watchdog;
    application::RolloverEcu ecu{bus.endpoint(0U), clock, watchdog};
    ecu.use_storage(storage);
    ecu.set_reset_reason(reason);
    EXPECT_EQ(ecu.init(large_suv()).accepted, 1);
    hal::CanFrame frame;
    Bench bench;  // whose sensors it hears
    bench.run_cycles(1);
    for (const Sensor sensor : all_sensors) {
        frame = bench.last_frame(sensor);
        bus.endpoint(1U).send(frame);
    }
    ecu.step(0U);
    return ecu.outputs().load_excess;
}

TEST(TheEcu, StartsWithTheLoadThatItsStorageHoldsAndDoubtsItAfterALossOfPower) {
    EXPECT_NEAR(excess_at_start(hal::ResetReason::power_on), 0.5F * learnt.excess, 0.001F);
    EXPECT_NEAR(excess_at_start(hal::ResetReason::outside), learnt.excess, 0.001F);
    EXPECT_NEAR(excess_at_start(hal::ResetReason::data_abort), learnt.excess, 0.001F);
}

}  // namespace
}  // namespace testing_application
