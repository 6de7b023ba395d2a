// The end-to-end receiver state machine: every transition, and what it makes of a bad channel.
#include "rsi/can_dbc/e2e/state_machine.hpp"

#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <string>

namespace state_machine_test {
namespace {

using rsi::can_dbc::e2e::are_consistent;
using rsi::can_dbc::e2e::ChannelState;
using rsi::can_dbc::e2e::CheckStatus;
using rsi::can_dbc::e2e::StateMachine;
using rsi::can_dbc::e2e::StateMachineSettings;

constexpr StateMachineSettings settings{6U, {2U, 1U}, {1U, 2U}, {3U, 1U}, false};
constexpr StateMachineSettings at_once{6U, {1U, 1U}, {1U, 2U}, {3U, 1U}, true};
constexpr StateMachineSettings smallest{1U, {1U, 0U}, {1U, 0U}, {1U, 0U}, false};

// One check a letter.
CheckStatus status_of(char letter) {
    switch (letter) {
        case 'o':
            return CheckStatus::ok;
        case 'l':
            return CheckStatus::ok_some_lost;
        case 'r':
            return CheckStatus::repeated;
        case 'w':
            return CheckStatus::wrong_sequence;
        case 'e':
            return CheckStatus::error;
        default:
            return CheckStatus::no_new_data;
    }
}

// One state a letter, so that a failing test shows where two courses part.
char letter_of(ChannelState state) {
    switch (state) {
        case ChannelState::no_data:
            return '.';
        case ChannelState::init:
            return 'i';
        case ChannelState::valid:
            return 'V';
        case ChannelState::invalid:
            return 'x';
    }
    return '?';
}

template <const StateMachineSettings& of>
std::string states_after(const std::string& checks) {
    StateMachine<of> machine;
    std::string states;
    for (const char check : checks) {
        machine.update(status_of(check));
        states += letter_of(machine.state());
        EXPECT_EQ(machine.is_valid(), states.back() == 'V');
    }
    return states;
}

struct Course {
    const char* name;
    std::string checks;  // o ok, l some lost, r repeated, w wrong sequence, e error, - no new data
    std::string states;  // after each check: . no data, i init, V valid, x invalid
};
void PrintTo(const Course& course, std::ostream* out) {
    *out << course.checks;
}

class StateMachineCourse : public ::testing::TestWithParam<Course> {};

TEST_P(StateMachineCourse, IsAsAutosarSays) {
    EXPECT_EQ(states_after<settings>(GetParam().checks), GetParam().states) << GetParam().checks;
}

// Window 6; init 2 ok and at most 1 error, valid 1 and 2, invalid 3 and 1.
INSTANTIATE_TEST_SUITE_P(
    Of, StateMachineCourse,
    ::testing::Values(
        Course{"NoDataWithoutFrames", "---", "..."},
        Course{"NoDataWithDamagedFrames", "eeeeeeee", "........"}, Course{"NoDataToInitByOk", "o", "i"},
        Course{"NoDataToInitBySomeLost", "l", "i"}, Course{"NoDataToInitByRepeated", "r", "i"},
        Course{"NoDataToInitByWrongSequence", "w", "i"},
        Course{"ErrorsBeforeInitAreForgotten", "eeeeooo", "....iiV"},
        Course{"TheFirstFrameIsNotCounted", "ooo", "iiV"}, Course{"SomeLostCountsAsOk", "lll", "iiV"},
        Course{"InitStaysWithoutOk", "orw-rw--", "iiiiiiii"}, Course{"InitBearsOneError", "oeoo", "iiiV"},
        Course{"InitToInvalidByErrors", "oee", "iix"},
        Course{"InitToInvalidAlthoughOkAreEnough", "oeoeo", "iiixx"},
        Course{"OkThatLeftTheWindowDoNotCountInInit", "oo------o", "iiiiiiiii"},
        Course{"OkAtBothEndsOfTheWindowCountInInit", "oo----o", "iiiiiiV"},
        Course{"ErrorsThatLeftTheWindowAreForgottenInInit", "oe-----e", "iiiiiiii"},
        Course{"ValidBearsTwoErrors", "oooee", "iiVVV"}, Course{"ValidToInvalidByErrors", "oooeee", "iiVVVx"},
        Course{"ValidToInvalidByErrorsAmongOk", "oooeoeoe", "iiVVVVVx"},
        Course{"ValidBearsErrorsFartherApart", "oooeooeooeooe", "iiVVVVVVVVVVV"},
        Course{"ValidBearsSilenceUpToTheWindow", "ooo-----", "iiVVVVVV"},
        Course{"ValidToInvalidBySilence", "ooo------", "iiVVVVVVx"},
        Course{"ValidToInvalidByRepetition", "ooorrrrrr", "iiVVVVVVx"},
        Course{"ValidToInvalidByWrongSequence", "ooowwwwww", "iiVVVVVVx"},
        Course{"InvalidToValid", "ooo------ooo", "iiVVVVVVxxxV"},
        Course{"InvalidToValidBySomeLost", "ooo------lll", "iiVVVVVVxxxV"},
        Course{"InvalidStaysWithTooFewOk", "ooo------oo-oo--", "iiVVVVVVxxxxVVVV"},
        Course{"InvalidStaysWhileOkLeaveTheWindow", "ooo------oo----oo", "iiVVVVVVxxxxxxxxx"},
        Course{"InvalidStaysWithErrors", "oooeeeooooo", "iiVVVxxxxxV"},
        Course{"InvalidAllowsNoMoreErrorsThanStated", "oooeeeeeooooo", "iiVVVxxxxxxxV"}),
    [](const auto& tested) { return std::string{tested.param.name}; });

TEST(StateMachine, StartsWithoutData) {
    const StateMachine<settings> machine;
    EXPECT_EQ(machine.state(), ChannelState::no_data);
    EXPECT_FALSE(machine.is_valid());
    EXPECT_EQ(machine.ok_count(), 0U);
    EXPECT_EQ(machine.error_count(), 0U);
}

TEST(StateMachine, CountsTheChecksInItsWindow) {
    StateMachine<settings> machine;
    unsigned checks = 0U;
    for (const char check : std::string{"oolewrr-e"}) {
        machine.update(status_of(check));
        ++checks;
    }
    ASSERT_EQ(checks, 9U);  // the window holds "ewrr-e"
    EXPECT_EQ(machine.ok_count(), 0U);
    EXPECT_EQ(machine.error_count(), 2U);
    machine.update(CheckStatus::ok);
    EXPECT_EQ(machine.ok_count(), 1U);
    EXPECT_EQ(machine.error_count(), 1U);
}

TEST(StateMachine, TakesTheFirstFrameWhereThatIsSet) {
    EXPECT_EQ(states_after<at_once>("o"), "V");
    EXPECT_EQ(states_after<at_once>("ee-o"), "...V");
    EXPECT_EQ(states_after<at_once>("ro"), "iV");
    EXPECT_EQ(states_after<at_once>("re-e"), "iiix");
}

TEST(StateMachine, OfTheSmallestWindowFollowsEachCheck) {
    EXPECT_EQ(states_after<smallest>("ooeo-oror"), "iVxVxVxVx");
}

TEST(StateMachine, NeverBecomesValidWithoutAnUndamagedFrame) {
    // Every course of four checks without ok.
    const std::string letters = "rwe-";
    for (unsigned course = 0U; course < 256U; ++course) {
        std::string checks;
        for (unsigned place = 0U; place < 4U; ++place) {
            checks += letters[(course >> (2U * place)) & 3U];
        }
        EXPECT_EQ(states_after<at_once>(checks).find('V'), std::string::npos) << checks;
    }
}

constexpr ChannelState evaluated_when_compiled() {
    StateMachine<settings> machine;
    machine.update(CheckStatus::ok);
    machine.update(CheckStatus::ok);
    machine.update(CheckStatus::ok);
    return machine.state();
}
static_assert(evaluated_when_compiled() == ChannelState::valid);

TEST(StateMachineSettings, ThatContradictThemselvesAreRefused) {
    EXPECT_TRUE(are_consistent(settings));
    EXPECT_TRUE(are_consistent(at_once));
    EXPECT_TRUE(are_consistent(smallest));
    const std::array<StateMachineSettings, 9> contradictions{{
        {0U, {1U, 0U}, {1U, 0U}, {1U, 0U}, false},  // no window
        {6U, {1U, 1U}, {0U, 2U}, {1U, 1U}, false},  // valid without any frame
        {6U, {6U, 1U}, {1U, 2U}, {6U, 0U}, false},  // more than the window holds, in init
        {6U, {2U, 1U}, {2U, 5U}, {2U, 1U}, false},  // in valid
        {6U, {2U, 1U}, {1U, 2U}, {7U, 0U}, false},  // in invalid
        {6U, {1U, 1U}, {2U, 2U}, {2U, 1U}, false},  // coming from init is easier than staying
        {6U, {3U, 1U}, {1U, 2U}, {2U, 1U}, false},  // coming back is easier than coming
        {6U, {2U, 2U}, {1U, 1U}, {2U, 1U}, false},  // init bears more errors than valid
        {6U, {2U, 1U}, {1U, 2U}, {2U, 2U}, false},  // invalid bears more errors than init
    }};
    for (std::size_t index = 0U; index < contradictions.size(); ++index) {
        EXPECT_FALSE(are_consistent(contradictions[index])) << "contradiction " << index;
    }
}

}  // namespace
}  // namespace state_machine_test
