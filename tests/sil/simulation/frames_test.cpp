// Sensor frames and ECU frames: what is said is what is understood, and nothing that was tampered with.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "sil/simulation/ecu_frames.hpp"
#include "sil/simulation/sensor_frames.hpp"
#include "tests/application/end_to_end.hpp"

namespace testing_simulation {
namespace {

using testing_application::is_profile_11;
using testing_application::protect;

class SensorFrames : public ::testing::Test {
 protected:
    std::vector<rsi::hal::CanFrame> sent(const sil::SensorSample& sample) {
        frames.send(bus.endpoint(0U), sample);
        std::vector<rsi::hal::CanFrame> received;
        rsi::hal::CanFrame frame;
        while (bus.endpoint(1U).receive(frame) == rsi::hal::ReceiveResult::frame) {
            received.push_back(frame);
        }
        return received;
    }

    rsi::hal::VirtualClock clock;
    rsi::hal::MemoryBus<2U> bus{clock};
    sil::SensorFrames frames;
};

TEST_F(SensorFrames, CarryASampleInTheUnitsOfTheDatabase) {
    sil::SensorSample sample;
    sample.lateral_acceleration_mps2 = -7.25;
    sample.vertical_acceleration_mps2 = 9.5;
    sample.roll_rate_radps = 0.35;
    sample.roll_angle_rad = -0.11;
    sample.bank_angle_rad = 0.07;
    sample.speed_mps = 30.5;
    sample.yaw_rate_radps = -0.42;
    sample.steering_wheel_angle_rad = 5.0;
    const std::vector<rsi::hal::CanFrame> received = sent(sample);
    ASSERT_EQ(received.size(), 3U);
    EXPECT_EQ(frames.frames_sent(), 3U);

    const auto imu = rsi::can_dbc::decode<rsi::can_dbc::Imu>(received[0].data).value;
    EXPECT_EQ(received[0].identifier, 0x120U);
    EXPECT_NEAR(static_cast<double>(imu.lateral_acceleration_mps2), -7.25, 0.001);
    EXPECT_NEAR(static_cast<double>(imu.vertical_acceleration_mps2), 9.5, 0.001);
    EXPECT_NEAR(static_cast<double>(imu.roll_rate_deg_per_s), 20.0535, 0.005);

    const auto roll = rsi::can_dbc::decode<rsi::can_dbc::RollAngle>(received[1].data).value;
    EXPECT_EQ(received[1].identifier, 0x121U);
    EXPECT_NEAR(static_cast<double>(roll.roll_angle_deg), -6.3025, 0.0025);
    EXPECT_NEAR(static_cast<double>(roll.bank_angle_deg), 4.0107, 0.0025);

    const auto motion = rsi::can_dbc::decode<rsi::can_dbc::VehicleMotion>(received[2].data).value;
    EXPECT_EQ(received[2].identifier, 0x122U);
    EXPECT_NEAR(static_cast<double>(motion.speed_kmh), 109.8, 0.005);
    EXPECT_NEAR(static_cast<double>(motion.yaw_rate_deg_per_s), -24.0642, 0.005);
    EXPECT_NEAR(static_cast<double>(motion.steering_wheel_angle_deg), 286.4789, 0.05);
}

TEST_F(SensorFrames, CarryTheVehiclesMassWhereItIsKnown) {
    sil::SensorSample sample;
    sample.vehicle_mass_kg = 2734.0;
    const std::vector<rsi::hal::CanFrame> received = sent(sample);
    ASSERT_EQ(received.size(), 4U);
    EXPECT_EQ(received[3].identifier, 0x123U);
    EXPECT_TRUE(is_profile_11(received[3], 0xEA1U));
    EXPECT_EQ(rsi::can_dbc::decode<rsi::can_dbc::VehicleMass>(received[3].data).value.mass_kg, 2730.0F);
}

TEST_F(SensorFrames, SayNotAvailableForWhatASampleLacks) {
    sil::SensorSample sample;
    sample.lateral_acceleration_mps2 = 1.0;
    const std::vector<rsi::hal::CanFrame> received = sent(sample);
    const auto imu = rsi::can_dbc::decode<rsi::can_dbc::Imu>(received.at(0).data).status;
    EXPECT_EQ(imu.lateral_acceleration_mps2, rsi::can_dbc::SignalStatus::valid);
    EXPECT_EQ(imu.roll_rate_deg_per_s, rsi::can_dbc::SignalStatus::not_available);
    const auto roll = rsi::can_dbc::decode<rsi::can_dbc::RollAngle>(received.at(1).data).status;
    EXPECT_EQ(roll.roll_angle_deg, rsi::can_dbc::SignalStatus::not_available);
    EXPECT_EQ(roll.bank_angle_deg, rsi::can_dbc::SignalStatus::not_available);
}

TEST_F(SensorFrames, PassAnIndependentEndToEndCheckAndCount) {
    for (unsigned cycle = 0U; cycle < 40U; ++cycle) {
        const std::vector<rsi::hal::CanFrame> received = sent(sil::SensorSample{});
        const std::uint16_t data_ids[] = {0x3A7U, 0x45CU, 0x5B1U};
        for (std::size_t index = 0U; index < 3U; ++index) {
            ASSERT_TRUE(is_profile_11(received.at(index), data_ids[index]));
            ASSERT_EQ(testing_application::counter_of(received[index]), cycle % 15U);
        }
    }
}

TEST_F(SensorFrames, AreReadBackAsTheSampleSent) {
    sil::SensorSample sample;
    sample.lateral_acceleration_mps2 = -7.25;
    sample.roll_angle_rad = -0.11;
    sample.speed_mps = 30.5;
    sample.vehicle_mass_kg = 2730.0;
    sil::SensorSample read;
    for (const rsi::hal::CanFrame& frame : sent(sample)) {
        sil::take_sensor_frame(frame, read);
    }
    EXPECT_NEAR(read.lateral_acceleration_mps2, -7.25, 0.001);
    EXPECT_NEAR(read.roll_angle_rad, -0.11, 0.0001);
    EXPECT_NEAR(read.speed_mps, 30.5, 0.002);
    EXPECT_EQ(read.vehicle_mass_kg, 2730.0);
    EXPECT_TRUE(std::isnan(read.yaw_rate_radps));
}

TEST_F(SensorFrames, OfAnotherLengthOrWithAnExtendedIdentifierAreNotRead) {
    sil::SensorSample sample;
    sample.roll_rate_radps = 0.3;
    const rsi::hal::CanFrame imu = sent(sample).front();
    rsi::hal::CanFrame shorter = imu;
    --shorter.length;
    rsi::hal::CanFrame extended = imu;
    extended.extended = true;
    sil::SensorSample read;
    sil::take_sensor_frame(shorter, read);
    sil::take_sensor_frame(extended, read);
    EXPECT_TRUE(std::isnan(read.roll_rate_radps));
    sil::take_sensor_frame(imu, read);
    EXPECT_NEAR(read.roll_rate_radps, 0.3, 0.0001);
}

TEST_F(SensorFrames, ThatTheBusDoesNotTakeEndTheRunWithAMessage) {
    bus.endpoint(0U).set_state(rsi::hal::BusState::bus_off);
    try {
        frames.send(bus.endpoint(0U), sil::SensorSample{});
        FAIL() << "nothing thrown";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string{error.what()}.find("0x120"), std::string::npos) << error.what();
        EXPECT_NE(std::string{error.what()}.find("ip -details link show"), std::string::npos) << error.what();
    }
}

class EcuFrames : public ::testing::Test {
 protected:
    template <typename Message>
    static rsi::hal::CanFrame frame_of(const Message& message, unsigned counter) {
        rsi::hal::CanFrame frame = sil::to_frame<Message>(rsi::can_dbc::encode(message));
        protect(frame, Message::e2e_data_id, counter);
        return frame;
    }

    static rsi::can_dbc::RolloverWarning warning_message() {
        rsi::can_dbc::RolloverWarning message;
        message.state = rsi::can_dbc::RolloverWarning::State::warning;
        message.side = rsi::can_dbc::RolloverWarning::Side::left;
        message.warning_level = 0.95F;
        message.lateral_acceleration_mps2 = -6.5F;
        message.lateral_acceleration_threshold_mps2 = -7.0F;
        return message;
    }

    sil::EcuFrames ecu;
};

TEST_F(EcuFrames, AreUnderstoodAsTheyWereMeant) {
    EXPECT_EQ(ecu.take(frame_of(warning_message(), 3U)), sil::EcuFrameKind::warning);
    EXPECT_EQ(ecu.output().state(), sil::WarningState::warning);
    EXPECT_EQ(ecu.output().side(), sil::WarningSide::left);
    EXPECT_NEAR(static_cast<double>(ecu.output().of<rsi::can_dbc::RolloverWarning>().warning_level), 0.95,
                2.5e-4);
    EXPECT_NEAR(
        static_cast<double>(ecu.output().of<rsi::can_dbc::RolloverWarning>().lateral_acceleration_mps2), -6.5,
        2.5e-3);
    EXPECT_NEAR(static_cast<double>(
                    ecu.output().of<rsi::can_dbc::RolloverWarning>().lateral_acceleration_threshold_mps2),
                -7.0, 2.5e-3);

    rsi::can_dbc::RollCentreEstimate estimate;
    estimate.roll_centre_vertical_m = 0.05F;
    estimate.roll_centre_lateral_m = -0.02F;
    estimate.roll_stiffness_deviation_nmprad = 5000.0F;
    EXPECT_EQ(ecu.take(frame_of(estimate, 3U)), sil::EcuFrameKind::estimate);
    EXPECT_NEAR(
        static_cast<double>(ecu.output().of<rsi::can_dbc::RollCentreEstimate>().roll_centre_vertical_m), 0.05,
        2.5e-4);
    EXPECT_NEAR(
        static_cast<double>(ecu.output().of<rsi::can_dbc::RollCentreEstimate>().roll_centre_lateral_m), -0.02,
        2.5e-4);
    EXPECT_NEAR(static_cast<double>(
                    ecu.output().of<rsi::can_dbc::RollCentreEstimate>().roll_stiffness_deviation_nmprad),
                5000.0, 50.0);
    EXPECT_TRUE(
        std::isnan(ecu.output().of<rsi::can_dbc::RollCentreEstimate>().roll_damping_deviation_nmsprad));

    rsi::can_dbc::RollIndicesAhead ahead;
    ahead.predicted_load_transfer_ratio = -0.7F;
    ahead.extended_rsi = 0.6F;
    EXPECT_EQ(ecu.take(frame_of(ahead, 3U)), sil::EcuFrameKind::indices);
    EXPECT_NEAR(
        static_cast<double>(ecu.output().of<rsi::can_dbc::RollIndicesAhead>().predicted_load_transfer_ratio),
        -0.7, 5.0e-4);
    EXPECT_NEAR(static_cast<double>(ecu.output().of<rsi::can_dbc::RollIndicesAhead>().extended_rsi), 0.6,
                2.5e-4);
    EXPECT_TRUE(std::isnan(ecu.output().of<rsi::can_dbc::RollIndicesAhead>().predicted_rsi));

    rsi::can_dbc::RollIndicesClassic classic;
    classic.energy_margin = -0.25F;
    classic.time_to_rollover_s = 1.2F;
    EXPECT_EQ(ecu.take(frame_of(classic, 3U)), sil::EcuFrameKind::indices);
    EXPECT_NEAR(static_cast<double>(ecu.output().of<rsi::can_dbc::RollIndicesClassic>().energy_margin), -0.25,
                5.0e-3);
    EXPECT_NEAR(static_cast<double>(ecu.output().of<rsi::can_dbc::RollIndicesClassic>().time_to_rollover_s),
                1.2, 0.02);
    EXPECT_TRUE(std::isnan(ecu.output().of<rsi::can_dbc::RollIndicesClassic>().rollover_index));

    rsi::can_dbc::RollObserver observer;
    observer.observed_bank_angle_deg = -6.0F;
    observer.roll_source = rsi::can_dbc::RollObserver::RollSource::observer;
    observer.roll_sensor_disagrees = true;
    EXPECT_EQ(ecu.take(frame_of(observer, 3U)), sil::EcuFrameKind::observer);
    EXPECT_NEAR(static_cast<double>(ecu.output().of<rsi::can_dbc::RollObserver>().observed_bank_angle_deg),
                -6.0, 0.0125);
    EXPECT_EQ(ecu.output().of<rsi::can_dbc::RollObserver>().roll_source, sil::RollSource::observer);
    EXPECT_TRUE(ecu.output().of<rsi::can_dbc::RollObserver>().roll_sensor_disagrees);
    EXPECT_FALSE(ecu.output().of<rsi::can_dbc::RollObserver>().estimate_frozen);

    rsi::can_dbc::RolloverStatus status;
    status.imu_timeout = true;
    status.frames_lost = 12U;
    EXPECT_EQ(ecu.take(frame_of(status, 3U)), sil::EcuFrameKind::status);
    EXPECT_TRUE(ecu.status().imu_timeout);
    EXPECT_EQ(ecu.status().frames_lost, 12U);
    EXPECT_EQ(ecu.frames_received(), 6U);
    EXPECT_EQ(ecu.frames_refused(), 0U);
}

TEST_F(EcuFrames, WithAnyBitTurnedAreRefusedAndChangeNothing) {
    for (unsigned bit = 0U; bit < 64U; ++bit) {
        rsi::hal::CanFrame frame = frame_of(warning_message(), 0U);
        frame.data[bit / 8U] = static_cast<std::uint8_t>(frame.data[bit / 8U] ^ (1U << (bit % 8U)));
        EXPECT_EQ(ecu.take(frame), sil::EcuFrameKind::refused) << bit;
    }
    EXPECT_EQ(ecu.output().state(), sil::WarningState::unavailable);
    EXPECT_EQ(ecu.frames_refused(), 64U);
    EXPECT_EQ(ecu.frames_received(), 0U);
}

TEST_F(EcuFrames, OfAnotherLengthOrARepeatedCounterAreRefused) {
    for (unsigned length = 0U; length < 8U; ++length) {
        rsi::hal::CanFrame frame = frame_of(warning_message(), 0U);
        frame.length = static_cast<std::uint8_t>(length);
        EXPECT_EQ(ecu.take(frame), sil::EcuFrameKind::refused) << length;
    }
    EXPECT_EQ(ecu.take(frame_of(warning_message(), 5U)), sil::EcuFrameKind::warning);
    EXPECT_EQ(ecu.take(frame_of(warning_message(), 5U)), sil::EcuFrameKind::refused);
    EXPECT_EQ(ecu.take(frame_of(warning_message(), 6U)), sil::EcuFrameKind::warning);
}

TEST_F(EcuFrames, OfOtherKindsAndIdentifiersAreForeign) {
    rsi::hal::CanFrame frame = frame_of(warning_message(), 0U);
    frame.extended = true;
    EXPECT_EQ(ecu.take(frame), sil::EcuFrameKind::foreign);
    frame = frame_of(warning_message(), 0U);
    frame.flexible_data_rate = true;
    EXPECT_EQ(ecu.take(frame), sil::EcuFrameKind::foreign);
    EXPECT_EQ(ecu.take(frame_of(rsi::can_dbc::Imu{}, 0U)), sil::EcuFrameKind::foreign);
    EXPECT_EQ(ecu.frames_refused(), 0U);
}

}  // namespace
}  // namespace testing_simulation
