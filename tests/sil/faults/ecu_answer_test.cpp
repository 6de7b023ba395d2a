// The ear on the bus notices frames that are missing, damaged, doubled, or hold a code that nothing defines.
#include "sil/studies/faults/ecu_answer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "can_dbc/codec/message.hpp"
#include "can_dbc/e2e/profile_11.hpp"
#include "sil/world/simulation/sensor_frames.hpp"
#include "tests/sil/faults/recorded_frames.hpp"

namespace faults_test {
namespace {

using Diagnosis = can_dbc::RolloverDiagnosis;

template <typename Message>
hal::CanFrame frame_of(const Message& message) {
    auto payload = can_dbc::encode(message);
    can_dbc::e2e::protect_profile_11(payload, Message::e2e_data_id, 0U);
    return sil::to_frame<Message>(payload);
}

Diagnosis diagnosis(Diagnosis::Code code, Diagnosis::CodeStatus status) {
    Diagnosis message;
    message.code = code;
    message.code_status = status;
    return message;
}

std::vector<hal::CanFrame> all_frames(const Diagnosis& message = {}) {
    return {frame_of(can_dbc::RolloverWarning{}),  frame_of(can_dbc::RollCentreEstimate{}),
            frame_of(can_dbc::RollIndicesAhead{}), frame_of(can_dbc::RollIndicesClassic{}),
            frame_of(can_dbc::RollObserver{}),     frame_of(message),
            frame_of(can_dbc::RolloverStatus{})};
}

sil::EcuAnswer heard(sil::EcuEar& ear, const std::vector<hal::CanFrame>& frames) {
    RecordedFrames bus;
    bus.frames = frames;
    return ear.listen(bus);
}

sil::EcuAnswer heard(const std::vector<hal::CanFrame>& frames) {
    sil::EcuEar ear;
    return heard(ear, frames);
}

TEST(EcuEar, HearsACompleteCycle) {
    const sil::EcuAnswer answer = heard(all_frames());
    EXPECT_TRUE(answer.complete);
    EXPECT_TRUE(answer.defined);
    EXPECT_EQ(answer.codes, 0U);
}

TEST(EcuEar, NoticesAMissingADoubledAndADamagedFrame) {
    for (std::size_t index = 0U; index < all_frames().size(); ++index) {
        std::vector<hal::CanFrame> missing = all_frames();
        missing.erase(missing.begin() + static_cast<std::ptrdiff_t>(index));
        EXPECT_FALSE(heard(missing).complete) << index;
        std::vector<hal::CanFrame> doubled = all_frames();
        doubled.push_back(doubled[index]);
        EXPECT_FALSE(heard(doubled).complete) << index;
        std::vector<hal::CanFrame> damaged = all_frames();
        damaged[index].data[5] ^= 1U;
        EXPECT_FALSE(heard(damaged).complete) << index;
    }
}

TEST(EcuEar, NoticesAnUndefinedCode) {
    auto payload = can_dbc::encode(can_dbc::RolloverWarning{});
    payload[2] = static_cast<std::uint8_t>(payload[2] | 0x07U);  // State 7
    can_dbc::e2e::protect_profile_11(payload, can_dbc::RolloverWarning::e2e_data_id, 0U);
    std::vector<hal::CanFrame> frames = all_frames();
    frames[0] = sil::to_frame<can_dbc::RolloverWarning>(payload);
    EXPECT_TRUE(heard(frames).complete);
    EXPECT_FALSE(heard(frames).defined);
}

TEST(EcuEar, RemembersConfirmedCodesUntilTheyHeal) {
    using Code = Diagnosis::Code;
    using Status = Diagnosis::CodeStatus;
    sil::EcuEar ear;
    EXPECT_EQ(heard(ear, all_frames(diagnosis(Code::imu_lost, Status::set))).codes, 0U);
    heard(ear, all_frames(diagnosis(Code::imu_lost, Status::confirmed)));
    const sil::EcuAnswer both = heard(ear, all_frames(diagnosis(Code::bus_error, Status::confirmed)));
    EXPECT_THAT(sil::diagnostic_names(both.codes), testing::ElementsAre("imu lost", "bus error"));
    const sil::EcuAnswer one = heard(ear, all_frames(diagnosis(Code::imu_lost, Status::healed)));
    EXPECT_THAT(sil::diagnostic_names(one.codes), testing::ElementsAre("bus error"));
}

}  // namespace
}  // namespace faults_test
