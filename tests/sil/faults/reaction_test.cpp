// Measures of an ECU's reaction to a fault: answers written by hand, each measure at its limits.
#include <gtest/gtest.h>

#include <optional>

#include "sil/studies/faults/judgement.hpp"
#include "tests/sil/faults/written_answer.hpp"

namespace faults_test::reaction_test {
namespace {

using sil::Degradation;
using sil::EcuAnswer;
using sil::Fault;
using sil::FaultKind;
using sil::FaultPlace;
using sil::Reaction;
using sil::RollSource;
using sil::WarningState;

constexpr std::size_t begins = 100U;
constexpr std::size_t is_over = 300U;
constexpr std::size_t length = 600U;
constexpr Fault lost{FaultKind::lost, FaultPlace::imu_frame, 0.0};

EcuAnswer saying(WarningState state, sil::DiagnosticCodes codes = 0U) {
    return written_answer(state, sil::WarningSide::none, codes);
}

EcuAnswer with_source(RollSource source) {
    EcuAnswer one = saying(WarningState::ready);
    one.roll_source = source;
    return one;
}

EcuAnswer with_degradation(Degradation degradation) {
    EcuAnswer one = saying(WarningState::ready);
    one.degradation = degradation;
    return one;
}

// Two ECUs that are ready all the time, but for what a test writes.
struct Runs {
    using Answers = std::vector<std::optional<EcuAnswer>>;

    Runs() {
        drive.samples.resize(length);
        drive.fault_begin = begins;
        drive.fault_end = is_over;
        right.answers.assign(length, saying(WarningState::ready));
        faulty.answers = right.answers;
        faulty.visible = begins;
        faulty.over = is_over;
    }
    static void write(Answers& answers, std::size_t from, std::size_t until,
                      const std::optional<EcuAnswer>& one) {
        for (std::size_t cycle = from; cycle < until; ++cycle) {
            answers[cycle] = one;
        }
    }
    // Answers of the ECU with the fault, of the other one, of both.
    Runs& say(std::size_t from, std::size_t until, const std::optional<EcuAnswer>& one) {
        write(faulty.answers, from, until, one);
        return *this;
    }
    Runs& right_says(std::size_t from, std::size_t until, const EcuAnswer& one) {
        write(right.answers, from, until, one);
        return *this;
    }
    Runs& both_say(std::size_t from, std::size_t until, const EcuAnswer& one) {
        return say(from, until, one).right_says(from, until, one);
    }
    Runs& visible(std::optional<std::size_t> cycle) {
        faulty.visible = cycle;
        return *this;
    }
    Runs& lifts(std::size_t cycle) {
        drive.two_wheel_lift = cycle;
        return *this;
    }
    Reaction of(const Fault& fault = lost) const { return measure(drive, fault, right, faulty); }

    sil::FaultedDrive drive{};
    sil::FaultyRun right{};
    sil::FaultyRun faulty{};
};

TEST(Reaction, IsNoneWhereBothSayTheSame) {
    const Reaction none = Runs{}.of();
    EXPECT_TRUE(none.visible);
    EXPECT_TRUE(none.watchdog_fed);
    EXPECT_FALSE(none.unavailable || none.observer || none.motion_lost || none.code);
    EXPECT_FALSE(none.warning_due || none.warning_missed);
    EXPECT_FALSE(none.lead_loss || none.lead || none.due);
    EXPECT_EQ(none.silence, 0);
    EXPECT_EQ(none.wrong, 0);
    EXPECT_EQ(none.lapse, 0);
    EXPECT_EQ(none.false_warning, 0);
    EXPECT_EQ(none.recovery, 0);
    EXPECT_EQ(none.healing, 0);
    EXPECT_EQ(none.incomplete_cycles, 0U);
    EXPECT_EQ(none.undefined_cycles, 0U);
}

TEST(Reaction, CountsFromTheCycleInWhichTheFaultWasVisible) {
    Runs runs = Runs{}.say(begins + 3U, is_over, saying(WarningState::unavailable, 1U));
    EXPECT_EQ(runs.of().unavailable, 30);
    EXPECT_EQ(runs.of().code, 30);
    EXPECT_EQ(runs.of().code_name, sil::diagnostic_names(1U).front());
    EXPECT_EQ(runs.visible(begins + 10U).of().unavailable, -70);
    EXPECT_EQ(runs.visible(begins + 10U).of().code, -70);
    EXPECT_TRUE(runs.of().visible);
    EXPECT_EQ(runs.visible(std::nullopt).of().unavailable, 30) << "from its beginning where it was not";
    EXPECT_FALSE(runs.of().visible);
}

TEST(Reaction, BeginsWithTheFaultAndNotBefore) {
    const EcuAnswer told = saying(WarningState::unavailable, 1U);
    EXPECT_FALSE(Runs{}.say(0U, begins, told).of().unavailable);
    EXPECT_FALSE(Runs{}.say(0U, begins, told).of().code);
    EXPECT_EQ(Runs{}.say(0U, begins + 1U, told).of().unavailable, 0);
    EXPECT_EQ(Runs{}.say(length - 1U, length, told).of().code, 10 * static_cast<int>(length - 1U - begins));
}

TEST(Reaction, IsTheFirstOfEach) {
    EcuAnswer other = with_degradation(Degradation::motion_lost);
    other.roll_source = RollSource::observer;
    other.codes = 2U;
    Runs runs = Runs{}.say(begins + 4U, begins + 5U, other).say(begins + 9U, begins + 12U, other);
    runs.say(begins + 20U, begins + 21U, saying(WarningState::unavailable, 1U));
    EXPECT_EQ(runs.of().observer, 40);
    EXPECT_EQ(runs.of().motion_lost, 40);
    EXPECT_EQ(runs.of().code, 40);
    EXPECT_EQ(runs.of().code_name, sil::diagnostic_names(2U).front());
    EXPECT_EQ(runs.of().unavailable, 200);
}

TEST(Reaction, IsOnlyWhatIsNotSaidWithoutTheFault) {
    Runs unavailable = Runs{}.both_say(0U, length, saying(WarningState::unavailable, 1U));
    EXPECT_FALSE(unavailable.of().unavailable);
    EXPECT_FALSE(unavailable.of().code);
    unavailable.say(begins + 5U, begins + 6U, saying(WarningState::unavailable, 3U));
    EXPECT_EQ(unavailable.of().code, 50);
    EXPECT_EQ(unavailable.of().code_name, sil::diagnostic_names(2U).front());
    EXPECT_FALSE(Runs{}.both_say(0U, length, with_source(RollSource::observer)).of().observer);
    EXPECT_EQ(Runs{}.say(begins + 2U, length, with_source(RollSource::observer)).of().observer, 20);
    EXPECT_FALSE(Runs{}
                     .right_says(0U, length, with_source(RollSource::none))
                     .say(0U, length, with_source(RollSource::observer))
                     .of()
                     .observer)
        << "no sensor was in use";
    EXPECT_FALSE(Runs{}.both_say(0U, length, with_degradation(Degradation::motion_lost)).of().motion_lost);
    EXPECT_FALSE(Runs{}
                     .right_says(0U, length, with_degradation(Degradation::roll_sensor_lost))
                     .say(0U, length, with_degradation(Degradation::motion_lost))
                     .of()
                     .motion_lost)
        << "it was degraded before";
}

TEST(Reaction, OfAnEcuThatIsNotHeardIsNone) {
    const EcuAnswer told = saying(WarningState::unavailable, 1U);
    const Fault off{FaultKind::bus_off, FaultPlace::bus, 0.0};
    EXPECT_FALSE(Runs{}.say(begins, is_over, told).of(off).unavailable);
    EXPECT_EQ(Runs{}.say(begins, is_over + 1U, told).of(off).unavailable,
              10 * static_cast<int>(is_over - begins));
    EXPECT_EQ(Runs{}.say(begins, is_over, told).of(lost).unavailable, 0);
    EXPECT_EQ(Runs{}.say(begins, begins + 7U, std::nullopt).say(begins + 7U, is_over, told).of().unavailable,
              70);
}

TEST(Reaction, SilenceIsTheLongestReadyWithoutACodeWhileAWarningIsDue) {
    const auto silent = [](std::size_t from, std::size_t until, const EcuAnswer& one) {
        return Runs{}.both_say(200U, 250U, saying(WarningState::warning)).say(from, until, one);
    };
    const EcuAnswer ready = saying(WarningState::ready);
    EXPECT_EQ(silent(210U, 213U, ready).of().silence, 30);
    EXPECT_EQ(silent(210U, 213U, ready).say(220U, 222U, ready).of().silence, 30);
    EXPECT_EQ(silent(210U, 212U, ready).say(220U, 223U, ready).of().silence, 30);
    EXPECT_EQ(silent(248U, 260U, ready).of().silence, 20) << "it is due until 250";
    EXPECT_EQ(silent(210U, 213U, saying(WarningState::ready, 1U)).of().silence, 0);
    EXPECT_EQ(silent(210U, 213U, saying(WarningState::advisory)).of().silence, 0);
    EXPECT_TRUE(silences_a_warning(silent(210U, 211U, ready).of()));
    EXPECT_FALSE(silences_a_warning(silent(210U, 210U, ready).of()));
}

TEST(Reaction, WrongIsTheLongestOtherStateWithoutACode) {
    const EcuAnswer advisory = saying(WarningState::advisory);
    EXPECT_EQ(Runs{}.say(210U, 213U, advisory).say(220U, 222U, advisory).of().wrong, 30);
    EXPECT_EQ(Runs{}.say(210U, 212U, advisory).say(220U, 223U, advisory).of().wrong, 30);
    EXPECT_EQ(Runs{}.say(210U, 213U, saying(WarningState::advisory, 1U)).of().wrong, 0);
    EXPECT_EQ(Runs{}.both_say(210U, 213U, advisory).of().wrong, 0);
}

TEST(Reaction, LapseIsTheLongestTimeWithoutANewCodeAfterTheFirstAndDuringTheFault) {
    const EcuAnswer told = saying(WarningState::unavailable, 1U);
    EXPECT_EQ(Runs{}.say(150U, is_over, told).of().lapse, 0);
    EXPECT_EQ(Runs{}.say(150U, 151U, told).say(154U, 155U, told).say(156U, is_over, told).of().lapse, 30);
    EXPECT_EQ(Runs{}.say(150U, is_over - 2U, told).of().lapse, 20) << "what follows the fault does not count";
    EXPECT_EQ(
        Runs{}.right_says(200U, 202U, saying(WarningState::ready, 1U)).say(150U, is_over, told).of().lapse,
        20)
        << "a code that is there without the fault";
}

TEST(Reaction, FalseWarningsAddUpWhereNoneIsDueInTheDrive) {
    const EcuAnswer warning = saying(WarningState::warning, 1U);
    EXPECT_EQ(Runs{}.say(150U, 153U, warning).say(400U, 402U, warning).of().false_warning, 50);
    Runs due = Runs{}.say(150U, 153U, warning).right_says(500U, 501U, warning);
    EXPECT_EQ(due.of().false_warning, 0);
    EXPECT_TRUE(due.of().warning_due);
}

TEST(Reaction, CountsFramesThatAreNotSound) {
    EcuAnswer damaged = saying(WarningState::ready);
    damaged.complete = false;
    EcuAnswer undefined = saying(WarningState::ready);
    undefined.defined = false;
    const Reaction reaction = Runs{}.say(0U, begins + 2U, damaged).say(400U, 403U, undefined).of();
    EXPECT_EQ(reaction.incomplete_cycles, 2U);
    EXPECT_EQ(reaction.undefined_cycles, 3U);
}

TEST(Reaction, LeadIsFromTheWarningToLiftOffAndItsLossFromTheDueOne) {
    const EcuAnswer warning = saying(WarningState::warning);
    const auto warns_from = [&warning](std::size_t cycle) {
        return Runs{}.right_says(400U, length, warning).say(cycle, length, warning);
    };
    EXPECT_EQ(warns_from(412U).of().lead_loss, 120);
    EXPECT_FALSE(warns_from(412U).of().lead) << "no lift-off";
    EXPECT_EQ(warns_from(412U).lifts(430U).of().lead, 180);
    EXPECT_EQ(warns_from(395U).of().lead_loss, -50);
    EXPECT_EQ(warns_from(400U).of().lead_loss, 0);
    EXPECT_FALSE(warns_from(412U).of().warning_missed);
    EXPECT_TRUE(warns_from(412U).of().warning_due);
    EXPECT_TRUE(warns_from(length).lifts(430U).of().warning_missed);
    EXPECT_FALSE(warns_from(length).lifts(430U).of().lead_loss);
    EXPECT_FALSE(Runs{}.say(400U, length, warning).lifts(430U).of().lead) << "none is due";
    EXPECT_FALSE(Runs{}.of().warning_missed) << "none is due";
}

TEST(Reaction, RecoveryIsWatchedUntilTwoWheelsLiftOrTheDriveEnds) {
    EXPECT_EQ(Runs{}.of().watched_ms, 10 * static_cast<int>(length - is_over));
    EXPECT_EQ(Runs{}.lifts(is_over + 7U).of().watched_ms, 70);
    for (const std::size_t lift : {is_over, is_over - 1U}) {
        EXPECT_EQ(Runs{}.lifts(lift).of().watched_ms, 0);
        EXPECT_FALSE(Runs{}.lifts(lift).of().recovery);
        EXPECT_FALSE(Runs{}.lifts(lift).of().healing);
    }
}

TEST(Reaction, ADueWarningCountsFromTheEndOfTheFault) {
    const auto due_at = [](std::size_t cycle) {
        return Runs{}.right_says(cycle, length, saying(WarningState::warning)).of().due;
    };
    EXPECT_EQ(due_at(is_over + 20U), 200);
    EXPECT_EQ(due_at(is_over), 0);
    EXPECT_FALSE(due_at(is_over - 1U));
    EXPECT_FALSE(Runs{}.of().due);
}

TEST(Reaction, RecoveryIsTheBeginningOfTheLastingAgreement) {
    const EcuAnswer advisory = saying(WarningState::advisory);
    EXPECT_EQ(Runs{}.say(begins, is_over + 12U, advisory).of().recovery, 120);
    EXPECT_EQ(Runs{}.say(begins, is_over, advisory).of().recovery, 0);
    EXPECT_EQ(
        Runs{}.say(begins, is_over + 12U, advisory).say(is_over + 30U, is_over + 31U, advisory).of().recovery,
        310);
    EXPECT_FALSE(Runs{}.say(length - 1U, length, advisory).of().recovery);
    EXPECT_EQ(Runs{}.say(length - 2U, length - 1U, advisory).of().recovery,
              10 * static_cast<int>(length - 1U - is_over));
    EXPECT_EQ(Runs{}.say(is_over + 5U, is_over + 8U, std::nullopt).of().recovery, 80)
        << "it was not received";
    EXPECT_FALSE(Runs{}.say(400U, length, advisory).lifts(450U).of().recovery);
    EXPECT_EQ(Runs{}.say(450U, length, advisory).lifts(450U).of().recovery, 0) << "after lift-off";
}

TEST(Reaction, RecoveryNeedsStateRollSourceAndDegradationButNoCode) {
    for (const EcuAnswer& other : {saying(WarningState::advisory), with_source(RollSource::observer),
                                   with_degradation(Degradation::motion_lost)}) {
        EXPECT_EQ(Runs{}.say(is_over, is_over + 4U, other).of().recovery, 40);
        EXPECT_EQ(Runs{}.say(is_over, is_over + 4U, other).of().healing, 0);
    }
    Runs coded = Runs{}.say(is_over, is_over + 4U, saying(WarningState::ready, 1U));
    EXPECT_EQ(coded.of().recovery, 0);
    EXPECT_EQ(coded.of().healing, 40);
    coded.right_says(0U, length, saying(WarningState::ready, 1U));
    EXPECT_EQ(coded.of().healing, 0) << "the same code without the fault";
    EXPECT_FALSE(Runs{}.say(is_over, length, saying(WarningState::ready, 1U)).of().healing);
}

TEST(Reaction, TellsOfAWatchdogThatWasNotFed) {
    Runs unfed;
    unfed.faulty.watchdog_fed = false;
    EXPECT_FALSE(unfed.of().watchdog_fed);
}

}  // namespace
}  // namespace faults_test::reaction_test
