// Reading the ECU's frames shows which are missing, damaged, doubled, or hold a code that nothing defines.
#include "sil/studies/faults/ecu_answer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/ecu/monitoring/diagnostic_code.hpp"
#include "sil/simulation/sensor_frames.hpp"
#include "tests/sil/faults/recorded_frames.hpp"

namespace faults_test {
namespace {

using Diagnosis = rsi::can_dbc::RolloverDiagnosis;

template <typename Message>
rsi::hal::CanFrame frame_of(const Message& message) {
    auto payload = rsi::can_dbc::encode(message);
    rsi::can_dbc::e2e::protect_profile_11(payload, Message::e2e_data_id, 0U);
    return sil::to_frame<Message>(payload);
}

Diagnosis diagnosis(Diagnosis::Code code, Diagnosis::CodeStatus status) {
    Diagnosis message;
    message.code = code;
    message.code_status = status;
    return message;
}

std::vector<rsi::hal::CanFrame> all_frames(const Diagnosis& message = {}) {
    std::vector<rsi::hal::CanFrame> frames;
    rsi::can_dbc::MessagesFromRolloverEcu::visit([&](auto type) {
        using Message = typename decltype(type)::Type;
        if constexpr (std::is_same_v<Message, Diagnosis>) {
            frames.push_back(frame_of(message));
        } else {
            frames.push_back(frame_of(Message{}));
        }
    });
    return frames;
}

sil::EcuAnswer answer_to(sil::EcuAnswerReader& reader, const std::vector<rsi::hal::CanFrame>& frames) {
    RecordedFrames bus;
    bus.frames = frames;
    return reader.read(bus);
}

sil::EcuAnswer answer_to(const std::vector<rsi::hal::CanFrame>& frames) {
    sil::EcuAnswerReader reader;
    return answer_to(reader, frames);
}

TEST(EcuAnswerReader, ReadsACompleteCycle) {
    const sil::EcuAnswer answer = answer_to(all_frames());
    EXPECT_TRUE(answer.complete);
    EXPECT_TRUE(answer.defined);
    EXPECT_TRUE(answer.codes.none());
}

TEST(EcuAnswerReader, NoticesAMissingADoubledAndADamagedFrame) {
    for (std::size_t index = 0U; index < all_frames().size(); ++index) {
        std::vector<rsi::hal::CanFrame> missing = all_frames();
        missing.erase(missing.begin() + static_cast<std::ptrdiff_t>(index));
        EXPECT_FALSE(answer_to(missing).complete) << index;
        std::vector<rsi::hal::CanFrame> doubled = all_frames();
        doubled.push_back(doubled[index]);
        EXPECT_FALSE(answer_to(doubled).complete) << index;
        std::vector<rsi::hal::CanFrame> damaged = all_frames();
        damaged[index].data[5] ^= 1U;
        EXPECT_FALSE(answer_to(damaged).complete) << index;
    }
}

TEST(EcuAnswerReader, NoticesAnUndefinedCode) {
    auto payload = rsi::can_dbc::encode(rsi::can_dbc::RolloverWarning{});
    payload[2] = static_cast<std::uint8_t>(payload[2] | 0x07U);  // State 7
    rsi::can_dbc::e2e::protect_profile_11(payload, rsi::can_dbc::RolloverWarning::e2e_data_id, 0U);
    std::vector<rsi::hal::CanFrame> frames = all_frames();
    frames[0] = sil::to_frame<rsi::can_dbc::RolloverWarning>(payload);
    EXPECT_TRUE(answer_to(frames).complete);
    EXPECT_FALSE(answer_to(frames).defined);
}

TEST(EcuAnswerReader, TellsEachCodeByItsName) {
    const auto last = static_cast<unsigned>(rsi::monitoring::diagnostic_code_count);
    for (unsigned raw = 1U; raw < last; ++raw) {
        const auto code = static_cast<Diagnosis::Code>(raw);
        const sil::EcuAnswer answer =
            answer_to(all_frames(diagnosis(code, Diagnosis::CodeStatus::confirmed)));
        EXPECT_THAT(sil::diagnostic_names(answer.codes), testing::ElementsAre(Diagnosis::name_of(code)));
    }
}

TEST(EcuAnswerReader, RemembersConfirmedCodesUntilTheyHeal) {
    using Code = Diagnosis::Code;
    using Status = Diagnosis::CodeStatus;
    sil::EcuAnswerReader reader;
    EXPECT_TRUE(answer_to(reader, all_frames(diagnosis(Code::imu_lost, Status::set))).codes.none());
    answer_to(reader, all_frames(diagnosis(Code::imu_lost, Status::confirmed)));
    const sil::EcuAnswer both = answer_to(reader, all_frames(diagnosis(Code::bus_error, Status::confirmed)));
    EXPECT_THAT(sil::diagnostic_names(both.codes), testing::ElementsAre("imu lost", "bus error"));
    const sil::EcuAnswer one = answer_to(reader, all_frames(diagnosis(Code::imu_lost, Status::healed)));
    EXPECT_THAT(sil::diagnostic_names(one.codes), testing::ElementsAre("bus error"));
}

}  // namespace
}  // namespace faults_test
