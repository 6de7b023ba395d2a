// The pages: what is written is used from a cycle's start on, as a whole, or not at all.
#include <gtest/gtest.h>

#include <algorithm>

#include "rsi/ecu/application/little_endian.hpp"
#include "rsi/parameters.hpp"
#include "tests/xcp/bench.hpp"

namespace testing_xcp {
namespace {

constexpr int cycles_for_a_vehicle = 200;
const Bytes good{0xFF};

std::uint8_t number_of(const char* field) {
    return static_cast<std::uint8_t>(1U + (Bench::address_of(field) - map::parameters_at) / 4U);
}

TEST(WorkingPage, IsWhatTheControlUnitStartsWith) {
    Bench bench;
    bench.connect();
    EXPECT_EQ(bench.read_float("warning_on"), bench.used().warning_on);
    EXPECT_EQ(bench.used().warning_on, image_parameters().warning_on);
    EXPECT_EQ(bench.changes(), 0U);
}

TEST(WorkingPage, IsTakenOverByTheNextCycle) {
    Bench bench;
    bench.connect_and_unlock();
    const float before = bench.used().warning_on;
    ASSERT_TRUE(bench.write_float("warning_on", 0.85F));
    EXPECT_EQ(bench.used().warning_on, before);
    bench.cycle();
    EXPECT_EQ(bench.used().warning_on, 0.85F);
    EXPECT_EQ(bench.changes(), 1U);
    EXPECT_EQ(bench.refused_field(), 0U);
    EXPECT_EQ(bench.read_float("warning_on"), 0.85F);
    EXPECT_EQ(bench.others.size(), testing_application::frames_per_cycle);
}

TEST(WorkingPage, ThatIsRefusedNamesTheFieldAndIsNotUsed) {
    Bench bench;
    bench.connect_and_unlock();
    const rsi::Parameters before = bench.used();
    ASSERT_TRUE(bench.write_float("warning_on", 1.3F));
    bench.cycles(3);
    EXPECT_EQ(std::memcmp(&before, &bench.used(), sizeof before), 0);
    EXPECT_EQ(bench.refused_field(), number_of("warning_on"));
    // It stays to be corrected, and another field's change waits with it.
    EXPECT_EQ(bench.read_float("warning_on"), 1.3F);
    ASSERT_TRUE(bench.write_float("warning_hold_s", 1.5F));
    bench.cycles(3);
    EXPECT_NE(bench.used().warning_hold_s, 1.5F);
    ASSERT_TRUE(bench.write_float("warning_on", 0.9F));
    bench.cycle();
    EXPECT_EQ(bench.used().warning_on, 0.9F);
    EXPECT_EQ(bench.used().warning_hold_s, 1.5F);
    EXPECT_EQ(bench.refused_field(), 0U);
}

TEST(WorkingPage, NamesSelectionsToo) {
    Bench bench;
    bench.connect_and_unlock();
    EXPECT_EQ(bench.download(Bench::address_of("warning_indicator"), {99, 0, 0, 0}), good);
    bench.cycle();
    EXPECT_EQ(bench.refused_field(), number_of("warning_indicator"));
}

// Half a value is none.
TEST(WorkingPage, TakesWholeValuesOnly) {
    Bench bench;
    bench.connect_and_unlock();
    const std::uint32_t address = Bench::address_of("warning_on");
    const Bytes before = bench.upload(address, 4U);
    const Bytes wanted{0x9A, 0x99, 0x59, 0x3F};  // 0.85
    EXPECT_EQ(bench.download(address, {wanted[0], wanted[1]}), good);
    bench.cycles(2);
    EXPECT_EQ(bench.upload(address, 4U), before);
    EXPECT_EQ(bench.changes(), 0U);
    // The other half, right behind it.
    EXPECT_EQ(bench.download(address + 2U, {wanted[2], wanted[3]}), good);
    bench.cycle();
    EXPECT_EQ(bench.upload(address, 4U), wanted);
    EXPECT_EQ(bench.used().warning_on, 0.85F);
    // A half that nothing went before.
    EXPECT_EQ(bench.download(address + 2U, {wanted[2], wanted[3]}), (Bytes{0xFE, 0x22}));
    EXPECT_EQ(bench.download(address, {0x00, 0x00}), good);
    EXPECT_EQ(bench.download(address + 1U, {0x00}), (Bytes{0xFE, 0x22}));
}

// As a master sends a block: the address once, then six bytes at a time, which end within values.
TEST(WorkingPage, TakesABlockPieceByPiece) {
    Bench bench;
    bench.connect_and_unlock();
    EXPECT_EQ(bench.command({0xEB, 0x01, 0, 1}), good);  // the reference, while it is written
    Bytes block;
    for (const float value : {0.5F, 0.25F, 0.75F}) {
        std::uint32_t word = 0U;
        std::memcpy(&word, &value, sizeof word);
        block = Bench::with_word(block, word);
    }
    ASSERT_TRUE(bench.set_address(Bench::address_of("advisory_on")));
    Bytes first{0xF0, 6};
    Bytes second{0xF0, 6};
    first.insert(first.end(), block.begin(), block.begin() + 6);
    second.insert(second.end(), block.begin() + 6, block.end());
    EXPECT_EQ(bench.command(first), good);
    EXPECT_EQ(bench.command({0xF0, 7, 0, 0, 0, 0, 0, 0}), (Bytes{0xFE, 0x22}));  // changes no address
    EXPECT_EQ(bench.command(second), good);
    EXPECT_EQ(bench.read_float("advisory_on"), 0.5F);
    EXPECT_EQ(bench.read_float("advisory_off"), 0.25F);
    EXPECT_EQ(bench.read_float("warning_on"), 0.75F);
    // A refusal leaves the address where it was.
    ASSERT_TRUE(bench.set_address(map::epk_at));
    EXPECT_EQ(bench.command({0xF0, 4, 0, 0, 0, 0}), (Bytes{0xFE, 0x24}));
    EXPECT_EQ(bench.command({0xF5, 4}), (Bytes{0xFF, 'r', 's', 'i', ' '}));
}

// The component uses it, and no check takes the change for damage.
TEST(WorkingPage, IsWhatTheComponentReckonsWithFromThenOn) {
    Bench bench;
    bench.connect_and_unlock();
    bench.cycles(100);
    ASSERT_EQ(bench.ecu().ecu().outputs().warning_level, 0.0F);
    EXPECT_EQ(
        bench.download(Bench::address_of("warning_indicator"), {RSI_INDICATOR_TIME_TO_ROLLOVER, 0, 0, 0}),
        good);
    ASSERT_EQ(bench.refused_field(), 0U);
    for (int k = 0; k < 60; ++k) {
        bench.cycle();
        ASSERT_EQ(bench.ecu().ecu().outputs().state, RSI_STATE_READY) << k;
        // Ten seconds, as long as the body does not roll.
        ASSERT_FLOAT_EQ(bench.ecu().ecu().outputs().warning_level,
                        0.1F * bench.used().time_to_rollover_limit_s)
            << k;
    }
}

TEST(WorkingPage, SaysWhichSensorsAreHeard) {
    Bench bench;
    bench.connect_and_unlock();
    bench.cycles(300);
    ASSERT_EQ(bench.ecu().ecu().outputs().roll_source, RSI_ROLL_SENSOR);
    EXPECT_EQ(bench.download(Bench::address_of("roll_angle_sensor"), {RSI_ROLL_SENSOR_NOT_FITTED, 0, 0, 0}),
              good);
    bench.cycles(10);
    EXPECT_EQ(bench.ecu().ecu().outputs().roll_source, RSI_ROLL_OBSERVER);
}

TEST(WorkingPage, ForgetsAPieceWhenItIsCopied) {
    Bench bench;
    bench.connect_and_unlock();
    const std::uint32_t address = Bench::address_of("warning_on");
    EXPECT_EQ(bench.download(address, {0x00, 0x00}), good);
    EXPECT_EQ(bench.command({0xE4, 0, 1, 0, 0}), good);
    EXPECT_EQ(bench.download(address + 2U, {0x00, 0x00}), (Bytes{0xFE, 0x22}));
    // Nor does it expect one anywhere else, such as at the start.
    EXPECT_EQ(bench.command({0xE4, 0, 1, 0, 0}), good);
    EXPECT_EQ(bench.download(map::parameters_at + 1U, {0x00, 0x00, 0x00}), (Bytes{0xFE, 0x22}));
}

TEST(Pages, AreSeenAnewByEachSession) {
    Bench bench;
    bench.connect_and_unlock();
    EXPECT_EQ(bench.command({0xEB, 0x02, 0, 1}), good);
    ASSERT_TRUE(bench.set_address(map::name_at));
    bench.connect();
    EXPECT_EQ(bench.command({0xEA, 0x02, 0}), (Bytes{0xFF, 0, 0, 0}));
    EXPECT_EQ(bench.command({0xF5, 1}), (Bytes{0xFE, 0x24}));
}

TEST(WorkingPage, IsWrittenWithinItsEndsAlone) {
    Bench bench;
    bench.connect_and_unlock();
    EXPECT_EQ(bench.download(map::parameters_at + map::parameters_length - 4U, {0, 0, 0, 0, 0}),
              (Bytes{0xFE, 0x24}));
    EXPECT_EQ(bench.download(map::parameters_at - 4U, {0, 0, 0, 0}), (Bytes{0xFE, 0x24}));
    for (const std::uint32_t measured : {map::outputs_at, map::inputs_at, map::codes_at}) {
        EXPECT_EQ(bench.download(measured, {0, 0, 0, 0}), (Bytes{0xFE, 0x23})) << measured;
    }
    EXPECT_EQ(bench.download(map::parameters_at, {}), (Bytes{0xFE, 0x22}));
    EXPECT_EQ(bench.command({0xF0, 7, 0, 0, 0, 0, 0, 0}), (Bytes{0xFE, 0x22}));
}

TEST(WorkingPage, OfAnotherVehicleIsPreparedOverCyclesAndNoneIsLost) {
    Bench bench;
    bench.connect_and_unlock();
    bench.cycles(100);
    const float heavier = 1.01F * bench.used().sprung_mass_kg;
    ASSERT_TRUE(bench.write_float("sprung_mass_kg", heavier));
    for (int k = 1; k < cycles_for_a_vehicle; ++k) {
        bench.cycle();
        ASSERT_NE(bench.used().sprung_mass_kg, heavier);
        ASSERT_EQ(bench.others.size(), testing_application::frames_per_cycle);
        ASSERT_NE(bench.ecu().ecu().outputs().state, RSI_STATE_UNAVAILABLE);
    }
    bench.cycle();
    EXPECT_EQ(bench.used().sprung_mass_kg, heavier);
    EXPECT_NE(bench.ecu().ecu().outputs().state, RSI_STATE_UNAVAILABLE);
}

TEST(WorkingPage, WhosePreparationIsOvertakenIsTakenOverOnce) {
    Bench bench;
    bench.connect_and_unlock();
    ASSERT_TRUE(bench.write_float("sprung_mass_kg", 1.01F * bench.used().sprung_mass_kg));
    EXPECT_EQ(bench.upload(map::change_at, 4U), (Bytes{0, 1, 0, 0}));
    ASSERT_TRUE(bench.write_float("warning_on", 0.85F));
    bench.cycles(cycles_for_a_vehicle);
    EXPECT_EQ(bench.changes(), 1U);
    EXPECT_EQ(bench.used().warning_on, 0.85F);
    EXPECT_EQ(bench.upload(map::change_at, 4U), (Bytes{0, 0, 0, 0}));
}

TEST(ReferencePage, IsTheImagesAndCannotBeWritten) {
    Bench bench;
    bench.connect_and_unlock();
    ASSERT_TRUE(bench.write_float("warning_on", 0.85F));
    bench.cycle();
    EXPECT_EQ(bench.command({0xEB, 0x02, 0, 1}), good);
    EXPECT_EQ(bench.read_float("warning_on"), image_parameters().warning_on);
    EXPECT_EQ(bench.download(Bench::address_of("warning_on"), {0, 0, 0, 0}), (Bytes{0xFE, 0x23}));
    EXPECT_EQ(bench.used().warning_on, 0.85F);
}

TEST(Pages, AreSwitchedBetweenCycles) {
    Bench bench;
    bench.connect_and_unlock();
    ASSERT_TRUE(bench.write_float("warning_on", 0.85F));
    bench.cycle();
    EXPECT_EQ(bench.command({0xEB, 0x01, 0, 1}), good);
    EXPECT_EQ(bench.used().warning_on, 0.85F);
    bench.cycle();
    EXPECT_EQ(bench.used().warning_on, image_parameters().warning_on);
    EXPECT_EQ(bench.upload(map::change_at, 1U), Bytes{1});
    EXPECT_EQ(bench.command({0xEB, 0x01, 0, 0}), good);
    bench.cycle();
    EXPECT_EQ(bench.used().warning_on, 0.85F);
}

// Several values of which none goes without the others.
TEST(Pages, TakeSeveralValuesOverAtOnce) {
    Bench bench;
    bench.connect_and_unlock();
    const rsi::Parameters before = bench.used();
    EXPECT_EQ(bench.command({0xEB, 0x01, 0, 1}), good);
    ASSERT_TRUE(bench.write_float("advisory_on", 0.5F));
    ASSERT_TRUE(bench.write_float("advisory_off", 0.4F));
    bench.cycles(5);
    EXPECT_EQ(std::memcmp(&before, &bench.used(), sizeof before), 0);
    EXPECT_EQ(bench.command({0xEB, 0x01, 0, 0}), good);
    bench.cycle();
    EXPECT_EQ(bench.used().advisory_on, 0.5F);
    EXPECT_EQ(bench.used().advisory_off, 0.4F);
}

TEST(Pages, DoNotSwitchToOneThatIsRefused) {
    Bench bench;
    bench.connect_and_unlock();
    EXPECT_EQ(bench.command({0xEB, 0x01, 0, 1}), good);
    ASSERT_TRUE(bench.write_float("advisory_on", 1.1F));
    EXPECT_EQ(bench.command({0xEB, 0x01, 0, 0}), (Bytes{0xFE, 0x26}));
    EXPECT_EQ(bench.command({0xEA, 0x01, 0}), (Bytes{0xFF, 0, 0, 1}));
    EXPECT_EQ(bench.refused_field(), number_of("advisory_on"));
    EXPECT_NE(bench.used().advisory_on, 1.1F);
}

TEST(Pages, CopyTheReferenceBack) {
    Bench bench;
    bench.connect_and_unlock();
    ASSERT_TRUE(bench.write_float("warning_on", 0.85F));
    bench.cycle();
    EXPECT_EQ(bench.command({0xE4, 0, 1, 0, 0}), good);
    bench.cycle();
    EXPECT_EQ(bench.used().warning_on, image_parameters().warning_on);
    // While the reference is in use, too: then nothing is to be taken over.
    ASSERT_TRUE(bench.write_float("warning_on", 0.85F));
    bench.cycle();
    EXPECT_EQ(bench.command({0xEB, 0x01, 0, 1}), good);
    bench.cycle();
    const std::uint32_t changes = bench.changes();
    EXPECT_EQ(bench.command({0xE4, 0, 1, 0, 0}), good);
    bench.cycles(2);
    EXPECT_EQ(bench.changes(), changes);
    EXPECT_EQ(bench.read_float("warning_on"), image_parameters().warning_on);
}

TEST(Store, OutlivesARestartAndSaysSo) {
    Bench bench;
    bench.connect_and_unlock();
    ASSERT_TRUE(bench.write_float("warning_on", 0.85F));
    bench.cycle();
    EXPECT_EQ(bench.command({0xF9, 0x01}), good);
    ASSERT_EQ(bench.answers.size(), 2U);
    EXPECT_EQ(bench.answers[1], (Bytes{0xFD, 0x03}));
    bench.restart();
    bench.connect_and_unlock();
    EXPECT_EQ(bench.used().warning_on, 0.85F);
    EXPECT_EQ(bench.read_float("warning_on"), 0.85F);
    EXPECT_EQ(bench.command({0xEB, 0x02, 0, 1}), good);
    EXPECT_EQ(bench.read_float("warning_on"), image_parameters().warning_on);
}

TEST(Store, IsNotNeededForTheReference) {
    Bench bench;
    bench.connect_and_unlock();
    ASSERT_TRUE(bench.write_float("warning_on", 0.85F));
    bench.restart();
    EXPECT_EQ(bench.used().warning_on, image_parameters().warning_on);
}

TEST(Store, RefusesAPageThatNoStartWouldTake) {
    Bench bench;
    bench.connect_and_unlock();
    ASSERT_TRUE(bench.write_float("warning_on", 1.3F));
    EXPECT_EQ(bench.command({0xF9, 0x01}), (Bytes{0xFE, 0x26}));
    EXPECT_EQ(bench.one.writes(), 0);
    EXPECT_EQ(bench.answers.size(), 1U);
}

TEST(Store, TellsOfAMemoryThatTakesNothing) {
    Bench bench;
    bench.connect_and_unlock();
    bench.one.refuse(true);
    EXPECT_EQ(bench.command({0xF9, 0x01}), (Bytes{0xFE, 0x33}));
    bench.one.refuse(false);
    EXPECT_EQ(bench.command({0xF9, 0x01}), good);
}

TEST(Store, NeedsAMemory) {
    Bench bench;
    bench.has_memory = false;
    bench.restart();
    bench.connect_and_unlock();
    EXPECT_EQ(bench.read_float("warning_on"), image_parameters().warning_on);
    ASSERT_TRUE(bench.write_float("warning_on", 0.85F));
    bench.cycle();
    EXPECT_EQ(bench.used().warning_on, 0.85F);
    EXPECT_EQ(bench.command({0xF9, 0x01}), (Bytes{0xFE, 0x24}));
}

// Code and frame with which the ECU reports the stored section, in the first cycle.
struct Report {
    explicit Report(Bench& bench) {
        bench.cycle();
        const rsi::application::RolloverEcu& ecu = bench.ecu().ecu();
        has_code =
            ecu.diagnostic_memory().confirmed(rsi::monitoring::DiagnosticCode::stored_parameters_refused);
        EXPECT_EQ(ecu.stored_refusal() != rsi::application::ParametersRefusal::none, has_code);
        for (const rsi::hal::CanFrame& frame : bench.others) {
            if (frame.identifier == rsi::can_dbc::RolloverWarning::identifier) {
                sent =
                    rsi::can_dbc::decode<rsi::can_dbc::RolloverWarning>(frame.data).value.parameters_refusal;
            } else if (frame.identifier == rsi::can_dbc::RolloverStatus::identifier) {
                is_invalid =
                    rsi::can_dbc::decode<rsi::can_dbc::RolloverStatus>(frame.data).value.parameters_invalid;
            }
        }
    }

    bool has_code{false};
    bool is_invalid{true};
    rsi::can_dbc::RolloverWarning::ParametersRefusal sent{};
};

using Sent = rsi::can_dbc::RolloverWarning::ParametersRefusal;

void store_warning_on(Bench& bench, float value) {
    bench.connect_and_unlock();
    ASSERT_TRUE(bench.write_float("warning_on", value));
    ASSERT_EQ(bench.command({0xF9, 0x01}), good);
}

TEST(Store, IsTakenAHundredTimesInAStart) {
    Bench bench;
    bench.connect_and_unlock();
    for (int time = 0; time < 100; ++time) {
        ASSERT_EQ(bench.command({0xF9, 0x01}), good) << time;
    }
    EXPECT_EQ(bench.command({0xF9, 0x01}), (Bytes{0xFE, 0x24}));
    EXPECT_EQ(bench.one.writes() + bench.other.writes(), 100);
    bench.restart();
    bench.connect_and_unlock();
    EXPECT_EQ(bench.command({0xF9, 0x01}), good);
}

// Each try may wear it.
TEST(Store, IsTriedAHundredTimesInAStartThoughTheMemoryRefuses) {
    Bench bench;
    bench.connect_and_unlock();
    bench.one.refuse(true);
    for (int time = 0; time < 100; ++time) {
        ASSERT_EQ(bench.command({0xF9, 0x01}), (Bytes{0xFE, 0x33})) << time;
    }
    EXPECT_EQ(bench.command({0xF9, 0x01}), (Bytes{0xFE, 0x24}));
    EXPECT_EQ(bench.one.tries(), 100);
}

TEST(Store, InAMemoryThatRefusesAgainAndAgainIsReportedUntilOneIsTaken) {
    Bench bench;
    bench.connect_and_unlock();
    const auto is_reported = [&] {
        bench.ecu().ecu().report_storage(false);  // the memory of diagnosis beside it is good
        bench.cycle();
        return bench.ecu().ecu().diagnostic_memory().confirmed(
            rsi::monitoring::DiagnosticCode::storage_failed);
    };
    bench.one.refuse(true);
    for (int time = 0; time < 9; ++time) {
        bench.command({0xF9, 0x01});
    }
    EXPECT_FALSE(is_reported()) << "it may be busy";
    bench.command({0xF9, 0x01});
    EXPECT_TRUE(is_reported());
    bench.one.refuse(false);
    EXPECT_EQ(bench.command({0xF9, 0x01}), good);
    EXPECT_FALSE(is_reported());
}

// That of the section that was read is not of the values that are stored.
TEST(Store, KeepsNoSeal) {
    Bench bench;
    rsi::application::SectionBytes sealed{};
    std::copy(bench.reference.begin(), bench.reference.end(), sealed.begin());
    rsi::hal::SoftwareKeys keys{rsi::hal::test_keys};
    ASSERT_TRUE(rsi::application::seal_section(keys, 1U, sealed.data()));
    rsi::application::SectionRecord record{bench.one, bench.other};
    ASSERT_TRUE(record.write(sealed));
    bench.restart();
    store_warning_on(bench, 0.85F);
    rsi::application::SectionBytes stored{};
    ASSERT_EQ(rsi::application::SectionRecord(bench.one, bench.other).read(stored),
              rsi::application::RecordState::good);
    for (std::size_t place = rsi::application::section::length; place < stored.size(); ++place) {
        EXPECT_EQ(stored[place], 0U) << place;
    }
    EXPECT_EQ(rsi::application::section::values_of(stored.data()).warning_on, 0.85F);
}

// Its checksum is the one that XCP computes, before and after a change.
TEST(CalibrationInUse, HasTheNameOfItsSectionAndTheChecksumOfItsValues) {
    Bench bench;
    bench.reference[rsi::application::section::name_at] = 'X';
    rsi::application::section::put_checksum(bench.reference.data());
    bench.restart();
    bench.connect_and_unlock();
    const auto checksum_of_xcp = [&] {
        EXPECT_TRUE(bench.set_address(map::parameters_at));
        const Bytes answer = bench.command(Bench::with_word({0xF3, 0, 0, 0}, map::parameters_length));
        return rsi::application::u32_at(answer.data(), 4U);
    };
    const auto in_use = [&]() -> const rsi::application::CalibrationIdentity& {
        return bench.ecu().ecu().calibration();
    };
    const std::uint32_t before = checksum_of_xcp();
    EXPECT_EQ(in_use().checksum, before);
    EXPECT_EQ(in_use().name[0], 'X');
    EXPECT_TRUE(std::equal(in_use().name.begin(), in_use().name.end(),
                           bench.reference.begin() + rsi::application::section::name_at));
    ASSERT_TRUE(bench.write_float("warning_on", 0.85F));
    bench.cycles(2);
    EXPECT_NE(checksum_of_xcp(), before);
    EXPECT_EQ(in_use().checksum, checksum_of_xcp());

    bench.ecu().ecu().init(image_parameters());
    EXPECT_EQ(in_use().checksum, before);
    EXPECT_EQ(in_use().name[0], 0U) << "it is of no section";
    bench.restart();
    EXPECT_EQ(in_use().name[0], 'X');
    bench.ecu().ecu().init(bench.reference.data(), 10U);
    EXPECT_EQ(in_use().name[0], 0U) << "one that is refused";
}

TEST(Store, IsReportedWhereItIsRefused) {
    Bench bench;
    EXPECT_FALSE(Report{bench}.has_code) << "nothing is stored";
    store_warning_on(bench, 0.85F);
    bench.restart();
    EXPECT_EQ(bench.used().warning_on, 0.85F);
    EXPECT_FALSE(Report{bench}.has_code);

    bench.one.record()[100] ^= 1U;
    bench.restart();
    EXPECT_EQ(bench.used().warning_on, image_parameters().warning_on);
    const Report report{bench};
    EXPECT_TRUE(report.has_code);
    EXPECT_EQ(report.sent, Sent::checksum);
    EXPECT_FALSE(report.is_invalid) << "the image's are good";
}

TEST(Store, ThatIsDamagedGivesWayToTheOneBeforeAndIsReported) {
    Bench bench;
    store_warning_on(bench, 0.85F);
    store_warning_on(bench, 0.86F);
    bench.other.record()[100] ^= 1U;
    bench.restart();
    EXPECT_EQ(bench.used().warning_on, 0.85F);
    EXPECT_TRUE(Report{bench}.has_code);
    store_warning_on(bench, 0.87F);
    bench.restart();
    EXPECT_EQ(bench.used().warning_on, 0.87F);
    EXPECT_FALSE(Report{bench}.has_code) << "the damaged one has been replaced";
}

TEST(Store, OfOtherSoftwareIsReportedWithTheReason) {
    const auto report = [](std::size_t byte) {
        rsi::application::SectionBytes bytes{};
        std::copy_n(rsi_parameter_section, rsi::application::section::length, bytes.begin());
        bytes[byte] ^= 0x80U;
        rsi::application::section::put_checksum(bytes.data());
        Bench bench;
        rsi::application::SectionRecord record{bench.one, bench.other};
        EXPECT_TRUE(record.write(bytes));
        bench.restart();
        const Report found{bench};
        EXPECT_TRUE(found.has_code);
        EXPECT_EQ(bench.used().warning_on, image_parameters().warning_on);
        return found.sent;
    };
    EXPECT_EQ(report(rsi::application::section::version_at), Sent::version);
    EXPECT_EQ(report(rsi::application::section::layout_at), Sent::layout);
    EXPECT_EQ(report(rsi::application::section::values_at + 3U), Sent::value);
}

TEST(Store, ThatCannotBeReadGivesWayToTheReferenceAndIsReported) {
    Bench bench;
    store_warning_on(bench, 0.85F);
    bench.one.set_unreadable(true);
    bench.restart();
    EXPECT_EQ(bench.used().warning_on, image_parameters().warning_on);
    EXPECT_EQ(Report{bench}.sent, Sent::checksum);
}

// The image's own refusal is the one that makes the function unavailable.
TEST(Store, ThatIsRefusedYieldsInTheFrameToARefusedReference) {
    Bench bench;
    bench.one.set_unreadable(true);
    bench.reference[0] = 0U;
    bench.restart();
    const Report report{bench};
    EXPECT_TRUE(report.has_code);
    EXPECT_TRUE(report.is_invalid);
    EXPECT_EQ(report.sent, Sent::missing);
}

// An image whose parameters contradict each other can be calibrated to work.
TEST(Reference, WhoseValuesAreRefusedCanBeCorrected) {
    Bench bench;
    const std::size_t at =
        rsi::application::section::values_at + Bench::address_of("warning_on") - map::parameters_at;
    bench.reference[at + 3U] = 0x40U;  // 3.x
    rsi::application::section::put_checksum(bench.reference.data());
    bench.restart();
    bench.cycles(100);
    EXPECT_EQ(bench.ecu().ecu().outputs().state, RSI_STATE_UNAVAILABLE);
    bench.connect_and_unlock();
    ASSERT_TRUE(bench.write_float("warning_on", 0.9F));
    bench.cycles(cycles_for_a_vehicle + 100);
    EXPECT_EQ(bench.ecu().ecu().outputs().state, RSI_STATE_READY);
    EXPECT_EQ(bench.command({0xEB, 0x01, 0, 1}), (Bytes{0xFE, 0x26}));
}

TEST(Reference, ThatIsNoneCanBeMeasuredBesideAndNotCalibrated) {
    Bench bench;
    bench.reference[0] = 0U;
    bench.restart();
    bench.connect_and_unlock();
    EXPECT_EQ(bench.command(Bench::with_word({0xF4, 4, 0, 0}, map::parameters_at)), (Bytes{0xFE, 0x24}));
    EXPECT_EQ(bench.upload(map::outputs_at, 4U), (Bytes{0, 0, 0, 0}));
    EXPECT_EQ(bench.download(map::parameters_at, {0, 0, 0, 0}), (Bytes{0xFE, 0x24}));
    EXPECT_EQ(bench.command({0xEB, 0x01, 0, 0}), (Bytes{0xFE, 0x26}));
    EXPECT_EQ(bench.command({0xE4, 0, 1, 0, 0}), (Bytes{0xFE, 0x26}));
    EXPECT_EQ(bench.command({0xF9, 0x01}), (Bytes{0xFE, 0x24}));
    ASSERT_TRUE(bench.set_address(map::parameters_at));
    EXPECT_EQ(bench.command(Bench::with_word({0xF3, 0, 0, 0}, 4U)), (Bytes{0xFE, 0x24}));
}

}  // namespace
}  // namespace testing_xcp
