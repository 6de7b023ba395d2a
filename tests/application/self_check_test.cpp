// Reactions of the ECU to its own damage: parameters, estimate, numbers, clock; and when it feeds the
// watchdog.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "rsi/ecu/monitoring/clock_check.hpp"
#include "rsi/ecu/monitoring/output_check.hpp"
#include "rsi/ecu/monitoring/parameter_guard.hpp"
#include "rsi/model/critical_roll_angle.hpp"
#include "rsi/output_table.hpp"
#include "tests/application/bench.hpp"
#include "tests/application/roll_plane_vehicle.hpp"

namespace testing_application {
namespace {

using State = rsi::can_dbc::RolloverWarning::State;
using Code = rsi::can_dbc::RolloverDiagnosis::Code;
using CodeStatus = rsi::can_dbc::RolloverDiagnosis::CodeStatus;
using Degradation = rsi::can_dbc::RolloverDiagnosis::Degradation;

bool told(const Bench& bench, std::size_t from, Code code, CodeStatus status) {
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        const rsi::can_dbc::RolloverDiagnosis& diagnosis = bench.cycles()[index].diagnosis.value;
        if (diagnosis.code == code && diagnosis.code_status == status) {
            return true;
        }
    }
    return false;
}

// Place of these bytes in the ECU's memory.
std::vector<std::size_t> places_of(Bench& bench, const void* bytes, std::size_t length) {
    std::vector<std::size_t> places;
    for (std::size_t at = 0U; at + length <= Bench::memory_size; ++at) {
        if (std::memcmp(bench.memory() + at, bytes, length) == 0) {
            places.push_back(at);
        }
    }
    return places;
}

class ADamagedParameter : public ::testing::TestWithParam<std::size_t> {};

// Any byte of them: the tests' instances are spread over all.
TEST_P(ADamagedParameter, IsAnInternalFaultWithin70MillisecondsAndStarvesTheWatchdog) {
    Bench bench;
    bench.run_until_ready();
    const rsi::Parameters parameters = large_suv();
    const std::vector<std::size_t> places = places_of(bench, &parameters, sizeof parameters);
    ASSERT_EQ(places.size(), 1U);
    const std::size_t from = bench.cycles().size();
    bench.memory()[places.front() + GetParam()] ^= 0x10U;
    bench.run_cycles(10);
    EXPECT_TRUE(told(bench, from, Code::parameters_damaged, CodeStatus::confirmed));
    EXPECT_EQ(bench.state(), State::unavailable);
    EXPECT_EQ(bench.last().diagnosis.value.degradation, Degradation::internal_fault);
    EXPECT_EQ(bench.last().warning.status.warning_level, rsi::can_dbc::SignalStatus::not_available);

    const int feeds = bench.watchdog_feeds();
    bench.run_for(2.0);
    EXPECT_EQ(bench.watchdog_feeds(), feeds);  // only a start from new helps
    EXPECT_EQ(bench.state(), State::unavailable);
}

INSTANTIATE_TEST_SUITE_P(AtEveryFifthWord, ADamagedParameter,
                         ::testing::Range(std::size_t{0U}, sizeof(rsi::Parameters), std::size_t{20U}));

TEST(GoodParameters, FeedTheWatchdogOnceACycle) {
    Bench bench;
    bench.run_for(1.0);
    EXPECT_EQ(bench.watchdog_feeds(), 100);
}

TEST(TheParameterGuard, SeesTwoExchangedWords) {
    rsi::Parameters parameters = large_suv();
    rsi::monitoring::ParameterGuard guard;
    guard.start(parameters);
    std::swap(parameters.imu_x_m, parameters.sprung_mass_kg);
    bool damaged = false;
    for (int cycle = 0; cycle < 5; ++cycle) {
        damaged = guard.is_damaged(parameters);
    }
    EXPECT_TRUE(damaged);
}

// A slalom, so that there is an estimate. The component heals much by itself, so what is damaged here is what
// it heals by: the constants that it has made of the parameters, in its own memory and in the copy of it.
class ADamagedComponent : public ::testing::Test {
 protected:
    static rsi::Parameters parameters() {
        rsi::Parameters parameters = large_suv();
        parameters.initial_roll_centre_deviation_m = 0.1237F;  // a value that nothing else has
        return parameters;
    }

    void SetUp() override {
        bench.drive([this](double time_s) {
            vehicle.advance(4.0 * std::sin(2.0 * time_s));
            return vehicle.motion();
        });
        bench.run_for(4.0);
        ASSERT_EQ(bench.state(), State::ready);
    }

    // Every copy of `value` in the ECU but that of the parameters themselves.
    void damage(float value, float damaged) {
        const rsi::Parameters sound = parameters();
        const std::size_t kept = places_of(bench, &sound, sizeof sound).at(0);
        for (const std::size_t place : places_of(bench, &value, sizeof value)) {
            if (place < kept || place >= kept + sizeof sound) {
                std::memcpy(bench.memory() + place, &damaged, sizeof damaged);
            }
        }
    }

    void expect_reset_and_recovery(Code code) {
        const std::size_t from = bench.cycles().size();
        const int feeds = bench.watchdog_feeds();
        bench.run_cycles(4);
        EXPECT_TRUE(told(bench, from, code, CodeStatus::confirmed));
        EXPECT_EQ(bench.state(), State::unavailable);
        EXPECT_EQ(bench.last().diagnosis.value.degradation, Degradation::internal_fault);
        EXPECT_LT(bench.watchdog_feeds(), feeds + 4);  // not after the unhealthy step
        for (std::size_t index = from; index < bench.cycles().size(); ++index) {
            const Cycle& cycle = bench.cycles()[index];
            EXPECT_EQ(cycle.frames.size(), frames_per_cycle);
            EXPECT_TRUE(cycle.state() == State::unavailable || cycle.warning.status.all_valid());
        }
        bench.run_for(1.3);
        EXPECT_EQ(bench.state(), State::ready);
        EXPECT_EQ(bench.last().diagnosis.value.degradation, Degradation::full);
        EXPECT_LT(std::abs(bench.outputs().roll_centre_vertical_m), 1.0F);
        EXPECT_TRUE(told(bench, from, code, CodeStatus::healed));
    }

    Bench bench{parameters()};
    RollPlaneVehicle vehicle{large_suv()};
};

TEST_F(ADamagedComponent, WhoseEstimateLeavesItsRangeStartsAnewFromTheParameters) {
    ASSERT_NE(bench.outputs().roll_centre_vertical_m, 0.0F);
    damage(parameters().initial_roll_centre_deviation_m, 1.0e6F);
    expect_reset_and_recovery(Code::estimate_out_of_range);
}

TEST_F(ADamagedComponent, WhoseAnswerIsNoNumberStartsAnewFromTheParameters) {
    damage(parameters().roll_damping_nmsprad, std::numeric_limits<float>::quiet_NaN());
    expect_reset_and_recovery(Code::output_not_finite);
}

// One bit, of the component alone: the copy that is kept of it is good.
class AComponentOfWhichABitChanges : public ::testing::Test {
 protected:
    struct Driven {
        Driven() {
            bench.drive([this](double time_s) {
                vehicle.advance(4.0 * std::sin(2.0 * time_s));
                return vehicle.motion();
            });
            bench.run_for(4.0);
        }
        Bench bench{large_suv()};
        RollPlaneVehicle vehicle{large_suv()};
    };

    // The component comes before the parameters that it was started with.
    unsigned char& byte_of_component() {
        const rsi::Parameters parameters = large_suv();
        const std::size_t end = places_of(disturbed.bench, &parameters, sizeof parameters).at(0);
        return disturbed.bench.memory()[end - sizeof(rsi::Component) / 2U];
    }

    Driven sound;
    Driven disturbed;
};

TEST_F(AComponentOfWhichABitChanges, GoesOnAsIfNothingHadHappenedAndSaysSo) {
    Bench& bench = disturbed.bench;
    ASSERT_EQ(bench.state(), State::ready);
    const std::size_t from = bench.cycles().size();
    const int feeds = bench.watchdog_feeds();
    byte_of_component() ^= 0x40U;
    for (int cycle = 0; cycle < 130; ++cycle) {
        sound.bench.run_cycles(1);
        bench.run_cycles(1);
        ASSERT_EQ(std::memcmp(&bench.outputs(), &sound.bench.outputs(), sizeof(rsi::Outputs)), 0) << cycle;
        EXPECT_EQ(bench.state(), sound.bench.state());
        EXPECT_EQ(bench.last().diagnosis.value.degradation, Degradation::full);
    }
    EXPECT_EQ(bench.watchdog_feeds(), feeds + 130);
    EXPECT_TRUE(told(bench, from, Code::memory_restored, CodeStatus::confirmed));
    EXPECT_TRUE(told(bench, from, Code::memory_restored, CodeStatus::healed));
}

TEST_F(AComponentOfWhichABitChanges, StarvesTheWatchdogWhereItDoesNotStayRestored) {
    Bench& bench = disturbed.bench;
    const std::size_t from = bench.cycles().size();
    const int feeds = bench.watchdog_feeds();
    for (int cycle = 0; cycle < 5; ++cycle) {
        byte_of_component() ^= 0x40U;
        bench.run_cycles(1);
    }
    EXPECT_EQ(bench.watchdog_feeds(), feeds + 1);
    EXPECT_TRUE(told(bench, from, Code::parameters_damaged, CodeStatus::confirmed));
    EXPECT_EQ(bench.state(), State::unavailable);
    EXPECT_EQ(bench.last().diagnosis.value.degradation, Degradation::internal_fault);
}

// Neither component nor copy is what it was: nothing that is computed from them may be used again.
TEST_F(AComponentOfWhichABitChanges, StarvesTheWatchdogForGoodWhereItsCopyHasChangedToo) {
    Bench& bench = disturbed.bench;
    std::array<unsigned char, 64U> around{};
    std::memcpy(around.data(), &byte_of_component() - around.size() / 2U, around.size());
    const std::vector<std::size_t> places = places_of(bench, around.data(), around.size());
    ASSERT_EQ(places.size(), 2U);
    bench.memory()[places.at(0) + 31U] ^= 0x40U;
    bench.memory()[places.at(1) + 32U] ^= 0x40U;
    const int feeds = bench.watchdog_feeds();
    for (int cycle = 0; cycle < 300; ++cycle) {
        bench.run_cycles(1);
        ASSERT_EQ(bench.state(), State::unavailable) << cycle;
    }
    EXPECT_EQ(bench.watchdog_feeds(), feeds);
}

// A reset keeps what init finds by iterating. If that is damaged, only a start from new helps.
TEST_F(ADamagedComponent, WhichAResetCannotHealStarvesTheWatchdog) {
    constexpr float no_number = std::numeric_limits<float>::quiet_NaN();
    damage(rsi::critical_roll_angle_rad(parameters()), no_number);
    damage(parameters().roll_damping_nmsprad, no_number);
    bench.run_cycles(4);
    const int feeds = bench.watchdog_feeds();
    bench.run_for(2.0);
    EXPECT_EQ(bench.watchdog_feeds(), feeds);
    EXPECT_EQ(bench.state(), State::unavailable);
    EXPECT_EQ(bench.last().diagnosis.value.degradation, Degradation::internal_fault);
}

TEST(TheOutputCheck, NoticesEveryNumberThatIsNone) {
    rsi::Outputs good{};
    good.state = RSI_STATE_READY;
    good.roll_source = RSI_ROLL_SENSOR;
    ASSERT_TRUE(rsi::monitoring::outputs_are_sound(good));
    ASSERT_TRUE(rsi::monitoring::estimate_is_in_range(good));
    std::vector<float rsi::Outputs::*> numbers{
        &rsi::Outputs::warning_level, &rsi::Outputs::lateral_acceleration_mps2,
        &rsi::Outputs::lateral_acceleration_threshold_mps2, &rsi::Outputs::roll_centre_lateral_m};
    for (const rsi::IndexOutput& index : rsi::index_outputs) {
        numbers.push_back(index.member);
    }
    for (const auto number : numbers) {
        for (const float bad :
             {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
            rsi::Outputs outputs = good;
            outputs.*number = bad;
            EXPECT_FALSE(rsi::monitoring::outputs_are_sound(outputs));
        }
    }
    const auto with = [&good](auto member, auto value) {
        rsi::Outputs outputs = good;
        outputs.*member = value;
        return outputs;
    };
    const auto with_code = [&good](auto member, std::uint32_t code) {  // as damaged memory has it
        rsi::Outputs outputs = good;
        static_assert(sizeof(outputs.*member) == sizeof code);
        std::memcpy(&(outputs.*member), &code, sizeof code);
        return outputs;
    };
    EXPECT_FALSE(rsi::monitoring::outputs_are_sound(with_code(&rsi::Outputs::state, 4U)));
    EXPECT_FALSE(rsi::monitoring::outputs_are_sound(with_code(&rsi::Outputs::side, 3U)));
    EXPECT_FALSE(rsi::monitoring::outputs_are_sound(with_code(&rsi::Outputs::roll_source, 3U)));
    EXPECT_FALSE(rsi::monitoring::estimate_is_in_range(with(&rsi::Outputs::roll_centre_vertical_m, -2.5F)));
    EXPECT_FALSE(
        rsi::monitoring::estimate_is_in_range(with(&rsi::Outputs::roll_stiffness_deviation_nmprad, 2.0e10F)));
    EXPECT_FALSE(
        rsi::monitoring::estimate_is_in_range(with(&rsi::Outputs::roll_damping_deviation_nmsprad, 2.0e5F)));
}

TEST(TheClock, ThatJumpsIsReportedAndHeals) {
    Bench bench;
    bench.run_for(2.0);
    const std::size_t from = bench.cycles().size();
    bench.move_clock(rsi::hal::Time::from_milliseconds(1000));
    bench.run_cycles(2);
    EXPECT_TRUE(told(bench, from, Code::clock_jump, CodeStatus::confirmed));
    bench.run_for(1.5);
    EXPECT_TRUE(told(bench, from, Code::clock_jump, CodeStatus::healed));
    EXPECT_EQ(bench.state(), State::ready);
}

TEST(TheClock, ThatIsLateByMissedCyclesHasNotJumped) {
    rsi::monitoring::ClockCheck check;
    EXPECT_FALSE(check.has_jumped(0, 0U));
    EXPECT_FALSE(check.has_jumped(10'000'000, 0U));
    EXPECT_FALSE(check.has_jumped(1'020'000'000, 100U));
    EXPECT_TRUE(check.has_jumped(2'030'000'000, 0U));
    EXPECT_TRUE(check.has_jumped(2'029'000'000, 0U));
}

}  // namespace
}  // namespace testing_application
