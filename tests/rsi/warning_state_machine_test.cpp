// Every transition of the warning state machine, sample by sample.
#include "rsi/warning/warning_state_machine.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/stages.hpp"

namespace warning_state_machine_test {
namespace {

rsi_parameters quick() {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.advisory_on = 0.8F;
    parameters.advisory_off = 0.7F;
    parameters.warning_on = 1.0F;
    parameters.warning_off = 0.9F;
    parameters.warning_confirmation_s = 0.0F;
    parameters.advisory_hold_s = 0.0F;
    parameters.warning_hold_s = 0.0F;
    parameters.recovery_s = 0.0F;
    return parameters;
}

class Warning {
 public:
    explicit Warning(const rsi_parameters& parameters) { machine_.init(parameters); }

    rsi_state after(float indicator, float side = 1.0F, float opposite = 0.0F) {
        machine_.update(rsi::RiskLevel{indicator, side, opposite});
        return machine_.state();
    }
    rsi_state after_samples(int samples, float indicator, float side = 1.0F) {
        for (int k = 0; k < samples; ++k) {
            after(indicator, side);
        }
        return machine_.state();
    }
    rsi_state after_gap() {
        machine_.update_unavailable();
        return machine_.state();
    }
    rsi_state state() const { return machine_.state(); }
    rsi_side side() const { return machine_.side(); }

 private:
    rsi_test::WarningStateMachine machine_{};
};

TEST(WarningStateMachine, StartsUnavailable) {
    const Warning warning(quick());
    EXPECT_EQ(warning.state(), RSI_STATE_UNAVAILABLE);
    EXPECT_EQ(warning.side(), RSI_SIDE_NONE);
}

TEST(WarningStateMachine, IsUnavailableWithoutANumber) {
    for (const float no_number :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
          -std::numeric_limits<float>::infinity()}) {
        Warning warning(quick());
        EXPECT_EQ(warning.after(1.5F), RSI_STATE_WARNING);
        EXPECT_EQ(warning.after(no_number), RSI_STATE_UNAVAILABLE);
        EXPECT_EQ(warning.side(), RSI_SIDE_NONE);
        EXPECT_EQ(warning.after(0.1F), RSI_STATE_READY);
    }
}

TEST(WarningStateMachine, RisesAtTheOnLevelsAndNotBelow) {
    Warning warning(quick());
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);
    EXPECT_EQ(warning.after(0.799F), RSI_STATE_READY);
    EXPECT_EQ(warning.after(0.8F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(0.999F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(1.0F), RSI_STATE_WARNING);
}

TEST(WarningStateMachine, GoesStraightFromReadyToWarning) {
    Warning warning(quick());
    warning.after(0.0F);
    EXPECT_EQ(warning.after(1.2F), RSI_STATE_WARNING);
}

TEST(WarningStateMachine, FallsBelowTheOffLevelsAndNotAtThem) {
    Warning warning(quick());
    warning.after(1.0F);
    EXPECT_EQ(warning.after(0.9F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.after(0.899F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(0.7F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(0.699F), RSI_STATE_READY);
}

TEST(WarningStateMachine, GoesStraightFromWarningToReadyWhenTheRiskIsGone) {
    Warning warning(quick());
    warning.after(1.0F);
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);
}

TEST(WarningStateMachine, BetweenOffAndOnTheStateStaysWhatItWas) {
    Warning warning(quick());
    EXPECT_EQ(warning.after(0.75F), RSI_STATE_READY);
    warning.after(0.8F);
    EXPECT_EQ(warning.after(0.75F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(0.95F), RSI_STATE_ADVISORY);
    warning.after(1.0F);
    EXPECT_EQ(warning.after(0.95F), RSI_STATE_WARNING);
}

TEST(WarningStateMachine, TheWarningStateLastsAtLeastItsHoldTime) {
    rsi_parameters parameters = quick();
    parameters.warning_hold_s = 0.5F;
    Warning warning(parameters);
    warning.after(1.0F);  // the first of 50 samples
    EXPECT_EQ(warning.after_samples(49, 0.0F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);
}

TEST(WarningStateMachine, TheAdvisoryStateLastsAtLeastItsHoldTime) {
    rsi_parameters parameters = quick();
    parameters.advisory_hold_s = 0.3F;
    Warning warning(parameters);
    warning.after(0.85F);  // the first of 30 samples
    EXPECT_EQ(warning.after_samples(29, 0.0F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);
}

TEST(WarningStateMachine, AHeldAdvisoryStillRisesToWarningAtOnce) {
    rsi_parameters parameters = quick();
    parameters.advisory_hold_s = 10.0F;
    Warning warning(parameters);
    warning.after(0.85F);
    EXPECT_EQ(warning.after(1.0F), RSI_STATE_WARNING);
}

TEST(WarningStateMachine, TheHoldTimeCountsFromTheLastSampleAtTheLevelOfTheState) {
    rsi_parameters parameters = quick();
    parameters.warning_hold_s = 0.5F;
    parameters.advisory_hold_s = 0.3F;
    Warning warning(parameters);
    warning.after_samples(200, 1.1F);
    warning.after_samples(40, 0.99F);
    warning.after(1.0F);  // at the level itself: the first of 50 samples
    EXPECT_EQ(warning.after_samples(49, 0.0F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);

    warning.after_samples(200, 0.85F);
    warning.after_samples(20, 0.79F);
    warning.after(0.8F);  // the first of 30
    EXPECT_EQ(warning.after_samples(29, 0.0F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);
}

// The hold of the warning is for what reached its level, not that of the advisory.
TEST(WarningStateMachine, ALevelBetweenAdvisoryAndWarningDoesNotProlongAWarning) {
    rsi_parameters parameters = quick();
    parameters.warning_hold_s = 0.5F;
    Warning warning(parameters);
    warning.after(1.0F);
    EXPECT_EQ(warning.after_samples(49, 0.85F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.after(0.85F), RSI_STATE_ADVISORY);
}

TEST(WarningStateMachine, AWarningThatFallsToAnAdvisoryHoldsThatFromThen) {
    rsi_parameters parameters = quick();
    parameters.warning_hold_s = 0.5F;
    parameters.advisory_hold_s = 0.3F;
    Warning warning(parameters);
    warning.after(1.0F);
    EXPECT_EQ(warning.after_samples(49, 0.75F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.after(0.75F), RSI_STATE_ADVISORY);  // the first of 30 samples
    EXPECT_EQ(warning.after_samples(29, 0.0F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);
}

TEST(WarningStateMachine, AWarningNeedsConfirmationWithoutInterruption) {
    rsi_parameters parameters = quick();
    parameters.warning_confirmation_s = 0.05F;
    Warning warning(parameters);
    EXPECT_EQ(warning.after_samples(4, 1.2F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(0.95F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after_samples(4, 1.2F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(1.2F), RSI_STATE_WARNING);
}

TEST(WarningStateMachine, OneSampleIsEnoughWithoutConfirmationTime) {
    Warning warning(quick());
    warning.after(0.0F);
    EXPECT_EQ(warning.after(1.0F), RSI_STATE_WARNING);
}

TEST(WarningStateMachine, TheVehicleFallsRightInALeftTurnAndLeftInARightTurn) {
    Warning left_turn(quick());
    left_turn.after(1.0F, 1.0F);
    EXPECT_EQ(left_turn.side(), RSI_SIDE_RIGHT);
    Warning right_turn(quick());
    right_turn.after(0.85F, -1.0F);
    EXPECT_EQ(right_turn.side(), RSI_SIDE_LEFT);
}

TEST(WarningStateMachine, WhileReadyNoSideIsNamed) {
    Warning warning(quick());
    warning.after(0.79F, 1.0F);
    EXPECT_EQ(warning.side(), RSI_SIDE_NONE);
    warning.after(1.0F, 1.0F);
    warning.after(0.0F, 1.0F);
    EXPECT_EQ(warning.side(), RSI_SIDE_NONE);
}

TEST(WarningStateMachine, AHeldStateKeepsItsSideUntilTheIndicatorPointsToTheOther) {
    for (const float cause : {0.85F, 1.0F}) {
        rsi_parameters parameters = quick();
        parameters.advisory_hold_s = 1.0F;
        parameters.warning_hold_s = 1.0F;
        Warning warning(parameters);
        const rsi_state state = warning.after(cause, 1.0F);
        ASSERT_GE(state, RSI_STATE_ADVISORY);
        for (const float level : {0.7F, 0.699F, 0.0F}) {
            EXPECT_EQ(warning.after(level, 1.0F), state);
            EXPECT_EQ(warning.side(), RSI_SIDE_RIGHT) << level;
        }
        EXPECT_EQ(warning.after(0.699F, -1.0F), state);
        EXPECT_EQ(warning.side(), RSI_SIDE_NONE);
        EXPECT_EQ(warning.after(0.699F, 1.0F), state);  // one that is gone comes back with its risk only
        EXPECT_EQ(warning.side(), RSI_SIDE_NONE);
        EXPECT_EQ(warning.after(0.7F, -1.0F), state);
        EXPECT_EQ(warning.side(), RSI_SIDE_LEFT);
    }
}

TEST(WarningStateMachine, ASideKeepsItsNameWhileItsOwnRiskLastsAndTheOtherIsNoHigherThanTheStatesLevel) {
    Warning warning(quick());
    warning.after(1.0F, 1.0F);
    warning.after(0.99F, -1.0F, 0.8F);
    EXPECT_EQ(warning.side(), RSI_SIDE_RIGHT);
    warning.after(0.79F, -1.0F, 0.7F);
    EXPECT_EQ(warning.side(), RSI_SIDE_RIGHT);
    warning.after(0.79F, -1.0F, 0.699F);
    EXPECT_EQ(warning.side(), RSI_SIDE_LEFT);
}

TEST(WarningStateMachine, AWarningNamesNoSideOnceBothRisksAreOverAndTheOtherIsTheLarger) {
    rsi_parameters parameters = quick();
    parameters.warning_hold_s = 1.0F;
    Warning warning(parameters);
    warning.after(1.0F, 1.0F);
    EXPECT_EQ(warning.after(0.7F, -1.0F, 0.699F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.side(), RSI_SIDE_LEFT);
    EXPECT_EQ(warning.after(0.699F, 1.0F, 0.699F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.side(), RSI_SIDE_NONE);
}

// Which of them it is does not wait for a higher level: no side is named yet that could stay.
TEST(WarningStateMachine, AHeldWarningWithoutASideNamesTheRiskierOneOnceBothAreBackAtTheOffLevel) {
    rsi_parameters parameters = quick();
    parameters.warning_hold_s = 1.0F;
    Warning warning(parameters);
    warning.after(1.0F, 1.0F);
    warning.after(0.0F, -1.0F);
    EXPECT_EQ(warning.side(), RSI_SIDE_NONE);
    EXPECT_EQ(warning.after(0.75F, -1.0F, 0.72F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.side(), RSI_SIDE_LEFT);
}

TEST(WarningStateMachine, TheOtherSideTakesOverAtTheStatesLevelThoughTheFirstOnesRiskLasts) {
    Warning warning(quick());
    warning.after(1.2F, 1.0F);
    warning.after(1.0F, -1.0F, 0.9F);  // at the level itself
    EXPECT_EQ(warning.side(), RSI_SIDE_LEFT);
}

TEST(WarningStateMachine, NoSideBelowTheAdvisoryLevelIsNamedWhileTheOtherIsAbove) {
    rsi_parameters parameters = quick();
    parameters.warning_hold_s = 1.0F;
    for (const float opposite : {0.0F, 0.75F, 0.799F}) {
        Warning warning(parameters);
        warning.after(1.0F, 1.0F);
        EXPECT_EQ(warning.after(0.8F, -1.0F, opposite), RSI_STATE_WARNING);
        EXPECT_EQ(warning.side(), RSI_SIDE_LEFT) << opposite;
    }
}

TEST(WarningStateMachine, ANewRiskOnTheOtherSideTakesOver) {
    rsi_parameters parameters = quick();
    parameters.warning_hold_s = 1.0F;
    Warning warning(parameters);
    warning.after(1.0F, 1.0F);
    warning.after(1.0F, -1.0F);
    EXPECT_EQ(warning.state(), RSI_STATE_WARNING);
    EXPECT_EQ(warning.side(), RSI_SIDE_LEFT);
}

TEST(WarningStateMachine, AnAdvisoryChangesSideAtItsOwnLevel) {
    Warning warning(quick());
    warning.after(0.85F, 1.0F);
    warning.after(0.79F, -1.0F, 0.75F);
    EXPECT_EQ(warning.side(), RSI_SIDE_RIGHT);
    warning.after(0.8F, -1.0F, 0.79F);
    EXPECT_EQ(warning.side(), RSI_SIDE_LEFT);
}

TEST(WarningStateMachine, AMissingStatementIsUnavailableAtOnceFromEveryState) {
    for (const float indicator : {0.0F, 0.85F, 1.2F}) {
        rsi_parameters parameters = quick();
        parameters.warning_hold_s = 10.0F;
        parameters.advisory_hold_s = 10.0F;
        Warning warning(parameters);
        warning.after(indicator);
        ASSERT_NE(warning.state(), RSI_STATE_UNAVAILABLE);
        EXPECT_EQ(warning.after_gap(), RSI_STATE_UNAVAILABLE);
        EXPECT_EQ(warning.side(), RSI_SIDE_NONE);
    }
}

TEST(WarningStateMachine, UnavailableIsLeftOnlyAfterTheRecoveryTime) {
    rsi_parameters parameters = quick();
    parameters.recovery_s = 0.2F;
    Warning warning(parameters);
    EXPECT_EQ(warning.after_samples(19, 0.0F), RSI_STATE_UNAVAILABLE);
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);
}

TEST(WarningStateMachine, AGapRestartsTheRecoveryTime) {
    rsi_parameters parameters = quick();
    parameters.recovery_s = 0.2F;
    Warning warning(parameters);
    warning.after_samples(19, 0.0F);
    warning.after_gap();
    EXPECT_EQ(warning.after_samples(19, 0.0F), RSI_STATE_UNAVAILABLE);
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);
}

TEST(WarningStateMachine, ARiskPresentAtRecoveryIsShownAtOnce) {
    rsi_parameters parameters = quick();
    parameters.recovery_s = 0.1F;
    Warning warning(parameters);
    EXPECT_EQ(warning.after_samples(9, 1.2F, -1.0F), RSI_STATE_UNAVAILABLE);
    EXPECT_EQ(warning.after(1.2F, -1.0F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.side(), RSI_SIDE_LEFT);
}

TEST(WarningStateMachine, AGapForgetsAnUnfinishedConfirmation) {
    rsi_parameters parameters = quick();
    parameters.warning_confirmation_s = 0.05F;
    Warning warning(parameters);
    warning.after_samples(4, 1.2F);
    warning.after_gap();
    EXPECT_EQ(warning.after_samples(4, 1.2F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(1.2F), RSI_STATE_WARNING);
}

TEST(WarningStateMachine, StartingAgainForgetsEverything) {
    rsi_test::WarningStateMachine machine;
    machine.init(quick());
    machine.update(rsi::RiskLevel{1.2F, 1.0F});
    machine.init(quick());
    EXPECT_EQ(machine.state(), RSI_STATE_UNAVAILABLE);
    EXPECT_EQ(machine.side(), RSI_SIDE_NONE);
}

TEST(WarningStateMachine, AWarningThatEndsStaysAdvisoryDownToTheAdvisorysOffLevel) {
    for (const bool below : {false, true}) {
        Warning warning(quick());
        warning.after(1.2F);
        EXPECT_EQ(warning.after(below ? 0.699F : 0.7F), below ? RSI_STATE_READY : RSI_STATE_ADVISORY);
    }
}

// To the nearest of 10 ms.
TEST(WarningStateMachine, TimesAreRoundedToSamples) {
    for (const float time_s : {0.0253F, 0.0347F}) {
        rsi_parameters parameters = quick();
        parameters.warning_confirmation_s = time_s;
        Warning warning(parameters);
        EXPECT_EQ(warning.after_samples(2, 1.2F), RSI_STATE_ADVISORY) << time_s;
        EXPECT_EQ(warning.after(1.2F), RSI_STATE_WARNING) << time_s;
    }
}

TEST(WarningStateMachine, TheHoldTimesDoNotCountWhatWasBefore) {
    rsi_parameters parameters = quick();
    parameters.advisory_hold_s = 0.1F;
    parameters.warning_hold_s = 0.2F;
    Warning warning(parameters);
    warning.after_samples(500, 0.0F);
    EXPECT_EQ(warning.after(0.85F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after_samples(9, 0.0F), RSI_STATE_ADVISORY);
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);
    warning.after_samples(500, 0.85F);
    EXPECT_EQ(warning.after(1.2F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.after_samples(19, 0.0F), RSI_STATE_WARNING);
    EXPECT_EQ(warning.after(0.0F), RSI_STATE_READY);
}

}  // namespace
}  // namespace warning_state_machine_test
