// A cycle that comes late, and a bus that does not take what the ECU sends.
#include <gtest/gtest.h>

#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

using State = rsi::can_dbc::RolloverWarning::State;

// The IMU far below the CG, so that a jump of the roll rate reaches far into the lateral force.
rsi::Parameters with_imu_offset() {
    rsi::Parameters parameters = large_suv();
    parameters.imu_z_m = -0.5F;
    return parameters;
}

Motion rolling(float roll_rate_deg_per_s) {
    Motion motion;
    motion.imu.lateral_acceleration_mps2 = 5.0F;
    motion.imu.roll_rate_deg_per_s = roll_rate_deg_per_s;
    motion.roll_angle.roll_angle_deg = 4.0F;
    return motion;
}

TEST(AStalledCycle, DoesNotTakeWhatHappenedMeanwhileForAJump) {
    Bench bench{with_imu_offset()};
    bench.drive(rolling(12.0F));
    bench.run_for(0.15);  // for longer, angle and rate would contradict each other
    ASSERT_EQ(bench.state(), State::ready);

    bench.drive(rolling(-12.0F));
    bench.miss_cycles(10U);
    bench.run_cycles(1);
    EXPECT_EQ(bench.state(), State::unavailable);
    bench.miss_cycles(0U);
    for (int cycle = 0; cycle < 15; ++cycle) {
        bench.run_cycles(1);
        ASSERT_NE(bench.state(), State::warning) << "cycle " << cycle;
        ASSERT_NE(bench.state(), State::advisory) << "cycle " << cycle;
    }
    EXPECT_EQ(bench.state(), State::ready);
}

TEST(AStalledCycle, OfTwoPeriodsIsBridged) {
    Bench bench;
    bench.run_until_ready();
    bench.miss_cycles(2U);
    bench.run_cycles(1);
    EXPECT_EQ(bench.state(), State::ready);
}

// Takes every frame but those that it has to refuse.
class RefusingBus final : public rsi::hal::CanBus {
 public:
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame&) noexcept override {
        return rsi::hal::ReceiveResult::empty;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        if (refuse) {
            ++failures_;
            return rsi::hal::SendResult::full;
        }
        last = frame;
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override {
        rsi::hal::BusStatistics statistics;
        statistics.send_failures = failures_;
        return statistics;
    }

    bool refuse{false};
    rsi::hal::CanFrame last{};

 private:
    std::uint32_t failures_{0U};
};

TEST(ARefusedFrame, IsABusErrorInTheNextStatus) {
    RefusingBus bus;
    const rsi::hal::VirtualClock clock;
    NoWatchdog watchdog;
    rsi::application::RolloverEcu ecu{bus, clock, watchdog};
    ASSERT_EQ(ecu.init(large_suv()).accepted, 1);
    const auto bus_error = [&bus] {
        return rsi::can_dbc::decode<rsi::can_dbc::RolloverStatus>(bus.last.data).value.bus_error;
    };

    ecu.step(0U);
    ASSERT_EQ(bus.last.identifier, rsi::can_dbc::RolloverStatus::identifier);
    EXPECT_FALSE(bus_error());
    bus.refuse = true;
    ecu.step(0U);
    bus.refuse = false;
    ecu.step(0U);
    EXPECT_TRUE(bus_error());
    ecu.step(0U);
    EXPECT_FALSE(bus_error());
}

}  // namespace
}  // namespace testing_application
