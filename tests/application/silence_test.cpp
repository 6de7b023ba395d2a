// A bus that falls silent: "unavailable" in a sent frame within 50 ms, never "ready", and back again.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "rsi/ecu/application/frame_monitor.hpp"
#include "tests/application/bench.hpp"

namespace testing_application {
namespace {

using Diagnosis = rsi::can_dbc::RolloverDiagnosis;

using State = rsi::can_dbc::RolloverWarning::State;

constexpr rsi::hal::Time longest_silence = rsi::hal::Time::from_milliseconds(50);

// Fails the test when the cycle has no such frame.
rsi::can_dbc::RollObserver::RollSource roll_source(const Cycle& cycle) {
    for (const rsi::hal::CanFrame& frame : cycle.frames) {
        if (frame.identifier == rsi::can_dbc::RollObserver::identifier) {
            return rsi::can_dbc::decode<rsi::can_dbc::RollObserver>(frame.data).value.roll_source;
        }
    }
    ADD_FAILURE() << "no RollObserver frame";
    return rsi::can_dbc::RollObserver::RollSource::none;
}

// The parameter is the distance of the ECU's cycle from the sensor frames, in milliseconds.
class Silence : public ::testing::TestWithParam<int> {
 protected:
    // The first cycle since `from` that says "unavailable"; the test fails when there is none, when it comes
    // late, or when a later cycle says something else.
    void expect_unavailable_in_time_and_for_ever(std::size_t from) {
        const auto& cycles = bench.cycles();
        std::size_t first = from;
        while (first < cycles.size() && cycles[first].state() != State::unavailable) {
            ++first;
        }
        ASSERT_LT(first, cycles.size()) << "never unavailable";
        const rsi::hal::Time delay = cycles[first].time - silent_since;
        EXPECT_FALSE(longest_silence < delay) << static_cast<double>(delay.nanoseconds) * 1.0e-6 << " ms";
        for (std::size_t index = first; index < cycles.size(); ++index) {
            ASSERT_EQ(cycles[index].state(), State::unavailable) << "cycle " << index;
            ASSERT_EQ(cycles[index].warning.value.side, rsi::can_dbc::RolloverWarning::Side::none);
            ASSERT_EQ(cycles[index].warning.status.warning_level, rsi::can_dbc::SignalStatus::not_available);
        }
    }

    void expect_back_after_recovery_time() {
        bench.resume_all();
        bench.run_for(0.09);
        EXPECT_EQ(bench.state(), State::unavailable) << "before the recovery time";
        bench.run_for(0.03);
        EXPECT_EQ(bench.state(), State::ready);
    }

    Bench bench{large_suv(), rsi::hal::Time::from_milliseconds(GetParam())};
    rsi::hal::Time silent_since{};
};

TEST_P(Silence, OfAllSensorsIsUnavailableWithin50Milliseconds) {
    bench.run_until_ready();
    ASSERT_EQ(bench.state(), State::ready);
    const std::size_t from = bench.cycles().size();
    silent_since = bench.last_sensor_time();
    bench.stop_all();
    bench.run_for(5.0);
    expect_unavailable_in_time_and_for_ever(from);
    EXPECT_TRUE(bench.status().imu_timeout);
    EXPECT_TRUE(bench.status().roll_angle_timeout);
    EXPECT_TRUE(bench.status().vehicle_motion_timeout);
    expect_back_after_recovery_time();
    EXPECT_FALSE(bench.status().imu_timeout);
    EXPECT_FALSE(bench.status().roll_angle_timeout);
    EXPECT_FALSE(bench.status().vehicle_motion_timeout);
}

TEST_P(Silence, OfTheImuIsUnavailableWithin50Milliseconds) {
    bench.run_for(0.3);
    ASSERT_EQ(bench.state(), State::ready);
    const std::size_t from = bench.cycles().size();
    silent_since = bench.last_sensor_time();
    bench.stop(Sensor::imu);
    bench.run_for(5.0);
    expect_unavailable_in_time_and_for_ever(from);
    EXPECT_TRUE(bench.status().imu_timeout);
    EXPECT_FALSE(bench.status().roll_angle_timeout);
    EXPECT_FALSE(bench.status().vehicle_motion_timeout);
    expect_back_after_recovery_time();
}

TEST_P(Silence, OfRollSensorAndVehicleMotionIsUnavailableWithin50Milliseconds) {
    bench.run_for(0.3);
    ASSERT_EQ(bench.state(), State::ready);
    const std::size_t from = bench.cycles().size();
    silent_since = bench.last_sensor_time();
    bench.stop(Sensor::roll_angle);
    bench.stop(Sensor::vehicle_motion);
    bench.run_for(5.0);
    expect_unavailable_in_time_and_for_ever(from);
    EXPECT_FALSE(bench.status().imu_timeout);
    EXPECT_TRUE(bench.status().roll_angle_timeout);
    EXPECT_TRUE(bench.status().vehicle_motion_timeout);
    expect_back_after_recovery_time();
}

TEST_P(Silence, OfTheRollSensorIsReportedAndTheObserverStandsIn) {
    using RollSource = rsi::can_dbc::RollObserver::RollSource;
    bench.run_for(1.0);
    ASSERT_EQ(bench.state(), State::ready);
    ASSERT_EQ(roll_source(bench.last()), RollSource::sensor);
    const std::size_t from = bench.cycles().size();
    bench.stop(Sensor::roll_angle);
    bench.run_for(5.0);
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        ASSERT_EQ(bench.cycles()[index].state(), State::ready) << "cycle " << index;
        if (index >= from + 5U) {
            ASSERT_EQ(roll_source(bench.cycles()[index]), RollSource::observer) << "cycle " << index;
        }
    }
    EXPECT_TRUE(bench.status().roll_angle_timeout);
    bench.resume_all();
    bench.run_cycles(2);
    EXPECT_FALSE(bench.status().roll_angle_timeout);
    EXPECT_EQ(roll_source(bench.last()), RollSource::sensor);
}

TEST_P(Silence, OfVehicleMotionIsReportedButTheEcuStaysAvailable) {
    bench.run_until_ready();
    bench.stop(Sensor::vehicle_motion);
    const std::size_t from = bench.cycles().size();
    bench.run_for(5.0);
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        ASSERT_EQ(bench.cycles()[index].state(), State::ready) << "cycle " << index;
    }
    EXPECT_TRUE(bench.cycles()[from + 4U].status.value.vehicle_motion_timeout);
    EXPECT_TRUE(bench.status().vehicle_motion_timeout);
    EXPECT_FALSE(bench.status().imu_timeout);
    bench.resume_all();
    bench.run_cycles(2);
    EXPECT_FALSE(bench.status().vehicle_motion_timeout);
}

TEST_P(Silence, OfTwoFramesIsBridged) {
    bench.run_until_ready();
    const std::size_t from = bench.cycles().size();
    bench.stop_all();
    bench.run_cycles(2);
    bench.resume_all();
    bench.run_cycles(1);
    for (std::size_t index = from; index < bench.cycles().size(); ++index) {
        EXPECT_EQ(bench.cycles()[index].state(), State::ready) << "cycle " << index;
    }
}

TEST_P(Silence, EndsWhateverTheSendersCountedMeanwhile) {
    for (unsigned counted = 0U; counted < 15U; ++counted) {
        SCOPED_TRACE("counted " + std::to_string(counted));
        bench.run_for(0.3);
        ASSERT_EQ(bench.state(), State::ready);
        bench.stop_all();
        bench.run_for(0.1);
        for (const Sensor sensor : all_sensors) {
            bench.lose_frames(sensor, counted);
        }
        expect_back_after_recovery_time();
    }
}

TEST_P(Silence, FromTheStartIsUnavailable) {
    bench.stop_all();
    bench.run_for(1.0);
    expect_unavailable_in_time_and_for_ever(0U);
    const rsi::can_dbc::RolloverStatus& first = bench.cycles().front().status.value;
    EXPECT_TRUE(first.imu_timeout);  // a frame that never came is not fresh, however young the clock is
    EXPECT_TRUE(first.roll_angle_timeout);
    EXPECT_TRUE(first.vehicle_motion_timeout);
}

TEST_P(Silence, IsNotBrokenByASensorThatRepeatsItsLastFrame) {
    bench.run_until_ready();
    const std::size_t from = bench.cycles().size();
    silent_since = bench.last_sensor_time();
    const rsi::hal::CanFrame stuck = bench.last_frame(Sensor::imu);
    bench.tamper(Sensor::imu, [&stuck](rsi::hal::CanFrame& frame) { frame = stuck; });
    bench.run_for(1.0);
    expect_unavailable_in_time_and_for_ever(from);
    EXPECT_TRUE(bench.status().imu_timeout);
    EXPECT_TRUE(bench.status().imu_counter_error);
}

// A frame from the future has no known age.
TEST(AFrame, IsFreshFrom10MillisecondsBeforeTo35MillisecondsAfterItsTime) {
    Bench bench;
    bench.run_cycles(1);
    rsi::hal::CanFrame frame = bench.last_frame(Sensor::imu);
    const rsi::hal::Time received = rsi::hal::Time::from_milliseconds(1000);
    frame.receive_time = received;
    rsi::application::FrameMonitor<rsi::can_dbc::Imu> monitor;
    EXPECT_FALSE(monitor.is_fresh(rsi::hal::Time{}));
    monitor.begin_cycle();
    monitor.take(frame);
    const auto fresh_after_ns = [&monitor, received](std::int64_t age_ns) {
        return monitor.is_fresh(received + rsi::hal::Time{age_ns});
    };
    EXPECT_TRUE(fresh_after_ns(0));
    EXPECT_TRUE(fresh_after_ns(35'000'000));
    EXPECT_FALSE(fresh_after_ns(35'000'001));
    EXPECT_TRUE(fresh_after_ns(-10'000'000));
    EXPECT_FALSE(fresh_after_ns(-10'000'001));
}

TEST(ASensorThatNeverSpeaks, IsAFaultFromOneSecondAfterTheStart) {
    Bench bench;
    bench.stop(Sensor::vehicle_motion);
    bench.run_for(1.0);
    for (const Cycle& cycle : bench.cycles()) {
        ASSERT_EQ(cycle.diagnosis.value.code, Diagnosis::Code::none);
    }
    bench.run_cycles(1);
    EXPECT_EQ(bench.last().diagnosis.value.code, Diagnosis::Code::vehicle_motion_lost);
    EXPECT_EQ(bench.last().diagnosis.value.code_status, Diagnosis::CodeStatus::confirmed);
}

TEST(ASensorThatHasSpoken, IsAFaultAsSoonAsItIsSilentAlsoRightAfterTheStart) {
    Bench bench;
    bench.run_for(0.3);
    bench.stop(Sensor::vehicle_motion);
    bench.run_cycles(5);
    EXPECT_EQ(bench.last().diagnosis.value.code, Diagnosis::Code::vehicle_motion_lost);
    EXPECT_EQ(bench.last().diagnosis.value.code_status, Diagnosis::CodeStatus::confirmed);
}

INSTANTIATE_TEST_SUITE_P(AtEveryPhase, Silence, ::testing::Range(0, 10),
                         [](const auto& tested) { return std::to_string(tested.param) + "Milliseconds"; });

}  // namespace
}  // namespace testing_application
