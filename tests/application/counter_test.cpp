// Counters: repeated, skipped and forbidden values.
#include <gtest/gtest.h>

#include <string>

#include "tests/application/bench.hpp"
#include "tests/application/end_to_end.hpp"

namespace testing_application {
namespace {

using State = rsi::can_dbc::RolloverWarning::State;

bool counter_error(const rsi::can_dbc::RolloverStatus& status, Sensor sensor) {
    switch (sensor) {
        case Sensor::imu:
            return status.imu_counter_error;
        case Sensor::roll_angle:
            return status.roll_angle_counter_error;
        case Sensor::vehicle_motion:
            return status.vehicle_motion_counter_error;
    }
    return false;
}

class Counter : public ::testing::TestWithParam<Sensor> {
 protected:
    void SetUp() override {
        bench.run_for(0.5);  // the observer knows the roll angle, too
        ASSERT_EQ(bench.state(), State::ready);
    }

    void expect_only_this_sensors_flag() {
        for (const Sensor other : all_sensors) {
            EXPECT_EQ(counter_error(bench.status(), other), other == sensor) << name_of(other);
        }
    }

    Sensor sensor{GetParam()};
    Bench bench;
};

TEST_P(Counter, ThatSkipsOneOrTwoIsToleratedAndTheLostFramesAreCounted) {
    unsigned lost = 0U;
    for (const unsigned skipped : {1U, 2U}) {
        bench.lose_frames(sensor, skipped);
        lost += skipped;
        bench.run_cycles(1);
        EXPECT_FALSE(counter_error(bench.status(), sensor));
        EXPECT_EQ(bench.status().frames_lost, lost);
        EXPECT_EQ(bench.status().frames_rejected, 0U);
        EXPECT_EQ(bench.state(), State::ready);
    }
}

TEST_P(Counter, ThatSkipsMoreIsRejectedOnceAndThenFollowed) {
    unsigned rejected = 0U;
    unsigned lost = 0U;
    for (unsigned skipped = 3U; skipped <= 13U; ++skipped) {
        SCOPED_TRACE("skipped " + std::to_string(skipped));
        bench.lose_frames(sensor, skipped);
        bench.run_cycles(1);
        expect_only_this_sensors_flag();
        EXPECT_EQ(bench.status().frames_rejected, ++rejected);
        lost += skipped;
        EXPECT_EQ(bench.status().frames_lost, lost);
        bench.run_cycles(1);
        EXPECT_FALSE(counter_error(bench.status(), sensor));
        EXPECT_EQ(bench.status().frames_rejected, rejected);
        EXPECT_EQ(bench.state(), State::ready);
    }
}

TEST_P(Counter, ThatRepeatsIsRejectedUntilItMovesAgain) {
    bench.repeat_counter(sensor, true);
    bench.run_cycles(1);  // the first of them still follows its predecessor
    EXPECT_EQ(bench.status().frames_rejected, 0U);
    bench.run_cycles(20);
    expect_only_this_sensors_flag();
    EXPECT_EQ(bench.status().frames_rejected, 20U);
    EXPECT_EQ(bench.state(), sensor == Sensor::imu ? State::unavailable : State::ready);
    bench.repeat_counter(sensor, false);
    bench.run_cycles(2);
    EXPECT_FALSE(counter_error(bench.status(), sensor));
    bench.run_for(0.2);
    EXPECT_EQ(bench.state(), State::ready);
}

TEST_P(Counter, Of15IsRefusedAsADamagedFrame) {
    const std::uint16_t data_ids[] = {rsi::can_dbc::Imu::e2e_data_id, rsi::can_dbc::RollAngle::e2e_data_id,
                                      rsi::can_dbc::VehicleMotion::e2e_data_id};
    const std::uint16_t data_id = data_ids[static_cast<std::size_t>(sensor)];
    bench.tamper(sensor, [data_id](rsi::hal::CanFrame& frame) { protect(frame, data_id, 15U); });
    bench.run_cycles(1);
    EXPECT_EQ(bench.status().frames_rejected, 1U);
    EXPECT_EQ(bench.status().imu_checksum_error, sensor == Sensor::imu);
    EXPECT_EQ(bench.status().roll_angle_checksum_error, sensor == Sensor::roll_angle);
    EXPECT_EQ(bench.status().vehicle_motion_checksum_error, sensor == Sensor::vehicle_motion);
    EXPECT_FALSE(counter_error(bench.status(), sensor));
}

// A frame that reaches the ECU twice, as through a gateway in a loop.
TEST_P(Counter, OfADuplicatedFrameIsRejectedAndTheFirstOneUsed) {
    const std::size_t from = bench.cycles().size();
    for (int cycle = 1; cycle <= 50; ++cycle) {
        bench.send_foreign(bench.last_frame(sensor));
        bench.run_cycles(1);
        expect_only_this_sensors_flag();
        EXPECT_EQ(bench.status().frames_rejected, cycle);
    }
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        EXPECT_EQ(bench.cycles()[index].state(), State::ready);
    }
}

// The flags are of the whole cycle, not of its last frame.
TEST_P(Counter, OfAFrameBeforeAGoodOneInTheSameCycleIsStillReported) {
    bench.send_foreign(bench.last_frame(sensor));  // its counter is an old one
    bench.run_cycles(1);
    expect_only_this_sensors_flag();
    bench.run_cycles(1);
    EXPECT_FALSE(counter_error(bench.status(), sensor));
}

INSTANTIATE_TEST_SUITE_P(OfEachSensor, Counter, ::testing::ValuesIn(all_sensors),
                         [](const auto& tested) { return std::string{name_of(tested.param)}; });

}  // namespace
}  // namespace testing_application
