// Self-checks of the control unit - clock, parameters, estimate, outputs - each at its limits, and the
// degradation that follows.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "rsi/ecu/monitoring/clock_check.hpp"
#include "rsi/ecu/monitoring/degradation.hpp"
#include "rsi/ecu/monitoring/output_check.hpp"
#include "rsi/ecu/monitoring/parameter_guard.hpp"
#include "tests/support/large_suv.h"

namespace monitoring_self_check_test {
namespace {

using rsi::monitoring::ClockCheck;
using rsi::monitoring::Degradation;
using rsi::monitoring::ParameterGuard;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

constexpr std::int64_t cycle_ns = 10'000'000;
constexpr std::int64_t too_far_ns = 250'000'000;

TEST(AClock, HasJumpedWhenItGoesBackAtAll) {
    ClockCheck check;
    EXPECT_FALSE(check.has_jumped(500, 0U));
    EXPECT_FALSE(check.has_jumped(500, 0U));
    EXPECT_TRUE(check.has_jumped(499, 0U));
    EXPECT_FALSE(check.has_jumped(499 + cycle_ns, 0U));  // goes on from there
}

TEST(AClock, HasJumpedWhenItGoesAQuarterOfASecondFurtherThanTheCyclesExplain) {
    for (const std::uint32_t missed_cycles : {0U, 1U, 30U}) {
        const std::int64_t explained_ns = cycle_ns * (std::int64_t{missed_cycles} + 1);
        ClockCheck check;
        EXPECT_FALSE(check.has_jumped(0, 0U));
        EXPECT_FALSE(check.has_jumped(explained_ns + too_far_ns, missed_cycles));
        EXPECT_TRUE(check.has_jumped(2 * (explained_ns + too_far_ns) + 1, missed_cycles));
    }
}

TEST(AClock, MayStartAtAnyTime) {
    for (const std::int64_t start_ns : {std::int64_t{-1}, std::int64_t{1'000'000'000'000}}) {
        ClockCheck check;
        EXPECT_FALSE(check.has_jumped(start_ns, 0U));
        EXPECT_FALSE(check.has_jumped(start_ns + cycle_ns, 0U));
    }
}

class AParameterGuard : public ::testing::Test {
 protected:
    static constexpr std::size_t word_count = sizeof(rsi::Parameters) / sizeof(std::uint32_t);

    void SetUp() override { guard.start(parameters); }

    void add(std::size_t word, std::uint32_t change) {
        unsigned char* const place = reinterpret_cast<unsigned char*>(&parameters) + 4U * word;
        std::uint32_t value = 0U;
        std::memcpy(&value, place, sizeof value);
        value += change;
        std::memcpy(place, &value, sizeof value);
    }

    // In which cycle from now on the change is seen; 0 when in none of twelve.
    int seen_in_cycle() {
        for (int cycle = 1; cycle <= 12; ++cycle) {
            if (guard.is_damaged(parameters)) {
                return cycle;
            }
        }
        return 0;
    }

    rsi::Parameters parameters = rsi_test_large_suv();
    ParameterGuard guard;
};

TEST_F(AParameterGuard, FindsNothingInWhatHasNotChanged) {
    EXPECT_EQ(seen_in_cycle(), 0);
}

// A pass takes five cycles: a change is seen by the pass that it was made in, if that had not come so far,
// else by the next.
TEST_F(AParameterGuard, FindsAChangeOfAnyWordAtAnyTimeWithinNineCycles) {
    int soonest = 12;
    int latest = 0;
    for (std::size_t word = 0U; word < word_count; ++word) {
        for (int cycles_before = 0; cycles_before < 5; ++cycles_before) {
            guard.start(parameters);
            for (int cycle = 0; cycle < cycles_before; ++cycle) {
                ASSERT_FALSE(guard.is_damaged(parameters));
            }
            add(word, 1U);
            const int seen = seen_in_cycle();
            EXPECT_GE(seen, 1) << word;
            soonest = std::min(soonest, seen);
            latest = std::max(latest, seen);
            add(word, ~0U);
        }
    }
    EXPECT_EQ(soonest, 1);
    EXPECT_EQ(latest, 9);
}

TEST_F(AParameterGuard, FindsTwoChangesThatCancelOutInASum) {
    add(3U, 1U);
    add(17U, ~0U);  // one less
    EXPECT_GE(seen_in_cycle(), 1);
}

// Counted from the last word, which weighs one.
TEST_F(AParameterGuard, FindsTwoChangesThatCancelOutInAWeightedSum) {
    add(word_count - 2U, 1U);
    add(word_count - 1U, ~1U);  // two less
    EXPECT_GE(seen_in_cycle(), 1);
}

TEST_F(AParameterGuard, DoesNotTrustParametersThatHaveBeenDamagedOnce) {
    add(5U, 1U);
    ASSERT_GE(seen_in_cycle(), 1);
    add(5U, ~0U);
    for (int cycle = 0; cycle < 12; ++cycle) {
        EXPECT_TRUE(guard.is_damaged(parameters));
    }
}

TEST_F(AParameterGuard, TakesWhatItIsStartedWithInTheMiddleOfAPassToo) {
    for (int cycles_before = 0; cycles_before < 4; ++cycles_before) {
        add(5U, 1U);
        for (int cycle = 0; cycle < cycles_before; ++cycle) {
            guard.is_damaged(parameters);
        }
        guard.start(parameters);
        EXPECT_EQ(seen_in_cycle(), 0);
    }
    add(5U, 1U);
    ASSERT_GE(seen_in_cycle(), 1);
    guard.start(parameters);
    EXPECT_EQ(seen_in_cycle(), 0);
}

TEST(AnEstimate, IsInRangeUpToItsLimits) {
    struct Limit {
        float rsi::Outputs::* number;
        float largest;
    };
    for (const Limit& limit : {Limit{&rsi::Outputs::roll_centre_vertical_m, 2.0F},
                               Limit{&rsi::Outputs::roll_stiffness_deviation_nmprad, 1.0e10F},
                               Limit{&rsi::Outputs::roll_damping_deviation_nmsprad, 1.0e5F}}) {
        for (const float sign : {1.0F, -1.0F}) {
            rsi::Outputs outputs{};
            outputs.*limit.number = sign * limit.largest;
            EXPECT_TRUE(rsi::monitoring::estimate_is_in_range(outputs));
            outputs.*limit.number = sign * limit.largest * 1.001F;
            EXPECT_FALSE(rsi::monitoring::estimate_is_in_range(outputs));
        }
        for (const float none : {nan, infinity}) {
            rsi::Outputs outputs{};
            outputs.*limit.number = none;
            EXPECT_FALSE(rsi::monitoring::estimate_is_in_range(outputs));
        }
    }
}

TEST(AnEstimate, IsOutOfRangeWithALoadThatCannotHaveBeenLearnt) {
    const auto is_in_range = [](float excess, float deviation) {
        rsi::Outputs outputs{};
        outputs.load_excess = excess;
        outputs.load_excess_deviation = deviation;
        return rsi::monitoring::estimate_is_in_range(outputs);
    };
    EXPECT_TRUE(is_in_range(-0.6F, 0.01F));
    EXPECT_TRUE(is_in_range(1.0F, 0.25F));
    for (const float excess : {-0.601F, 1.001F, nan, infinity}) {
        EXPECT_FALSE(is_in_range(excess, 0.1F)) << excess;
    }
    for (const float deviation : {-0.001F, 0.251F, nan, infinity}) {
        EXPECT_FALSE(is_in_range(0.1F, deviation)) << deviation;
    }
}

TEST(AnOutput, IsSoundWithEveryStateSideAndSourceThatThereIs) {
    rsi::Outputs outputs{};
    for (const rsi_state state :
         {RSI_STATE_UNAVAILABLE, RSI_STATE_READY, RSI_STATE_ADVISORY, RSI_STATE_WARNING}) {
        outputs.state = state;
        EXPECT_TRUE(rsi::monitoring::outputs_are_sound(outputs));
    }
    for (const rsi_side side : {RSI_SIDE_NONE, RSI_SIDE_LEFT, RSI_SIDE_RIGHT}) {
        outputs.side = side;
        EXPECT_TRUE(rsi::monitoring::outputs_are_sound(outputs));
    }
    for (const rsi_roll_source source : {RSI_ROLL_NONE, RSI_ROLL_SENSOR, RSI_ROLL_OBSERVER}) {
        outputs.roll_source = source;
        EXPECT_TRUE(rsi::monitoring::outputs_are_sound(outputs));
        EXPECT_EQ(rsi::monitoring::has_computed(outputs), source != RSI_ROLL_NONE);
    }
}

TEST(AnOutput, ThatIsWithdrawnSaysNothingOfTheRisk) {
    rsi::Outputs outputs{};
    outputs.state = RSI_STATE_WARNING;
    outputs.side = RSI_SIDE_LEFT;
    rsi::monitoring::withdraw(outputs);
    EXPECT_EQ(outputs.state, RSI_STATE_UNAVAILABLE);
    EXPECT_EQ(outputs.side, RSI_SIDE_NONE);
    EXPECT_TRUE(std::isnan(outputs.warning_level));
    EXPECT_TRUE(std::isnan(outputs.lateral_acceleration_mps2));
    EXPECT_TRUE(std::isnan(outputs.lateral_acceleration_threshold_mps2));
}

class ADegradation : public ::testing::Test {
 protected:
    ADegradation() {
        inputs.speed_mps = 20.0F;
        outputs.state = RSI_STATE_READY;
        outputs.roll_source = RSI_ROLL_SENSOR;
    }

    Degradation degradation(bool internal_fault = false) const {
        return rsi::monitoring::degradation_of(inputs, outputs, internal_fault, confirmed);
    }

    rsi::Inputs inputs{};
    rsi::Outputs outputs{};
    rsi::monitoring::CodeSet confirmed{0U};
};

TEST_F(ADegradation, IsNoneWhenAllThatMattersIsThere) {
    EXPECT_EQ(degradation(), Degradation::full);
    inputs.steering_wheel_angle_rad = nan;
    inputs.vertical_specific_force_mps2 = nan;
    inputs.bank_angle_rad = nan;
    EXPECT_EQ(degradation(), Degradation::full);
}

TEST_F(ADegradation, IsThatOfTheMotionWithoutSpeedOrYawRate) {
    inputs.speed_mps = nan;
    EXPECT_EQ(degradation(), Degradation::motion_lost);
    inputs.speed_mps = 20.0F;
    inputs.yaw_rate_radps = nan;
    EXPECT_EQ(degradation(), Degradation::motion_lost);
}

TEST_F(ADegradation, IsThatOfTheRollSensorWhileAnythingElseStandsInForIt) {
    outputs.roll_source = RSI_ROLL_OBSERVER;
    EXPECT_EQ(degradation(), Degradation::roll_sensor_lost);
}

TEST_F(ADegradation, IsThatOfTheMassWhileOneOfItsCodesIsConfirmed) {
    using rsi::monitoring::DiagnosticCode;
    confirmed = rsi::monitoring::set_of(DiagnosticCode::bank_angle_invalid);
    EXPECT_EQ(degradation(), Degradation::full);
    for (const DiagnosticCode code : {DiagnosticCode::vehicle_mass_invalid, DiagnosticCode::vehicle_mass_jump,
                                      DiagnosticCode::vehicle_mass_contradicts_load}) {
        confirmed = rsi::monitoring::set_of(code);
        EXPECT_EQ(degradation(), Degradation::mass_lost);
    }
    inputs.speed_mps = nan;
    EXPECT_EQ(degradation(), Degradation::motion_lost);
}

// The worse hides the less bad.
TEST_F(ADegradation, IsTheWorstOfThoseThatHold) {
    inputs.speed_mps = nan;
    outputs.roll_source = RSI_ROLL_OBSERVER;
    EXPECT_EQ(degradation(), Degradation::roll_sensor_lost);
    outputs.state = RSI_STATE_UNAVAILABLE;
    EXPECT_EQ(degradation(), Degradation::unavailable);
    EXPECT_EQ(degradation(true), Degradation::internal_fault);
    outputs.state = RSI_STATE_WARNING;
    EXPECT_EQ(degradation(true), Degradation::internal_fault);
}

}  // namespace
}  // namespace monitoring_self_check_test
