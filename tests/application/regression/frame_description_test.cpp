// Frames in words, and which of them are of the vehicle's sensors.
#include "tests/application/regression/frame_description.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/application/sensor_reception.hpp"
#include "sil/files/require_accepted.hpp"
#include "sil/files/sensor_frame.hpp"

namespace frame_description_test {
namespace {

rsi::hal::CanFrame frame_of(std::uint32_t identifier, std::uint8_t length) {
    rsi::hal::CanFrame frame;
    frame.identifier = identifier;
    frame.length = length;
    return frame;
}

// 500 of 0.002 m/s^2; the raw value that stands for "not available"; one beyond the range.
TEST(FrameDescription, HasEachSignalWithItsUnit) {
    rsi::hal::CanFrame imu = frame_of(0x120U, 8U);
    imu.data = {0x00U, 0x00U, 0xF4U, 0x01U, 0x00U, 0x80U, 0xFFU, 0x7FU};
    EXPECT_EQ(sil::describe_frame(imu),
              "Imu LateralAcceleration=1 m/s^2 VerticalAcceleration=(not available) RollRate=(out of range)");
}

TEST(FrameDescription, HasNamesOfStatesAndNoUnitWhereThereIsNone) {
    const auto warning = rsi::can_dbc::RolloverWarning{}.encode();
    rsi::hal::CanFrame frame =
        frame_of(rsi::can_dbc::RolloverWarning::identifier, rsi::can_dbc::RolloverWarning::length);
    std::copy(warning.begin(), warning.end(), frame.data.begin());
    const std::string text = sil::describe_frame(frame);
    EXPECT_EQ(text.substr(0U, text.find(" ParametersRefusal")),
              "RolloverWarning State=unavailable Side=none");
    EXPECT_EQ(text.find(" -"), std::string::npos) << text;
}

TEST(FrameDescription, NamesFramesOfTheSimulationToo) {
    EXPECT_EQ(sil::describe_frame(frame_of(0x7F0U, 4U)), "SimulationSync CycleNumber=0");
}

TEST(FrameDescription, OfAnythingElseIsEmpty) {
    EXPECT_EQ(sil::describe_frame(frame_of(0x7FFU, 8U)), "");
    EXPECT_EQ(sil::describe_frame(frame_of(0x120U, 7U)), "");
    EXPECT_EQ(sil::describe_frame(frame_of(0x7F0U, 8U)), "");
    rsi::hal::CanFrame extended = frame_of(0x120U, 8U);
    extended.extended = true;
    EXPECT_EQ(sil::describe_frame(extended), "");
}

TEST(SensorFrame, IsOneThatTheEcuReceives) {
    for (const std::uint32_t identifier : rsi::application::received_identifiers) {
        rsi::hal::CanFrame frame = frame_of(identifier, 8U);
        EXPECT_TRUE(sil::is_sensor_frame(frame)) << identifier;
        frame.extended = true;
        EXPECT_FALSE(sil::is_sensor_frame(frame)) << identifier;
    }
    EXPECT_FALSE(sil::is_sensor_frame(frame_of(0x0D0U, 8U))) << "of the ECU itself";
    EXPECT_FALSE(sil::is_sensor_frame(frame_of(0x7FFU, 8U)));
}

TEST(RequireAccepted, NamesWhatIsRefused) {
    rsi::Validation answer{};
    answer.accepted = 1;
    EXPECT_NO_THROW(sil::require_accepted(answer));
    answer.accepted = 0;
    answer.field = "warning_on";
    answer.reason = "is too high";
    try {
        sil::require_accepted(answer);
        ADD_FAILURE() << "was accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "the component refuses its parameter warning_on: is too high");
    }
}

}  // namespace
}  // namespace frame_description_test
