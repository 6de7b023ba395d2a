// The limits of judge(): a reaction as it is demanded, with one value at its limit and beyond it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sil/studies/faults/judgement.hpp"

namespace faults_test::judgement_limits_test {
namespace {

using sil::Demand;
using sil::Expectation;
using sil::Reaction;
using testing::ElementsAre;
using testing::IsEmpty;
using Texts = std::vector<std::string>;

constexpr Demand all_demands[]{Demand::recovery,    Demand::unaffected, Demand::right,
                               Demand::reported,    Demand::usable,     Demand::roll_sensor_lost,
                               Demand::motion_lost, Demand::unavailable};

Expectation expecting(Demand demand) {
    Expectation expected;
    expected.demand = demand;
    expected.reaction_ms = 50;
    expected.recovery_ms = 150;
    expected.healing_ms = 1100;
    expected.wrong_ms = 90;
    expected.lead_loss_ms = 120;
    expected.lapse_ms = 30;
    return expected;
}

// Just as it is demanded: the last that is good of every value.
Reaction demanded(Demand demand) {
    Reaction reaction;
    reaction.visible = true;
    reaction.warning_due = true;
    reaction.lead_loss = 120;
    reaction.lead = 100;
    reaction.wrong = 90;
    reaction.lapse = 30;
    reaction.false_warning = longest_false_warning_ms(expecting(demand));
    reaction.recovery = 150;
    reaction.healing = 1100;
    reaction.watched_ms = 5000;
    if (demand != Demand::unaffected) {
        reaction.code = 50;
    }
    if (demand == Demand::unavailable) {
        reaction.unavailable = 50;
    }
    if (demand == Demand::roll_sensor_lost) {
        reaction.observer = 50;
    }
    if (demand == Demand::motion_lost) {
        reaction.motion_lost = 50;
    }
    return reaction;
}

template <typename Change>
Texts shortfalls(Demand demand, Change change) {
    Reaction reaction = demanded(demand);
    change(reaction);
    const sil::Verdict verdict = judge(expecting(demand), reaction);
    EXPECT_THAT(verdict.known_undetected, IsEmpty());
    return verdict.shortfalls;
}

TEST(JudgementLimits, TheDemandedAnswerIsGood) {
    for (const Demand demand : all_demands) {
        EXPECT_THAT(shortfalls(demand, [](Reaction&) {}), IsEmpty()) << to_string(demand);
    }
}

TEST(JudgementLimits, OfEveryDemand) {
    for (const Demand demand : all_demands) {
        SCOPED_TRACE(to_string(demand));
        const int false_ms = longest_false_warning_ms(expecting(demand)) + 1;
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.incomplete_cycles = 1U; }),
                    ElementsAre("a frame is missing or damaged"));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.undefined_cycles = 1U; }),
                    ElementsAre("an undefined code on the bus"));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.watchdog_fed = false; }),
                    ElementsAre("watchdog"));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.silence = 10; }),
                    ElementsAre("silent for 10 ms while a warning is due"));
        EXPECT_THAT(shortfalls(demand, [=](Reaction& is) { is.false_warning = false_ms; }),
                    ElementsAre("false warning for " + std::to_string(false_ms) + " ms"));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.wrong = 91; }),
                    ElementsAre("wrong for 91 ms without a code"));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.recovery = 151; }),
                    ElementsAre("back after 151 ms only"));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.healing = 1101; }),
                    ElementsAre("codes for 1101 ms more"));
    }
}

TEST(JudgementLimits, OfAReturnThatTheDrivesEndCutsOff) {
    for (const Demand demand : all_demands) {
        SCOPED_TRACE(to_string(demand));
        const auto not_back = [=](int watched_ms) {
            return shortfalls(demand, [=](Reaction& is) {
                is.recovery.reset();
                is.watched_ms = watched_ms;
            });
        };
        EXPECT_THAT(not_back(149), IsEmpty());
        EXPECT_THAT(not_back(150), ElementsAre("does not come back"));
        const auto not_healed = [=](int watched_ms) {
            return shortfalls(demand, [=](Reaction& is) {
                is.healing.reset();
                is.watched_ms = watched_ms;
            });
        };
        EXPECT_THAT(not_healed(1099), IsEmpty());
        EXPECT_THAT(not_healed(1100), ElementsAre("codes do not heal"));
    }
}

// A warning that is due soon after the fault may come as late as it may with the fault.
TEST(JudgementLimits, OfTheReturnWhereAWarningIsDueSoon) {
    const auto back_at = [](int recovery_ms, int due_ms) {
        return shortfalls(Demand::unavailable, [=](Reaction& is) {
            is.recovery = recovery_ms;
            is.due = due_ms;
        });
    };
    EXPECT_THAT(back_at(200, 80), IsEmpty());
    EXPECT_THAT(back_at(201, 80), ElementsAre("back after 201 ms only"));
    EXPECT_THAT(back_at(150, 0), IsEmpty());
    EXPECT_THAT(back_at(151, 0), ElementsAre("back after 151 ms only"));
}

TEST(JudgementLimits, OfTheCode) {
    for (const Demand demand : {Demand::reported, Demand::usable, Demand::roll_sensor_lost,
                                Demand::motion_lost, Demand::unavailable}) {
        SCOPED_TRACE(to_string(demand));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.code = 51; }), ElementsAre("no code in time"));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.code.reset(); }),
                    ElementsAre("no code in time"));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.lapse = 40; }),
                    ElementsAre("no code for 40 ms while the fault is there"));
    }
    for (const Demand demand : {Demand::recovery, Demand::right}) {
        SCOPED_TRACE(to_string(demand));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.code.reset(); }), IsEmpty());
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.lapse = 40; }), IsEmpty());
    }
    EXPECT_THAT(shortfalls(Demand::unaffected, [](Reaction& is) { is.code = 500; }),
                ElementsAre("a reaction"));
}

TEST(JudgementLimits, OfTheStateThatIsDemanded) {
    const auto none_or_late = [](Demand demand, std::optional<int> Reaction::* time,
                                 const std::string& text) {
        EXPECT_THAT(shortfalls(demand, [=](Reaction& is) { is.*time = 51; }), ElementsAre(text));
        EXPECT_THAT(shortfalls(demand, [=](Reaction& is) { (is.*time).reset(); }), ElementsAre(text));
    };
    none_or_late(Demand::unavailable, &Reaction::unavailable, "not unavailable in time");
    none_or_late(Demand::roll_sensor_lost, &Reaction::observer, "observer not in use in time");
    none_or_late(Demand::motion_lost, &Reaction::motion_lost, "not \"motion lost\" in time");
}

TEST(JudgementLimits, OfUnavailableWhereTheEcuHasToStayUsable) {
    for (const Demand demand :
         {Demand::right, Demand::usable, Demand::roll_sensor_lost, Demand::motion_lost}) {
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.unavailable = 500; }),
                    ElementsAre("unavailable"))
            << to_string(demand);
    }
    EXPECT_THAT(shortfalls(Demand::unaffected, [](Reaction& is) { is.unavailable = 500; }),
                ElementsAre("a reaction", "unavailable"));
    for (const Demand demand : {Demand::recovery, Demand::reported}) {
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.unavailable = 500; }), IsEmpty())
            << to_string(demand);
    }
}

TEST(JudgementLimits, WithoutAVisibleFaultNoReactionIsDemanded) {
    for (const Demand demand : all_demands) {
        EXPECT_THAT(shortfalls(demand,
                               [](Reaction& is) {
                                   is.visible = false;
                                   is.lapse = 500;
                                   is.code.reset();
                                   is.unavailable.reset();
                                   is.observer.reset();
                                   is.motion_lost.reset();
                               }),
                    IsEmpty())
            << to_string(demand);
    }
}

TEST(JudgementLimits, OfTheWarning) {
    for (const Demand demand :
         {Demand::unaffected, Demand::right, Demand::usable, Demand::roll_sensor_lost, Demand::motion_lost}) {
        SCOPED_TRACE(to_string(demand));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.warning_missed = true; }),
                    ElementsAre("no warning"));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.lead_loss = 121; }),
                    ElementsAre("warning late"));
        EXPECT_THAT(shortfalls(demand, [](Reaction& is) { is.lead = 99; }),
                    ElementsAre("warning too late before two-wheel lift-off"));
        EXPECT_THAT(shortfalls(demand,
                               [](Reaction& is) {
                                   is.lead_loss.reset();
                                   is.lead.reset();
                               }),
                    IsEmpty());
    }
    for (const Demand demand : {Demand::unavailable, Demand::reported, Demand::recovery}) {
        EXPECT_THAT(shortfalls(demand,
                               [](Reaction& is) {
                                   is.warning_missed = true;
                                   is.lead_loss = 121;
                                   is.lead = 99;
                               }),
                    IsEmpty())
            << to_string(demand);
    }
}

// If the ECU had the time to come back before the warning was due.
TEST(JudgementLimits, OfTheWarningAfterAFaultThatIsOver) {
    const auto late = [](int due_ms) {
        return shortfalls(Demand::recovery, [=](Reaction& is) {
            is.due = due_ms;
            is.lead_loss = 121;
        });
    };
    EXPECT_THAT(late(149), IsEmpty());
    EXPECT_THAT(late(150), ElementsAre("warning late"));
}

TEST(JudgementLimits, OfAKnownUndetectedErrorItsEffectOnTheWarningStandsApart) {
    Expectation expected = expecting(Demand::right);
    expected.known_undetected = true;
    Reaction reaction = demanded(Demand::right);
    reaction.silence = 10;
    reaction.wrong = 91;
    reaction.warning_missed = true;
    reaction.lead_loss = 121;
    reaction.lead = 99;
    const sil::Verdict effect = judge(expected, reaction);
    EXPECT_THAT(effect.shortfalls, IsEmpty());
    EXPECT_THAT(effect.known_undetected,
                ElementsAre("silent for 10 ms while a warning is due", "wrong for 91 ms without a code",
                            "no warning", "warning late", "warning too late before two-wheel lift-off"));
    reaction = demanded(Demand::right);
    reaction.watchdog_fed = false;
    reaction.false_warning = 1;
    reaction.unavailable = 10;
    reaction.recovery = 151;
    EXPECT_THAT(judge(expected, reaction).shortfalls,
                ElementsAre("watchdog", "false warning for 1 ms", "back after 151 ms only", "unavailable"));
}

}  // namespace
}  // namespace faults_test::judgement_limits_test
