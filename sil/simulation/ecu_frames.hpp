// ECU frames: receiver of the ECU's frames, with end-to-end check and decoding.
#pragma once

#include <cstdint>
#include <tuple>

#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/hal/can_bus.hpp"
#include "sil/results/ecu_output.hpp"

namespace sil {

enum class EcuFrameKind : std::uint8_t {
    foreign,
    refused,
    warning,
    estimate,
    indices,
    observer,
    diagnosis,
    status
};

class EcuFrames {
 public:
    // Checks and decodes one frame. `foreign`: not a frame of the ECU; `refused`: its end-to-end check
    // failed.
    EcuFrameKind take(const rsi::hal::CanFrame& frame);

    const EcuOutput& output() const { return output_; }
    const rsi::can_dbc::RolloverDiagnosis& diagnosis() const {
        return output_.of<rsi::can_dbc::RolloverDiagnosis>();
    }
    const rsi::can_dbc::RolloverStatus& status() const { return output_.of<rsi::can_dbc::RolloverStatus>(); }
    std::uint64_t frames_received() const { return frames_received_; }
    std::uint64_t frames_refused() const { return frames_refused_; }

 private:
    template <typename Message>
    struct ReceiverOf {
        rsi::can_dbc::e2e::Profile11Receiver receiver{Message::e2e_data_id, Message::length, 14U};
    };

    template <typename List>
    struct ReceiversOf;
    template <typename... Messages>
    struct ReceiversOf<rsi::can_dbc::MessageList<Messages...>> {
        std::tuple<ReceiverOf<Messages>...> all{};
    };

    // One frame of this message, which its end-to-end check accepts or not.
    template <typename Message>
    EcuFrameKind take_as(const rsi::hal::CanFrame& frame);

    ReceiversOf<rsi::can_dbc::MessagesFromRolloverEcu> receivers_{};
    EcuOutput output_{};
    std::uint64_t frames_received_{0U};
    std::uint64_t frames_refused_{0U};
};

}  // namespace sil
