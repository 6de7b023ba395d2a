// The effect of a changed bit on the warning: every class, at its limits.
#include "sil/studies/faults/flip_effect.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using sil::FlipEffect;
using sil::Statement;
using sil::WarningSide;
using sil::WarningState;
using Statements = std::vector<Statement>;

constexpr std::size_t length = 100U;

Statements all_ready() {
    Statement ready;
    ready.state = WarningState::ready;
    ready.degradation = sil::Degradation::full;
    return Statements(length, ready);
}

// A warning towards `side` from the cycle `begin` to before `end`.
Statements with_warning(Statements statements, std::size_t begin, std::size_t end,
                        WarningSide side = WarningSide::right) {
    for (std::size_t cycle = begin; cycle < end; ++cycle) {
        statements[cycle].state = WarningState::warning;
        statements[cycle].side = side;
    }
    return statements;
}

Statements warned(std::size_t begin, std::size_t end) {
    return with_warning(all_ready(), begin, end);
}

FlipEffect effect(const Statements& statements, const Statements& undisturbed) {
    return sil::effect_of(statements, undisturbed, 0U);
}

TEST(AFlip, ThatChangesNothingHasNoEffect) {
    EXPECT_EQ(effect(warned(40U, 60U), warned(40U, 60U)), FlipEffect::none);
    EXPECT_EQ(effect(all_ready(), all_ready()), FlipEffect::none);
}

TEST(AFlip, ThatMovesTheWarningByFiftyMillisecondsIsInTime) {
    EXPECT_EQ(effect(warned(45U, 65U), warned(40U, 60U)), FlipEffect::in_time);
    EXPECT_EQ(effect(warned(35U, 55U), warned(40U, 60U)), FlipEffect::in_time);
}

TEST(AFlip, ThatChangesAnotherStatementOnlyIsInTime) {
    Statements advisory = all_ready();
    advisory[50U].state = WarningState::advisory;
    EXPECT_EQ(effect(advisory, all_ready()), FlipEffect::in_time);
}

TEST(AFlip, ThatChangesAnyPartOfTheStatementHasAnEffect) {
    const auto effect_of_change = [](auto change) {
        Statements statements = all_ready();
        Statements undisturbed = all_ready();
        undisturbed[50U].codes = 4U;
        undisturbed[50U].sound = false;
        undisturbed[50U].degradation = sil::Degradation::motion_lost;
        statements = undisturbed;
        change(statements[50U]);
        return effect(statements, undisturbed);
    };
    EXPECT_EQ(effect_of_change([](Statement&) {}), FlipEffect::none);
    EXPECT_EQ(effect_of_change([](Statement& one) { one.codes = 0U; }), FlipEffect::in_time);
    EXPECT_EQ(effect_of_change([](Statement& one) { one.sound = true; }), FlipEffect::in_time);
    EXPECT_EQ(effect_of_change([](Statement& one) { one.degradation = sil::Degradation::full; }),
              FlipEffect::in_time);
    EXPECT_EQ(effect_of_change([](Statement& one) { one.state = WarningState::advisory; }),
              FlipEffect::in_time);
}

// A second due warning does not make up for the first.
TEST(AFlip, ThatTakesOneOfTwoWarningsAwayIsMissing) {
    EXPECT_EQ(effect(warned(70U, 90U), with_warning(warned(70U, 90U), 20U, 40U)), FlipEffect::missing);
}

TEST(AFlip, IsNotToldByAnEcuThatIsUnavailableWithoutIt) {
    Statements undisturbed = all_ready();
    undisturbed[45U].state = WarningState::unavailable;
    Statements statements = with_warning(undisturbed, 50U, 51U);
    EXPECT_EQ(effect(statements, undisturbed), FlipEffect::false_warning);
}

TEST(AFlip, AtTheBeginningOfTheDriveIsJudgedByWhatFollows) {
    EXPECT_EQ(effect(warned(3U, 20U), warned(0U, 20U)), FlipEffect::in_time);
    EXPECT_EQ(effect(warned(6U, 20U), warned(0U, 20U)), FlipEffect::late);
}

TEST(AFlip, ThatDelaysTheWarningByMoreIsLate) {
    EXPECT_EQ(effect(warned(46U, 60U), warned(40U, 60U)), FlipEffect::late);
}

TEST(AFlip, ThatTakesTheWarningAwayOrEndsItTooEarlyIsMissing) {
    EXPECT_EQ(effect(all_ready(), warned(40U, 60U)), FlipEffect::missing);
    EXPECT_EQ(effect(warned(40U, 54U), warned(40U, 60U)), FlipEffect::missing);
    EXPECT_EQ(effect(all_ready(), warned(90U, length)), FlipEffect::missing);
}

TEST(AFlip, ThatWarnsOfNothingTooEarlyOrTooLongIsFalse) {
    EXPECT_EQ(effect(warned(50U, 51U), all_ready()), FlipEffect::false_warning);
    EXPECT_EQ(effect(warned(0U, 1U), all_ready()), FlipEffect::false_warning);
    EXPECT_EQ(effect(warned(34U, 60U), warned(40U, 60U)), FlipEffect::false_warning);
    EXPECT_EQ(effect(warned(40U, 66U), warned(40U, 60U)), FlipEffect::false_warning);
}

TEST(AFlip, ThatWarnsOfTheOtherSideIsFalse) {
    EXPECT_EQ(effect(with_warning(all_ready(), 40U, 60U, WarningSide::left), warned(40U, 60U)),
              FlipEffect::false_warning);
}

TEST(AFlip, IsToldByWhateverSaysThatSomethingIsWrong) {
    const auto reported_by = [](auto change) {
        Statements statements = warned(50U, 51U);
        change(statements[50U]);
        return effect(statements, all_ready());
    };
    EXPECT_EQ(reported_by([](Statement& one) { one.codes = 4U; }), FlipEffect::told);
    EXPECT_EQ(reported_by([](Statement& one) { one.sound = false; }), FlipEffect::told);
    EXPECT_EQ(reported_by([](Statement& one) { one.degradation = sil::Degradation::internal_fault; }),
              FlipEffect::told);
    Statements unavailable = all_ready();
    for (std::size_t cycle = 38U; cycle < 60U; ++cycle) {
        unavailable[cycle].state = WarningState::unavailable;
    }
    EXPECT_EQ(effect(unavailable, warned(40U, 60U)), FlipEffect::told);
}

TEST(AFlip, IsNotToldByWhatIsSaidWithoutIt) {
    Statements undisturbed = all_ready();
    Statements statements = warned(50U, 51U);
    undisturbed[50U].codes = 4U;
    statements[50U].codes = 4U;
    EXPECT_EQ(effect(statements, undisturbed), FlipEffect::false_warning);
}

TEST(AFlip, IsToldWithinAHundredMillisecondsBeforeOrAfter) {
    for (const std::size_t cycle : {40U, 60U}) {
        Statements statements = warned(50U, 51U);
        statements[cycle].codes = 4U;
        EXPECT_EQ(effect(statements, all_ready()), FlipEffect::told);
    }
    for (const std::size_t cycle : {39U, 61U}) {
        Statements statements = warned(50U, 51U);
        statements[cycle].codes = 4U;
        EXPECT_EQ(effect(statements, all_ready()), FlipEffect::false_warning);
    }
}

TEST(AFlip, IsJudgedFromItsCycleOn) {
    EXPECT_EQ(sil::effect_of(warned(20U, 21U), all_ready(), 21U), FlipEffect::none);
    EXPECT_EQ(sil::effect_of(warned(20U, 21U), all_ready(), 20U), FlipEffect::false_warning);
}

TEST(AFlip, IsSilentWhereNothingTellsOfIt) {
    EXPECT_FALSE(sil::is_silent(FlipEffect::none));
    EXPECT_FALSE(sil::is_silent(FlipEffect::in_time));
    EXPECT_FALSE(sil::is_silent(FlipEffect::told));
    EXPECT_TRUE(sil::is_silent(FlipEffect::late));
    EXPECT_TRUE(sil::is_silent(FlipEffect::missing));
    EXPECT_TRUE(sil::is_silent(FlipEffect::false_warning));
    EXPECT_STREQ(sil::to_string(FlipEffect::false_warning), "false");
    EXPECT_STREQ(sil::to_string(FlipEffect::in_time), "in time");
}

}  // namespace
