// Findings, by answers that are written by hand; and the list of those that are known.
#include "sil/studies/faults/finding.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "sil/studies/faults/known_findings.hpp"
#include "tests/sil/faults/written_answer.hpp"

namespace faults_test {
namespace {

using sil::EcuAnswer;
using sil::Fault;
using sil::FaultKind;
using sil::FaultPlace;
using sil::FindingKind;
using sil::WarningSide;
using sil::WarningState;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::size_t drive_cycles = 2000U;
constexpr std::size_t lift = 1500U;
constexpr std::size_t fault_begins = 100U;

EcuAnswer saying(WarningState state, WarningSide side = WarningSide::none, sil::DiagnosticCodes codes = 0U) {
    return written_answer(state, side, codes);
}

const EcuAnswer ready = saying(WarningState::ready);
const EcuAnswer right_warning = saying(WarningState::warning, WarningSide::right);
const EcuAnswer left_warning = saying(WarningState::warning, WarningSide::left);

// A drive that ends with two-wheel lift-off and in which a warning is due 0.5 s before it, but for what a
// test changes; the ECU with the fault says what the other one says.
class Drive {
 public:
    Drive() {
        drive_.samples.resize(drive_cycles);
        drive_.load_transfer.assign(drive_cycles, 0.0);
        drive_.fault_begin = fault_begins;
        drive_.fault_end = drive_cycles;
        drive_.two_wheel_lift = lift;
        right_.answers.assign(drive_cycles, ready);
        due(lift - 50U);
        faulty_.visible = fault_begins;
        faulty_.over = drive_cycles;
    }

    Drive& due(std::size_t from) {
        for (std::size_t cycle = 0U; cycle < drive_cycles; ++cycle) {
            right_.answers[cycle] = cycle >= from ? right_warning : ready;
        }
        faulty_.answers = right_.answers;
        return *this;
    }
    Drive& say(std::size_t from, std::size_t until, const std::optional<EcuAnswer>& one) {
        for (std::size_t cycle = from; cycle < until; ++cycle) {
            faulty_.answers[cycle] = one;
        }
        return *this;
    }
    Drive& carries_more(std::size_t cycle, double load_transfer) {
        drive_.load_transfer[cycle] = load_transfer;
        return *this;
    }
    // Answers of both ECUs.
    Drive& always_codes(sil::DiagnosticCodes codes) {
        for (std::size_t cycle = 0U; cycle < drive_cycles; ++cycle) {
            right_.answers[cycle]->codes = codes;
        }
        faulty_.answers = right_.answers;
        return *this;
    }
    Drive& fault_ends(std::size_t cycle) {
        drive_.fault_end = cycle;
        return *this;
    }
    Drive& without_lift() {
        drive_.two_wheel_lift.reset();
        return *this;
    }

    std::vector<FindingKind> silent() const { return silent_findings(drive_, right_, faulty_); }
    std::vector<FindingKind> findings(const Fault& fault, std::size_t ordinary_end = 0U) const {
        return findings_of(drive_, fault, right_, faulty_, ordinary_end);
    }
    std::vector<FindingKind> of_good_sensors() const {
        return findings_of_good_sensors(drive_, right_, faulty_);
    }

 private:
    sil::FaultedDrive drive_{};
    sil::FaultyRun right_{};
    sil::FaultyRun faulty_{};
};

TEST(Finding, IsNothingWhereTheAnswersAreRight) {
    EXPECT_THAT(Drive{}.silent(), IsEmpty());
}

TEST(Finding, IsAWarningThatIsNotThereATenthOfASecondBeforeLiftOff) {
    const auto from = [](std::size_t cycle) { return Drive{}.say(lift - 60U, cycle, ready).silent(); };
    EXPECT_THAT(from(lift - 10U), IsEmpty());
    EXPECT_THAT(from(lift - 9U), ElementsAre(FindingKind::missed_warning));
    EXPECT_THAT(Drive{}.say(lift - 60U, drive_cycles, saying(WarningState::advisory)).silent(),
                ElementsAre(FindingKind::missed_warning));
    EXPECT_THAT(Drive{}.say(lift - 50U, drive_cycles, left_warning).silent(),
                ElementsAre(FindingKind::missed_warning))
        << "of the wrong side";
    EXPECT_THAT(Drive{}.without_lift().say(lift - 60U, lift + 10U, ready).silent(), IsEmpty())
        << "no two wheels lift";
}

TEST(Finding, GivesAWarningThatIsDueLateATenthOfASecondMore) {
    const auto due_late = [](std::size_t from) {
        return Drive{}.due(lift - 15U).say(lift - 60U, from, ready).silent();
    };
    EXPECT_THAT(due_late(lift - 5U), IsEmpty());
    EXPECT_THAT(due_late(lift - 4U), ElementsAre(FindingKind::missed_warning));
    const auto due_at_lift = [](std::size_t from) {
        return Drive{}.due(lift - 2U).say(lift - 60U, from, ready).silent();
    };
    EXPECT_THAT(due_at_lift(lift), IsEmpty());
    EXPECT_THAT(due_at_lift(lift + 1U), ElementsAre(FindingKind::missed_warning));
}

TEST(Finding, IsNoMissedWarningThatIsToldOf) {
    for (const EcuAnswer& told :
         {saying(WarningState::ready, WarningSide::none, 4U), saying(WarningState::unavailable)}) {
        EXPECT_THAT(Drive{}.say(lift - 60U, drive_cycles, told).silent(), IsEmpty());
    }
    EXPECT_THAT(Drive{}
                    .say(lift - 60U, lift - 10U, saying(WarningState::ready, WarningSide::none, 4U))
                    .say(lift - 10U, drive_cycles, ready)
                    .silent(),
                ElementsAre(FindingKind::missed_warning))
        << "the code was gone by then";
}

TEST(Finding, IsNoMissedWarningOfAnEcuThatIsNotHeard) {
    EXPECT_THAT(Drive{}.say(lift - 60U, drive_cycles, std::nullopt).silent(), IsEmpty());
}

TEST(Finding, IsNotToldByACodeThatIsThereWithoutTheFault) {
    const EcuAnswer coded = saying(WarningState::ready, WarningSide::none, 4U);
    EXPECT_THAT(Drive{}.always_codes(4U).say(lift - 60U, drive_cycles, coded).silent(),
                ElementsAre(FindingKind::missed_warning));
    EXPECT_THAT(Drive{}.always_codes(2U).say(lift - 60U, drive_cycles, coded).silent(), IsEmpty());
    EXPECT_THAT(Drive{}.always_codes(4U).of_good_sensors(), IsEmpty());
}

TEST(Finding, IsAFalseWarningOfMoreThanHalfASecond) {
    const auto false_for = [](std::size_t lasting, const EcuAnswer& one) {
        return Drive{}.say(200U, 200U + lasting, one).silent();
    };
    EXPECT_THAT(false_for(50U, right_warning), IsEmpty());
    EXPECT_THAT(false_for(51U, right_warning), ElementsAre(FindingKind::false_warning));
    EXPECT_THAT(false_for(51U, left_warning), ElementsAre(FindingKind::false_warning));
    EXPECT_THAT(false_for(51U, saying(WarningState::warning, WarningSide::left, 4U)), IsEmpty()) << "a code";
    EXPECT_THAT(false_for(51U, saying(WarningState::advisory)), IsEmpty());
}

TEST(Finding, IsNoFalseWarningWithinTwoSecondsOfADueOneForTheSameSide) {
    const std::size_t due = lift - 50U;
    EXPECT_THAT(Drive{}.say(due - 250U, due, right_warning).silent(), IsEmpty());
    EXPECT_THAT(Drive{}.say(due - 251U, due, right_warning).silent(),
                ElementsAre(FindingKind::false_warning));
    EXPECT_THAT(Drive{}.say(due - 51U, due, left_warning).silent(), ElementsAre(FindingKind::false_warning));
    EXPECT_THAT(Drive{}.due(drive_cycles).say(lift, drive_cycles, left_warning).silent(), IsEmpty())
        << "after lift-off";
    EXPECT_THAT(Drive{}.without_lift().due(drive_cycles).say(lift, drive_cycles, left_warning).silent(),
                ElementsAre(FindingKind::false_warning));
}

TEST(Finding, IsNoFalseWarningWhereTheWheelsOfThatSideCarryMuchMore) {
    const auto warned = [](double load_transfer, const EcuAnswer& one) {
        return Drive{}.carries_more(300U, load_transfer).say(400U, 500U, one).silent();
    };
    const auto is_false = ElementsAre(FindingKind::false_warning);
    EXPECT_THAT(warned(0.7, right_warning), IsEmpty());
    EXPECT_THAT(warned(0.69, right_warning), is_false);
    EXPECT_THAT(warned(-0.9, right_warning), is_false);
    EXPECT_THAT(warned(-0.7, left_warning), IsEmpty());
    EXPECT_THAT(Drive{}.carries_more(300U, 1.0).say(501U, 600U, right_warning).silent(), is_false) << "over";
}

TEST(Finding, IsADeadOrWeakAccelerometerWithoutACodeInOrdinaryDriving) {
    constexpr FaultPlace lateral = FaultPlace::lateral_acceleration;
    constexpr std::size_t end = 1000U;
    for (const Fault& weak :
         {Fault{FaultKind::noise_alone, lateral, 0.2}, Fault{FaultKind::gain, lateral, 0.5}}) {
        EXPECT_THAT(Drive{}.findings(weak, end), ElementsAre(FindingKind::not_found));
        EXPECT_THAT(Drive{}.findings(weak), IsEmpty()) << "no ordinary driving";
        const EcuAnswer code = saying(WarningState::ready, WarningSide::none, 4U);
        EXPECT_THAT(Drive{}.say(end - 1U, end, code).findings(weak, end), IsEmpty());
        EXPECT_THAT(Drive{}.say(end, end + 1U, code).findings(weak, end),
                    ElementsAre(FindingKind::not_found));
    }
    EXPECT_THAT(Drive{}.findings({FaultKind::gain, lateral, 0.51}, end), IsEmpty());
    EXPECT_THAT(Drive{}.findings({FaultKind::gain, FaultPlace::yaw_rate, 0.5}, end), IsEmpty());
}

TEST(Finding, IsASecondSenderThatNeitherStateNorDegradationShows) {
    const auto with = [](FaultPlace place, const EcuAnswer& one, std::size_t since = fault_begins + 20U) {
        return Drive{}.say(since, drive_cycles, one).findings({FaultKind::sender_before, place, 1.0});
    };
    const auto degraded = [](sil::Degradation degradation) {
        EcuAnswer one = right_warning;  // also where it is due
        one.degradation = degradation;
        one.codes = 4U;
        return one;
    };
    const auto accepted = ElementsAre(FindingKind::second_sender_accepted);
    EXPECT_THAT(with(FaultPlace::imu_frame, saying(WarningState::unavailable)), IsEmpty());
    EXPECT_THAT(with(FaultPlace::imu_frame, saying(WarningState::unavailable), fault_begins + 21U), accepted);
    EXPECT_THAT(with(FaultPlace::imu_frame, degraded(sil::Degradation::full)), accepted)
        << "a code is not enough";
    EXPECT_THAT(with(FaultPlace::roll_angle_frame, degraded(sil::Degradation::roll_sensor_lost)), IsEmpty());
    EXPECT_THAT(with(FaultPlace::roll_angle_frame, degraded(sil::Degradation::motion_lost)), accepted);
    EXPECT_THAT(with(FaultPlace::vehicle_motion_frame, degraded(sil::Degradation::motion_lost)), IsEmpty());
    EXPECT_THAT(with(FaultPlace::vehicle_motion_frame, degraded(sil::Degradation::full)), accepted);
    EXPECT_THAT(with(FaultPlace::warning_frame, degraded(sil::Degradation::full)), IsEmpty())
        << "a code is enough";
    EXPECT_THAT(with(FaultPlace::warning_frame, right_warning),
                ElementsAre(FindingKind::false_warning, FindingKind::second_sender_accepted));
}

TEST(Finding, IsADeadAccelerometerOnlyAndOnlyFromTheFaultOn) {
    constexpr std::size_t end = 1000U;
    const Fault dead{FaultKind::noise_alone, FaultPlace::lateral_acceleration, 0.2};
    const EcuAnswer code = saying(WarningState::ready, WarningSide::none, 4U);
    EXPECT_THAT(Drive{}.say(fault_begins - 1U, fault_begins, code).findings(dead, end),
                ElementsAre(FindingKind::not_found));
    EXPECT_THAT(Drive{}.say(fault_begins, fault_begins + 1U, code).findings(dead, end), IsEmpty());
    EXPECT_THAT(Drive{}.findings({FaultKind::noise_alone, FaultPlace::roll_rate, 0.2}, end), IsEmpty());
    EXPECT_THAT(Drive{}.findings({FaultKind::offset, FaultPlace::lateral_acceleration, 0.2}, end), IsEmpty());
}

TEST(Finding, IsASecondSenderOnlyWhileItSends) {
    constexpr std::size_t shows = fault_begins + 20U;
    const Fault sender{FaultKind::sender_tenfold, FaultPlace::imu_frame, 1.0};
    const EcuAnswer unavailable = saying(WarningState::unavailable);
    const auto accepted = ElementsAre(FindingKind::second_sender_accepted);
    const auto shown_until = [&](std::size_t cycle) {
        return Drive{}.fault_ends(200U).say(shows, cycle, unavailable).findings(sender);
    };
    EXPECT_THAT(shown_until(200U), IsEmpty());
    EXPECT_THAT(shown_until(199U), accepted);
    EXPECT_THAT(Drive{}.say(shows, lift, unavailable).findings(sender), IsEmpty()) << "after lift-off";
    EXPECT_THAT(Drive{}.say(shows, lift - 1U, unavailable).findings(sender), accepted);
    EXPECT_THAT(Drive{}.say(shows, drive_cycles, std::nullopt).findings(sender), IsEmpty())
        << "nothing is heard";
    EXPECT_THAT(Drive{}.findings({FaultKind::doubled, FaultPlace::imu_frame, 1.0}), IsEmpty())
        << "no other sender";
}

TEST(Finding, IsNoSecondSenderWhereTheEcuIsUnavailable) {
    for (const FaultPlace place :
         {FaultPlace::imu_frame, FaultPlace::roll_angle_frame, FaultPlace::vehicle_motion_frame}) {
        EXPECT_THAT(Drive{}
                        .say(fault_begins + 20U, drive_cycles, saying(WarningState::unavailable))
                        .findings({FaultKind::sender_after, place, 1.0}),
                    IsEmpty());
    }
}

TEST(Finding, HasANameForEachKind) {
    EXPECT_STREQ(to_string(FindingKind::missed_warning), "missed warning");
    EXPECT_STREQ(to_string(FindingKind::false_warning), "false warning");
    EXPECT_STREQ(to_string(FindingKind::not_found), "not found");
    EXPECT_STREQ(to_string(FindingKind::second_sender_accepted), "second sender accepted");
    EXPECT_STREQ(to_string(FindingKind::good_sensor_with_code), "good sensor with a code");
}

TEST(Finding, IsACodeAgainstGoodSensors) {
    EXPECT_THAT(Drive{}.of_good_sensors(), IsEmpty());
    const EcuAnswer code = saying(WarningState::ready, WarningSide::none, 4U);
    const auto with_code = ElementsAre(FindingKind::good_sensor_with_code);
    EXPECT_THAT(Drive{}.say(0U, 1U, code).of_good_sensors(), with_code);
    const EcuAnswer unavailable = saying(WarningState::unavailable);
    EXPECT_THAT(Drive{}.say(0U, 30U, unavailable).of_good_sensors(), IsEmpty()) << "at the start";
    EXPECT_THAT(Drive{}.say(30U, 31U, unavailable).of_good_sensors(), with_code);
    EXPECT_THAT(
        Drive{}.say(29U, 30U, saying(WarningState::unavailable, WarningSide::none, 4U)).of_good_sensors(),
        with_code);
    EXPECT_THAT(Drive{}.say(lift, drive_cycles, code).of_good_sensors(), IsEmpty()) << "after lift-off";
    EXPECT_THAT(Drive{}.say(lift - 60U, drive_cycles, ready).of_good_sensors(),
                ElementsAre(FindingKind::missed_warning));
}

TEST(KnownFindings, AreNamedOnceEachWithAReason) {
    std::set<std::string> cells;
    for (const sil::KnownFinding& known : sil::known_findings()) {
        EXPECT_FALSE(known.why.empty());
        EXPECT_TRUE(sil::is_known(known.found));
        for (const std::string& cell : known.cells) {
            EXPECT_TRUE(cells.insert(describe(known.found) + cell).second) << cell;
        }
    }
    EXPECT_FALSE(sil::is_known({FindingKind::not_found, FaultKind::clock_jump, FaultPlace::processor}));
}

TEST(KnownFindings, AreOfOneKindFaultAndPlace) {
    const sil::FindingClass found{FindingKind::missed_warning, FaultKind::gain, FaultPlace::yaw_rate};
    EXPECT_TRUE(
        (found == sil::FindingClass{FindingKind::missed_warning, FaultKind::gain, FaultPlace::yaw_rate}));
    EXPECT_FALSE(
        (found == sil::FindingClass{FindingKind::false_warning, FaultKind::gain, FaultPlace::yaw_rate}));
    EXPECT_FALSE(
        (found == sil::FindingClass{FindingKind::missed_warning, FaultKind::drift, FaultPlace::yaw_rate}));
    EXPECT_FALSE(
        (found == sil::FindingClass{FindingKind::missed_warning, FaultKind::gain, FaultPlace::speed}));
}

TEST(KnownFindings, DifferByWhatIsNewAndByWhatIsGone) {
    const sil::FindingClass missed{FindingKind::missed_warning, FaultKind::gain, FaultPlace::yaw_rate};
    const std::vector<sil::KnownFinding> known{{missed, {"gain, 0 | rest"}, "open"}};
    EXPECT_THAT(sil::differences({{missed, "gain, 0 | rest"}}, known), IsEmpty());
    EXPECT_THAT(sil::differences({}, known),
                ElementsAre("known, but no longer found: missed warning, gain of yaw rate: gain, 0 | rest"));
    EXPECT_THAT(
        sil::differences(
            {{missed, "gain, 0 | rest"}, {{FindingKind::good_sensor_with_code, {}, {}}, "x | rest"}}, known),
        ElementsAre("not known: good sensor with a code: x | rest"));
}

}  // namespace
}  // namespace faults_test
