#include "sil/simulation/ecu_frames.hpp"

#include "rsi/can_dbc/codec/message.hpp"

namespace sil {
namespace {

// A frame of the ECU that is not named here carries indices.
template <typename Message>
constexpr EcuFrameKind kind_of = EcuFrameKind::indices;
template <>
constexpr EcuFrameKind kind_of<rsi::can_dbc::RolloverWarning> = EcuFrameKind::warning;
template <>
constexpr EcuFrameKind kind_of<rsi::can_dbc::RollCentreEstimate> = EcuFrameKind::estimate;
template <>
constexpr EcuFrameKind kind_of<rsi::can_dbc::RollObserver> = EcuFrameKind::observer;
template <>
constexpr EcuFrameKind kind_of<rsi::can_dbc::RolloverDiagnosis> = EcuFrameKind::diagnosis;
template <>
constexpr EcuFrameKind kind_of<rsi::can_dbc::RolloverStatus> = EcuFrameKind::status;

}  // namespace

template <typename Message>
EcuFrameKind EcuFrames::take_as(const rsi::hal::CanFrame& frame) {
    const rsi::can_dbc::e2e::CheckResult check =
        std::get<ReceiverOf<Message>>(receivers_.all).receiver.check(frame.data, frame.length);
    if (!rsi::can_dbc::e2e::is_usable(check.status)) {
        ++frames_refused_;
        return EcuFrameKind::refused;
    }
    ++frames_received_;
    output_.of<Message>() = rsi::can_dbc::decode<Message>(frame.data).value;
    return kind_of<Message>;
}

EcuFrameKind EcuFrames::take(const rsi::hal::CanFrame& frame) {
    EcuFrameKind kind = EcuFrameKind::foreign;
    if (frame.extended || frame.flexible_data_rate) {
        return kind;
    }
    rsi::can_dbc::MessagesFromRolloverEcu::visit([&](auto type) {
        using Message = typename decltype(type)::Type;
        if (frame.identifier == Message::identifier) {
            kind = take_as<Message>(frame);
        }
    });
    return kind;
}

}  // namespace sil
