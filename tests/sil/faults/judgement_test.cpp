// Shortfalls: answers written by hand, so that each rule is seen to fail.
#include "sil/studies/faults/judgement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "sil/studies/faults/contradiction.hpp"
#include "sil/studies/faults/expectation.hpp"
#include "sil/studies/faults/known_undetected.hpp"
#include "tests/sil/faults/written_answer.hpp"

namespace faults_test {
namespace {

using sil::EcuAnswer;
using sil::Fault;
using sil::FaultKind;
using sil::FaultPlace;
using sil::WarningState;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t begin = 100U;
constexpr std::size_t end = 300U;
constexpr std::size_t length = 900U;

constexpr Fault imu_lost{FaultKind::lost, FaultPlace::imu_frame, 0.0};
constexpr Fault lying{FaultKind::noise, FaultPlace::lateral_acceleration, 2.0};
constexpr Fault hardly_lying{FaultKind::offset, FaultPlace::lateral_acceleration, 2.0};
constexpr Fault known_undetected{FaultKind::offset, FaultPlace::lateral_acceleration, -2.0};

EcuAnswer answer(WarningState state, sil::DiagnosticCodes codes = 0U) {
    return written_answer(state, sil::WarningSide::none, codes);
}

// A drive in which the ECU says the same all the time, but for what a test changes.
class Judged {
 public:
    explicit Judged(WarningState right = WarningState::ready) {
        scene_.samples.resize(length);
        scene_.fault_begin = begin;
        scene_.fault_end = end;
        right_.answers.assign(length, answer(right));
        faulty_.answers = right_.answers;
        faulty_.visible = begin;
        faulty_.over = end;
    }

    Judged& say(std::size_t from, std::size_t until, const EcuAnswer& one) {
        for (std::size_t cycle = from; cycle < until; ++cycle) {
            faulty_.answers[cycle] = one;
        }
        return *this;
    }
    Judged& due(std::size_t from, std::size_t until) {
        for (std::size_t cycle = from; cycle < until; ++cycle) {
            right_.answers[cycle] = answer(WarningState::warning);
        }
        return *this;
    }
    Judged& invisible() {
        faulty_.visible.reset();
        return *this;
    }
    Judged& lifts(std::size_t cycle) {
        scene_.two_wheel_lift = cycle;
        return *this;
    }
    Judged& unfed() {
        faulty_.watchdog_fed = false;
        return *this;
    }

    sil::Verdict verdict(const Fault& fault, sil::SceneKind scene) const {
        return judge(sil::expectation_of(fault, scene), measure(scene_, fault, right_, faulty_));
    }
    std::vector<std::string> shortfalls(const Fault& fault,
                                        sil::SceneKind scene = sil::SceneKind::turn) const {
        return verdict(fault, scene).shortfalls;
    }

 private:
    sil::Scene scene_{};
    sil::FaultyRun right_{};
    sil::FaultyRun faulty_{};
};

Judged good_answer_to_a_lost_frame() {
    return Judged{}.say(begin + 3U, end + 10U, answer(WarningState::unavailable, 1U));
}

TEST(Judgement, AcceptsWhatIsExpected) {
    EXPECT_THAT(good_answer_to_a_lost_frame().shortfalls(imu_lost), IsEmpty());
}

TEST(Judgement, WantsTheReactionInTime) {
    Judged late = Judged{}.say(begin + 6U, end + 10U, answer(WarningState::unavailable, 1U));
    EXPECT_THAT(late.shortfalls(imu_lost), Contains("not unavailable in time"));
    EXPECT_THAT(late.shortfalls(imu_lost), Contains("no code in time"));
}

TEST(Judgement, WantsACodeWithTheReaction) {
    Judged silent = Judged{}.say(begin + 3U, end + 10U, answer(WarningState::unavailable));
    EXPECT_THAT(silent.shortfalls(imu_lost), Contains("no code in time"));
}

TEST(Judgement, WantsNothingOfAFaultThatCannotBeSeen) {
    EXPECT_THAT(Judged{}.invisible().shortfalls(imu_lost), IsEmpty());
}

TEST(Judgement, WantsNoDueWarningSilencedNotForACycle) {
    const auto silent_with = [](sil::DiagnosticCodes codes) {
        return Judged{}
            .due(200U, 250U)
            .say(200U, 201U, answer(WarningState::ready, codes))
            .say(201U, 250U, answer(WarningState::warning, codes))
            .invisible();
    };
    for (const Fault& fault : {lying, imu_lost, hardly_lying}) {
        EXPECT_THAT(silent_with(0U).shortfalls(fault), Contains(HasSubstr("silent for 10 ms")));
        EXPECT_THAT(silent_with(4U).shortfalls(fault), testing::Not(Contains(HasSubstr("silent"))));
    }
}

TEST(Judgement, WantsTheReactionOfAContradictionWithinItsOwnLimit) {
    const auto found_after = [](std::size_t cycles) {
        return Judged{}.say(begin + cycles, end + 10U, answer(WarningState::unavailable, 4U));
    };
    const Fault flipped{FaultKind::sign_flip, FaultPlace::lateral_acceleration, 0.0};
    EXPECT_THAT(found_after(20U).shortfalls(flipped), IsEmpty());
    EXPECT_THAT(found_after(21U).shortfalls(flipped), Contains("no code in time"));
    EXPECT_THAT(found_after(40U).shortfalls(flipped, sil::SceneKind::before_turn), IsEmpty());
    EXPECT_THAT(found_after(41U).shortfalls(flipped, sil::SceneKind::before_turn),
                Contains("not unavailable in time"));
    EXPECT_THAT(Judged{}.shortfalls(flipped), Contains("no code in time"));
    EXPECT_THAT(Judged{}.shortfalls(flipped, sil::SceneKind::straight), IsEmpty());
}

TEST(Judgement, WantsARightStatementOfWhatNeedNotShow) {
    const Fault bank{FaultKind::offset, FaultPlace::bank_angle, 0.1};
    EXPECT_THAT(Judged{}.say(150U, 160U, answer(WarningState::advisory)).shortfalls(bank), IsEmpty());
    EXPECT_THAT(Judged{}.say(150U, 161U, answer(WarningState::advisory)).shortfalls(bank),
                Contains("wrong for 110 ms without a code"));
    EXPECT_THAT(Judged{}.say(150U, 250U, answer(WarningState::advisory, 1U)).shortfalls(bank), IsEmpty());
    EXPECT_THAT(Judged{}.say(150U, 151U, answer(WarningState::warning, 1U)).shortfalls(bank),
                Contains("false warning for 10 ms"));
    EXPECT_THAT(Judged{}.say(150U, 151U, answer(WarningState::unavailable, 1U)).shortfalls(bank),
                Contains("unavailable"));
}

TEST(Judgement, WantsNoWrongStateWithoutACodeForLongerThanItsFiltersTake) {
    const auto wrong_for = [](std::size_t cycles) {
        return good_answer_to_a_lost_frame().say(500U, 500U + cycles, answer(WarningState::advisory));
    };
    EXPECT_THAT(wrong_for(11U).shortfalls(imu_lost), testing::Not(Contains(HasSubstr("without a code"))));
    EXPECT_THAT(wrong_for(12U).shortfalls(imu_lost), Contains("wrong for 120 ms without a code"));
}

TEST(Judgement, WantsTheDueWarningOfWhatNeedNotShow) {
    const auto late_by = [](std::size_t cycles, sil::DiagnosticCodes codes) {
        return Judged{}
            .due(200U, 250U)
            .say(200U, 200U + cycles, answer(WarningState::advisory, codes))
            .say(200U + cycles, 250U, answer(WarningState::warning, codes));
    };
    const Fault drifting{FaultKind::drift, FaultPlace::lateral_acceleration, 2.0};
    EXPECT_THAT(late_by(10U, 0U).shortfalls(drifting), IsEmpty());
    EXPECT_THAT(late_by(11U, 0U).shortfalls(drifting), Contains("warning late"));
    EXPECT_THAT(late_by(11U, 4U).shortfalls(drifting), Contains("warning late"));
    // 150 ms is stated of it.
    EXPECT_THAT(late_by(15U, 0U).shortfalls(hardly_lying), IsEmpty());
    EXPECT_THAT(late_by(16U, 0U).shortfalls(hardly_lying), Contains("warning late"));
    EXPECT_THAT(
        Judged{}.due(200U, 250U).say(200U, 250U, answer(WarningState::advisory)).shortfalls(hardly_lying),
        Contains("no warning"));
}

TEST(Judgement, WantsACodeUntilTheFaultEnds) {
    EXPECT_THAT(
        good_answer_to_a_lost_frame().say(200U, 201U, answer(WarningState::unavailable)).shortfalls(imu_lost),
        Contains("no code for 10 ms while the fault is there"));
}

TEST(Judgement, WantsNoReactionToWhatIsNoFault) {
    const Fault delayed{FaultKind::delayed, FaultPlace::imu_frame, 20.0};
    EXPECT_THAT(Judged{}.shortfalls(delayed), IsEmpty());
    EXPECT_THAT(Judged{}.say(150U, 151U, answer(WarningState::ready, 1U)).shortfalls(delayed),
                Contains("a reaction"));
}

TEST(Judgement, WantsNoFalseWarningBeyondItsHoldTime) {
    const Fault delayed{FaultKind::delayed, FaultPlace::imu_frame, 20.0};
    EXPECT_THAT(Judged{}.say(end, end + 1U, answer(WarningState::warning)).shortfalls(delayed),
                Contains("false warning for 10 ms"));
    EXPECT_THAT(Judged{}.say(end, end + 206U, answer(WarningState::warning)).shortfalls(imu_lost),
                Contains("false warning for 2060 ms"));
}

TEST(Judgement, WantsTheEcuBack) {
    Judged slow = Judged{}.say(begin + 3U, end + 16U, answer(WarningState::unavailable, 1U));
    EXPECT_THAT(slow.shortfalls(imu_lost), Contains("back after 160 ms only"));
    Judged never = Judged{}.say(begin + 3U, length, answer(WarningState::unavailable, 1U));
    EXPECT_THAT(never.shortfalls(imu_lost), Contains("does not come back"));
    Judged marked = Judged{}
                        .say(begin + 3U, end + 10U, answer(WarningState::unavailable, 1U))
                        .say(end + 10U, length, answer(WarningState::ready, 1U));
    EXPECT_THAT(marked.shortfalls(imu_lost), Contains("codes do not heal"));
}

TEST(Judgement, WantsEveryFrameSoundAndTheWatchdogFed) {
    EcuAnswer incomplete = answer(WarningState::ready);
    incomplete.complete = false;
    EXPECT_THAT(good_answer_to_a_lost_frame().say(500U, 501U, incomplete).shortfalls(imu_lost),
                Contains("a frame is missing or damaged"));
    EcuAnswer undefined = answer(WarningState::ready);
    undefined.defined = false;
    EXPECT_THAT(good_answer_to_a_lost_frame().say(500U, 501U, undefined).shortfalls(imu_lost),
                Contains("an undefined code on the bus"));
    EXPECT_THAT(good_answer_to_a_lost_frame().unfed().shortfalls(imu_lost), Contains("watchdog"));
}

TEST(Judgement, WantsAUsableStateWhereOneIsPossible) {
    const Fault roll_lost{FaultKind::lost, FaultPlace::roll_angle_frame, 0.0};
    EXPECT_THAT(good_answer_to_a_lost_frame().shortfalls(roll_lost), Contains("unavailable"));
    EcuAnswer observed = answer(WarningState::ready, 1U);
    observed.roll_source = sil::RollSource::observer;
    EXPECT_THAT(Judged{}.say(begin + 3U, end, observed).shortfalls(roll_lost), IsEmpty());
    Judged late = Judged{}
                      .due(200U, 250U)
                      .say(begin + 3U, end, observed)
                      .say(212U, 250U, answer(WarningState::warning, 1U));
    EXPECT_THAT(late.shortfalls(roll_lost), Contains("warning late"));
}

// The reaction of that fault may take 600 ms, but the vehicle does not wait for it.
TEST(Judgement, WantsTheWarningBeforeTwoWheelsLift) {
    const Fault offset{FaultKind::offset, FaultPlace::vertical_acceleration, -2.0};
    const auto late_by = [](std::size_t cycles) {
        return Judged{}
            .due(200U, 250U)
            .say(150U, end, answer(WarningState::advisory, 4U))
            .say(200U + cycles, end, answer(WarningState::warning, 4U))
            .lifts(245U);
    };
    EXPECT_THAT(late_by(35U).shortfalls(offset), IsEmpty());
    EXPECT_THAT(late_by(36U).shortfalls(offset), Contains("warning too late before two-wheel lift-off"));
}

TEST(Judgement, TellsWhatNoCheckSeesApart) {
    const auto silent = [] {
        return Judged{}
            .due(200U, 250U)
            .say(200U, 230U, answer(WarningState::ready))
            .say(230U, 250U, answer(WarningState::warning));
    };
    const sil::Verdict told = silent().verdict(known_undetected, sil::SceneKind::warning);
    EXPECT_THAT(told.shortfalls, IsEmpty());
    EXPECT_THAT(told.known_undetected, Contains("silent for 300 ms while a warning is due"));
    EXPECT_THAT(told.known_undetected, Contains("warning late"));
    EXPECT_THAT(silent().shortfalls(hardly_lying, sil::SceneKind::warning),
                Contains("silent for 300 ms while a warning is due"))
        << "of the other sign";
    EXPECT_THAT(silent().shortfalls(known_undetected, sil::SceneKind::turn), Contains(HasSubstr("silent")))
        << "where no warning is due without it";
    EXPECT_THAT(silent().unfed().shortfalls(known_undetected, sil::SceneKind::warning), Contains("watchdog"));
}

// The warning is due 200 ms after the end of the fault.
TEST(Judgement, WantsTheWarningAfterAFaultThatIsOver) {
    const auto back_after = [](std::size_t cycles) {
        return good_answer_to_a_lost_frame()
            .due(end + 20U, end + 60U)
            .say(end + 10U, end + 20U + cycles, answer(WarningState::ready))
            .say(end + 20U + cycles, end + 60U, answer(WarningState::warning))
            .lifts(end + 65U);
    };
    EXPECT_THAT(back_after(0U).shortfalls(imu_lost, sil::SceneKind::over), IsEmpty());
    EXPECT_THAT(back_after(1U).shortfalls(imu_lost, sil::SceneKind::over),
                Contains(HasSubstr("silent for 10 ms")));
    const auto advises_until = [](std::size_t cycles) {
        return good_answer_to_a_lost_frame()
            .due(end + 20U, end + 60U)
            .say(end + 20U, end + 20U + cycles, answer(WarningState::advisory))
            .say(end + 20U + cycles, end + 60U, answer(WarningState::warning))
            .lifts(end + 65U);
    };
    EXPECT_THAT(advises_until(10U).shortfalls(imu_lost, sil::SceneKind::over), IsEmpty());
    EXPECT_THAT(advises_until(11U).shortfalls(imu_lost, sil::SceneKind::over), Contains("warning late"));
}

// Each contradiction of the matrix, and no other, has its limits.
TEST(Contradiction, IsStatedForEveryFaultOfThatKind) {
    std::set<const sil::Contradiction*> stated;
    for (const Fault& each : sil::all_faults()) {
        for (const Fault& fault : in_each_sign(each)) {
            if (fault.kind >= FaultKind::frozen && fault.kind <= FaultKind::sign_flip) {
                EXPECT_NO_THROW(stated.insert(&sil::contradiction_of(fault)))
                    << describe(fault) << to_string(fault.place);
            }
        }
    }
    EXPECT_EQ(stated.size(), sil::contradictions().size());
    EXPECT_THROW(sil::contradiction_of(imu_lost), std::logic_error);
}

}  // namespace
}  // namespace faults_test
