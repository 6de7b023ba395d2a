// Frames of the ECU: order, kind, protection, counters.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/application/bench.hpp"
#include "tests/application/end_to_end.hpp"
#include "tests/application/roll_plane_vehicle.hpp"

namespace testing_application {
namespace {

// Three seconds with everything in it: unavailable, a hard turn, silence.
std::vector<Cycle> eventful_run() {
    Bench bench;
    bench.run_for(0.5);
    RollPlaneVehicle vehicle{large_suv()};
    bench.drive([&vehicle](double) {
        vehicle.advance(8.0);
        return vehicle.motion();
    });
    bench.run_for(1.0);
    bench.drive(Motion{});
    bench.stop_all();
    bench.run_for(0.5);
    bench.resume_all();
    bench.run_for(1.0);
    return bench.cycles();
}

TEST(EachCycle, SendsTheWarningFirstAndTheStatusLast) {
    constexpr auto expected = rsi::can_dbc::MessagesFromRolloverEcu::identifiers;
    ASSERT_EQ(expected.front(), rsi::can_dbc::RolloverWarning::identifier);
    ASSERT_EQ(expected.back(), rsi::can_dbc::RolloverStatus::identifier);
    for (const Cycle& cycle : eventful_run()) {
        ASSERT_EQ(cycle.frames.size(), expected.size());
        for (std::size_t index = 0U; index < expected.size(); ++index) {
            const rsi::hal::CanFrame& frame = cycle.frames[index];
            ASSERT_EQ(frame.identifier, expected[index]);
            ASSERT_EQ(frame.length, 8U);
            ASSERT_FALSE(frame.extended);
            ASSERT_FALSE(frame.flexible_data_rate);
        }
    }
}

TEST(EachSentFrame, PassesAnIndependentEndToEndCheckAndCountsFrom0To14) {
    unsigned counter = 0U;
    for (const Cycle& cycle : eventful_run()) {
        std::size_t index = 0U;
        rsi::can_dbc::MessagesFromRolloverEcu::visit([&](auto type) {
            using Message = typename decltype(type)::Type;
            const rsi::hal::CanFrame& frame = cycle.frames.at(index++);
            ASSERT_TRUE(is_profile_11(frame, Message::e2e_data_id)) << Message::name;
            ASSERT_EQ(counter_of(frame), counter) << Message::name;
        });
        counter = (counter + 1U) % 15U;
    }
}

// For a platform that shows or records what the cycle computed.
TEST(EachCycle, LeavesWhatItHasSentToBeRead) {
    rsi::hal::VirtualClock clock;
    rsi::hal::MemoryBus<2U> bus{clock};
    NoWatchdog watchdog;
    rsi::application::RolloverEcu ecu{bus.endpoint(0U), clock, watchdog};
    ASSERT_EQ(ecu.init(large_suv()).accepted, 1);
    const rsi::can_dbc::Imu imu{0.5F, 9.80665F, 1.0F};
    auto payload = rsi::can_dbc::encode(imu);
    const rsi::can_dbc::RollAngle roll{1.0F, rsi::can_dbc::not_available};
    auto roll_payload = rsi::can_dbc::encode(roll);
    rsi::can_dbc::e2e::protect_profile_11(payload, rsi::can_dbc::Imu::e2e_data_id, 0U);
    rsi::can_dbc::e2e::protect_profile_11(roll_payload, rsi::can_dbc::RollAngle::e2e_data_id, 0U);
    for (const auto& [identifier, bytes] : {std::pair{rsi::can_dbc::Imu::identifier, payload},
                                            std::pair{rsi::can_dbc::RollAngle::identifier, roll_payload}}) {
        rsi::hal::CanFrame frame{};
        frame.identifier = identifier;
        frame.length = 8U;
        std::copy(bytes.begin(), bytes.end(), frame.data.begin());
        bus.endpoint(1U).send(frame);
    }
    ecu.step(0U);
    rsi::hal::CanFrame sent{};
    bus.endpoint(1U).receive(sent);
    ASSERT_EQ(sent.identifier, rsi::can_dbc::RolloverWarning::identifier);
    const auto warning = rsi::can_dbc::decode<rsi::can_dbc::RolloverWarning>(sent.data);
    EXPECT_EQ(ecu.outputs().roll_source, RSI_ROLL_SENSOR);
    EXPECT_NEAR(warning.value.lateral_acceleration_mps2, ecu.outputs().lateral_acceleration_mps2, 0.005F);
    EXPECT_NE(ecu.outputs().lateral_acceleration_mps2, 0.0F);
    EXPECT_EQ(static_cast<int>(warning.value.state), static_cast<int>(ecu.outputs().state));
}

TEST(EachSentStatus, BearsTheSoftwaresVersion) {
    for (const Cycle& cycle : eventful_run()) {
        ASSERT_TRUE(cycle.status.status.all_valid());
        ASSERT_EQ(cycle.status.value.software_version >> 4U, RSI_EXPECTED_MAJOR);
        ASSERT_EQ(cycle.status.value.software_version & 15U, RSI_EXPECTED_MINOR);
    }
}

TEST(TheHeader, BearsTheProjectsVersion) {
    EXPECT_STREQ(RSI_VERSION, RSI_EXPECTED_VERSION);
    EXPECT_EQ(RSI_VERSION_MAJOR, RSI_EXPECTED_MAJOR);
    EXPECT_EQ(RSI_VERSION_MINOR, RSI_EXPECTED_MINOR);
    EXPECT_EQ(RSI_VERSION_PATCH, RSI_EXPECTED_PATCH);
}

TEST(TheLoadsFrame, CarriesWhatTheComponentHasLearnt) {
    Bench bench;
    Motion turn;
    turn.imu.lateral_acceleration_mps2 = 3.0F;
    turn.roll_angle.roll_angle_deg = 3.0F;
    bench.drive(turn);
    bench.run_for(2.0);
    const auto sent = std::find_if(bench.last().frames.begin(), bench.last().frames.end(),
                                   [](const rsi::hal::CanFrame& frame) {
                                       return frame.identifier == rsi::can_dbc::LearntLoad::identifier;
                                   });
    ASSERT_NE(sent, bench.last().frames.end());
    const rsi::can_dbc::LearntLoad load = rsi::can_dbc::decode<rsi::can_dbc::LearntLoad>(sent->data).value;
    ASSERT_GT(std::fabs(bench.outputs().load_excess), 0.001F);
    EXPECT_NEAR(load.load_excess, bench.outputs().load_excess, 0.0006F);
    EXPECT_NEAR(load.load_excess_deviation, bench.outputs().load_excess_deviation, 0.0002F);
}

// In the cycle in which the component says so; in the next the monitoring takes the sensor out.
TEST(TheObserversFrame, SaysThatTheRollSensorContradictsTheObserver) {
    Bench bench;
    bench.drive([noise = 0.05F](double time_s) mutable {
        Motion motion;
        noise = -noise;
        motion.imu.roll_rate_deg_per_s = noise;
        motion.roll_angle.roll_angle_deg = static_cast<float>(2.0 * std::clamp(time_s - 1.0, 0.0, 2.0));
        return motion;
    });
    bench.run_for(4.0);
    int said = 0;
    for (const Cycle& cycle : bench.cycles()) {
        for (const rsi::hal::CanFrame& frame : cycle.frames) {
            if (frame.identifier == rsi::can_dbc::RollObserver::identifier) {
                const auto observer = rsi::can_dbc::decode<rsi::can_dbc::RollObserver>(frame.data).value;
                said += observer.roll_sensor_disagrees ? 1 : 0;
            }
        }
    }
    EXPECT_GE(said, 1);
    EXPECT_EQ(bench.last().diagnosis.value.code,
              rsi::can_dbc::RolloverDiagnosis::Code::roll_sensor_contradicts_observer);
}

}  // namespace
}  // namespace testing_application
