// Reports of the ECU's own health: refused parameters, missed cycles, bus state, overflow, watchdog.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

using State = rsi::can_dbc::RolloverWarning::State;

TEST(RefusedParameters, AreAnsweredByNameAndLeaveTheEcuUnavailableWithItsFlagInEachCycle) {
    rsi::Parameters parameters = large_suv();
    parameters.track_width_m = std::numeric_limits<float>::quiet_NaN();
    Bench bench{parameters};
    EXPECT_EQ(bench.parameters_answer().accepted, 0);
    EXPECT_STREQ(bench.parameters_answer().field, "track_width_m");
    bench.run_for(2.0);
    for (const Cycle& cycle : bench.cycles()) {
        ASSERT_EQ(cycle.frames.size(), frames_per_cycle);
        ASSERT_EQ(cycle.state(), State::unavailable);
        ASSERT_TRUE(cycle.status.value.parameters_invalid);
        ASSERT_EQ(cycle.warning.status.warning_level, rsi::can_dbc::SignalStatus::not_available);
    }
}

TEST(RefusedParameters, OfTheWarningIndicatorDoNotMatterForWhatIsSent) {
    rsi::Parameters parameters = large_suv();
    parameters.warning_indicator = 77;
    Bench bench{parameters};
    EXPECT_STREQ(bench.parameters_answer().field, "warning_indicator");
    bench.run_for(0.5);
    EXPECT_EQ(bench.state(), State::unavailable);
    EXPECT_TRUE(bench.status().parameters_invalid);
}

TEST(GoodParameters, RaiseNoFlag) {
    Bench bench;
    EXPECT_EQ(bench.parameters_answer().accepted, 1);
    bench.run_until_ready();
    EXPECT_FALSE(bench.status().parameters_invalid);
}

// Both indicators are computed; the frame carries the one that drives the warning. At rest on a bank of which
// the sensors know nothing both are the same, so the vehicle weighs half here, as over a crest.
TEST(TheSentIndicator, IsTheOneThatTheParametersChoose) {
    Motion motion;
    motion.imu.lateral_acceleration_mps2 = 2.0F;
    motion.imu.vertical_acceleration_mps2 = 0.5F * 9.80665F;
    rsi::Parameters parameters = large_suv();
    Bench published{parameters};
    parameters.warning_indicator = RSI_INDICATOR_BANK_FREE;
    Bench bank_free{parameters};
    for (Bench* bench : {&published, &bank_free}) {
        bench->drive(motion);
        bench->run_cycles(1);
    }
    EXPECT_NEAR(static_cast<double>(bank_free.last().warning.value.warning_level),
                2.0 * static_cast<double>(published.last().warning.value.warning_level), 0.01);
    EXPECT_GT(published.last().warning.value.warning_level, 0.2F);
}

// In the units of the frame.
TEST(AConfirmedCode, CarriesWhatTheSensorsSaidWhenItWasConfirmedFirst) {
    Bench bench;
    bench.run_until_ready();
    Motion motion;
    motion.imu.lateral_acceleration_mps2 = 3.0F;
    motion.roll_angle.roll_angle_deg = 4.0F;
    motion.vehicle_motion.yaw_rate_deg_per_s = 7.7F;
    bench.drive(motion);
    bench.run_for(0.5);
    const auto confirmed = [](const Cycle& cycle) {
        return cycle.diagnosis.value.code_status == rsi::can_dbc::RolloverDiagnosis::CodeStatus::confirmed;
    };
    for (int cycle = 0; cycle < 300 && !confirmed(bench.last()); ++cycle) {
        bench.tamper(Sensor::vehicle_motion, [](rsi::hal::CanFrame& frame) { frame.data[7] ^= 1U; });
        bench.run_cycles(1);
    }
    ASSERT_TRUE(confirmed(bench.last()));
    const rsi::can_dbc::RolloverDiagnosis& diagnosis = bench.last().diagnosis.value;
    const auto told = static_cast<rsi::monitoring::DiagnosticCode>(diagnosis.code);
    EXPECT_TRUE(bench.diagnostic_memory().confirmed(told));
    EXPECT_NEAR(diagnosis.first_lateral_acceleration_mps2, 3.0F, 0.1F);
    EXPECT_NEAR(diagnosis.first_roll_angle_deg, 4.0F, 0.2F);
}

TEST(MissedCycles, AreFlaggedInTheirCycleAndCountedForEver) {
    Bench bench;
    bench.run_until_ready();
    EXPECT_FALSE(bench.status().cycle_overrun);
    EXPECT_EQ(bench.status().cycle_overruns, 0U);
    bench.miss_cycles(3U);
    bench.run_cycles(1);
    EXPECT_TRUE(bench.status().cycle_overrun);
    EXPECT_EQ(bench.status().cycle_overruns, 3U);
    bench.miss_cycles(0U);
    bench.run_cycles(1);
    EXPECT_FALSE(bench.status().cycle_overrun);
    EXPECT_EQ(bench.status().cycle_overruns, 3U);
}

TEST(MissedCycles, StayAt255) {
    Bench bench;
    bench.miss_cycles(254U);
    bench.run_cycles(1);
    EXPECT_EQ(bench.status().cycle_overruns, 254U);
    bench.miss_cycles(1U);
    for (int cycle = 0; cycle < 600; ++cycle) {
        bench.run_cycles(1);
        ASSERT_EQ(bench.status().cycle_overruns, 255U);
    }
}

TEST(MissedCycles, StayAt255BeyondTheRangeOfTheirCounter) {
    Bench bench;
    bench.miss_cycles(std::numeric_limits<std::uint32_t>::max());
    bench.run_cycles(1);
    EXPECT_EQ(bench.status().cycle_overruns, 255U);
    bench.miss_cycles(2U);
    bench.run_cycles(1);
    EXPECT_EQ(bench.status().cycle_overruns, 255U);
}

TEST(RejectedAndLostFrames, StayAt255) {
    Bench bench;
    bench.run_until_ready();
    for (int cycle = 0; cycle < 600; ++cycle) {
        bench.lose_frames(Sensor::imu, 5U);
        bench.tamper(Sensor::roll_angle, [](rsi::hal::CanFrame& frame) { frame.data[7] ^= 1U; });
        const unsigned rejected = bench.status().frames_rejected;
        const unsigned lost = bench.status().frames_lost;
        bench.run_cycles(1);
        ASSERT_EQ(bench.status().frames_rejected, std::min(rejected + 2U, 255U));
        ASSERT_EQ(bench.status().frames_lost, std::min(lost + 5U, 255U));
    }
    EXPECT_EQ(bench.status().frames_rejected, 255U);
    EXPECT_EQ(bench.status().frames_lost, 255U);
}

// The reason of the last start as in the observer's frame of the last cycle.
rsi::can_dbc::RollObserver::ResetReason sent_reset_reason(const Bench& bench) {
    for (const rsi::hal::CanFrame& frame : bench.last().frames) {
        if (frame.identifier == rsi::can_dbc::RollObserver::identifier) {
            return rsi::can_dbc::decode<rsi::can_dbc::RollObserver>(frame.data).value.reset_reason;
        }
    }
    ADD_FAILURE() << "no RollObserver frame";
    return {};
}

TEST(TheResetReason, IsSentInEveryCycleFromTheFirstOn) {
    using Sent = rsi::can_dbc::RollObserver::ResetReason;
    Bench bench;
    bench.run_cycles(1);
    EXPECT_EQ(sent_reset_reason(bench), Sent::power_on);

    Bench after_abort;
    after_abort.start_after(rsi::hal::ResetReason::data_abort);
    for (int cycle = 0; cycle < 3; ++cycle) {
        after_abort.run_cycles(1);
        EXPECT_EQ(sent_reset_reason(after_abort), Sent::data_abort);
    }
    after_abort.start_after(rsi::hal::ResetReason::interrupt);
    after_abort.run_cycles(1);
    EXPECT_EQ(sent_reset_reason(after_abort), Sent::interrupt);
    after_abort.start_after(rsi::hal::ResetReason::start_without_reset);
    after_abort.run_cycles(1);
    EXPECT_EQ(sent_reset_reason(after_abort), Sent::start_without_reset);
}

TEST(TheWatchdog, IsFedOnceACycleWhateverTheSensorsDo) {
    Bench bench;
    bench.run_cycles(100);
    EXPECT_EQ(bench.watchdog_feeds(), 100);
    bench.stop_all();
    bench.run_cycles(100);
    EXPECT_EQ(bench.watchdog_feeds(), 200);
}

TEST(TheBusState, IsReportedWhileItIsNotErrorActive) {
    Bench bench;
    bench.run_until_ready();
    EXPECT_FALSE(bench.status().bus_error);
    bench.set_bus_state(rsi::hal::BusState::error_passive);
    bench.run_cycles(1);
    EXPECT_TRUE(bench.status().bus_error);
    EXPECT_EQ(bench.state(), State::ready);
    bench.set_bus_state(rsi::hal::BusState::error_active);
    bench.run_cycles(1);
    EXPECT_FALSE(bench.status().bus_error);
}

class DeadBus : public ::testing::TestWithParam<rsi::hal::BusState> {};

TEST_P(DeadBus, EndsInUnavailableUntilTheSensorsAreHeardAgain) {
    Bench bench;
    bench.run_until_ready();
    bench.set_bus_state(GetParam());
    const std::size_t from = bench.cycles().size();
    bench.run_for(1.0);
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        ASSERT_TRUE(bench.cycles()[index].frames.empty());
    }
    const int feeds = bench.watchdog_feeds();
    bench.set_bus_state(rsi::hal::BusState::error_active);
    bench.run_cycles(1);
    EXPECT_EQ(bench.watchdog_feeds(), feeds + 1);
    EXPECT_EQ(bench.last().frames.size(), frames_per_cycle);
    EXPECT_EQ(bench.state(), State::unavailable);
    bench.run_for(0.2);
    EXPECT_EQ(bench.state(), State::ready);
}

INSTANTIATE_TEST_SUITE_P(OffOrClosed, DeadBus,
                         ::testing::Values(rsi::hal::BusState::bus_off, rsi::hal::BusState::closed),
                         [](const auto& tested) {
                             return std::string{tested.param == rsi::hal::BusState::closed ? "Closed"
                                                                                           : "BusOff"};
                         });

TEST(ReceiveOverflow, IsReportedInTheCycleThatFollowsIt) {
    Bench bench;
    bench.run_until_ready();
    rsi::hal::CanFrame foreign;
    foreign.identifier = 0x001U;
    for (int count = 0; count < 300; ++count) {
        bench.send_foreign(foreign);
    }
    bench.run_cycles(1);
    EXPECT_TRUE(bench.status().receive_overflow);
    bench.run_cycles(10);
    EXPECT_FALSE(bench.status().receive_overflow);
}

}  // namespace
}  // namespace testing_application
