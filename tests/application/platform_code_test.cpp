// The diagnostic codes of what the ECU notices of its own platform: cycles, bus, clock, parameters; each from
// the very amount at which docs/safety.md says that it is a fault.
#include <gtest/gtest.h>

#include <cstddef>
#include <limits>

#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

using State = rsi::can_dbc::RolloverWarning::State;
using Code = rsi::can_dbc::RolloverDiagnosis::Code;
using CodeStatus = rsi::can_dbc::RolloverDiagnosis::CodeStatus;

class APlatform : public ::testing::Test {
 protected:
    void SetUp() override {
        bench.run_until_ready();
        from = bench.cycles().size();
    }

    bool told(Code code, CodeStatus status) const {
        for (std::size_t index = from; index < bench.cycles().size(); ++index) {
            const rsi::can_dbc::RolloverDiagnosis& diagnosis = bench.cycles()[index].diagnosis.value;
            if (diagnosis.code == code && diagnosis.code_status == status) {
                return true;
            }
        }
        return false;
    }

    bool confirmed(Code code) const { return told(code, CodeStatus::confirmed); }

    void miss_once(std::uint32_t cycles) {
        bench.miss_cycles(cycles);
        bench.run_cycles(1);
        bench.miss_cycles(0U);
        bench.run_cycles(3);
    }

    Bench bench;
    std::size_t from{0U};
};

TEST_F(APlatform, WithoutAFaultHasNoCode) {
    bench.run_for(1.0);
    for (const Cycle& cycle : bench.cycles()) {
        ASSERT_EQ(cycle.diagnosis.value.code, Code::none);
    }
}

TEST_F(APlatform, ThatMissesOneCycleHasAnOverrunThatHealsInASecond) {
    miss_once(1U);
    EXPECT_TRUE(confirmed(Code::cycle_overrun));
    EXPECT_FALSE(confirmed(Code::cycle_stall));
    bench.run_cycles(96);
    EXPECT_FALSE(told(Code::cycle_overrun, CodeStatus::healed));
    bench.run_cycles(1);
    EXPECT_TRUE(told(Code::cycle_overrun, CodeStatus::healed));
}

TEST_F(APlatform, ThatMissesOneCycleFlagsItInThatCycle) {
    bench.miss_cycles(1U);
    bench.run_cycles(1);
    EXPECT_TRUE(bench.status().cycle_overrun);
    EXPECT_EQ(bench.status().cycle_overruns, 1U);
    bench.miss_cycles(0U);
    bench.run_cycles(1);
    EXPECT_FALSE(bench.status().cycle_overrun);
}

TEST_F(APlatform, ThatMissesTwoCyclesHasNotStalled) {
    miss_once(2U);
    EXPECT_TRUE(confirmed(Code::cycle_overrun));
    EXPECT_FALSE(confirmed(Code::cycle_stall));
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        EXPECT_EQ(bench.cycles()[index].state(), State::ready);
    }
}

TEST_F(APlatform, ThatMissesMoreThanTwoCyclesHasStalledAndStartsAnew) {
    miss_once(3U);
    EXPECT_TRUE(confirmed(Code::cycle_overrun));
    EXPECT_TRUE(confirmed(Code::cycle_stall));
    EXPECT_EQ(bench.cycles()[from].state(), State::unavailable);
    bench.run_for(0.2);
    EXPECT_EQ(bench.state(), State::ready);
}

TEST_F(APlatform, WhoseBusIsNotErrorActiveForThreeCyclesHasABusError) {
    bench.set_bus_state(rsi::hal::BusState::error_passive);
    bench.run_cycles(2);
    EXPECT_TRUE(told(Code::bus_error, CodeStatus::set));
    EXPECT_FALSE(confirmed(Code::bus_error));
    bench.run_cycles(1);
    EXPECT_TRUE(confirmed(Code::bus_error));
    bench.set_bus_state(rsi::hal::BusState::error_active);
    bench.run_for(1.0);
    EXPECT_TRUE(told(Code::bus_error, CodeStatus::healed));
}

TEST_F(APlatform, ThatHasLostFramesHasAnOverflow) {
    rsi::hal::CanFrame foreign;
    foreign.identifier = 0x001U;
    for (int count = 0; count < 300; ++count) {
        bench.send_foreign(foreign);
    }
    bench.run_cycles(1);
    EXPECT_TRUE(confirmed(Code::receive_overflow));
    EXPECT_FALSE(confirmed(Code::bus_error));
}

TEST_F(APlatform, WhoseClockGoesOnByAQuarterOfASecondTooFarHasAClockJump) {
    bench.move_clock(rsi::hal::Time::from_milliseconds(250));
    bench.run_cycles(2);
    EXPECT_FALSE(confirmed(Code::clock_jump));
    bench.move_clock(rsi::hal::Time::from_milliseconds(251));
    bench.run_cycles(2);
    EXPECT_TRUE(confirmed(Code::clock_jump));
}

TEST(RefusedParameters, HaveTheirCodeFromTheFirstCycleOnUntilOthersAreTaken) {
    rsi::Parameters parameters = large_suv();
    parameters.track_width_m = std::numeric_limits<float>::quiet_NaN();
    Bench bench{parameters};
    for (int cycle = 0; cycle < 50; ++cycle) {
        bench.run_cycles(1);
        EXPECT_EQ(bench.last().diagnosis.value.code, Code::parameters_refused);
        EXPECT_EQ(bench.last().diagnosis.value.code_status, CodeStatus::confirmed);
    }
}

}  // namespace
}  // namespace testing_application
