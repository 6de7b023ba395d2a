#include "sil/simulation/ecu_frames.hpp"

#include "can_dbc/codec/message.hpp"

namespace sil {

template <typename Message>
bool EcuFrames::accept(const hal::CanFrame& frame, can_dbc::e2e::Profile11Receiver& receiver,
                       Message& message) {
    const can_dbc::e2e::CheckResult check = receiver.check(frame.data, frame.length);
    if (!can_dbc::e2e::is_usable(check.status)) {
        ++frames_refused_;
        return false;
    }
    ++frames_received_;
    message = can_dbc::decode<Message>(frame.data).value;
    return true;
}

EcuFrameKind EcuFrames::take(const hal::CanFrame& frame) {
    if (frame.extended || frame.flexible_data_rate) {
        return EcuFrameKind::foreign;
    }
    if (frame.identifier == can_dbc::RolloverWarning::identifier) {
        can_dbc::RolloverWarning message;
        if (!accept(frame, warning_receiver_, message)) {
            return EcuFrameKind::refused;
        }
        take_warning(message);
        return EcuFrameKind::warning;
    }
    if (frame.identifier == can_dbc::RollCentreEstimate::identifier) {
        can_dbc::RollCentreEstimate message;
        if (!accept(frame, estimate_receiver_, message)) {
            return EcuFrameKind::refused;
        }
        take_estimate(message);
        return EcuFrameKind::estimate;
    }
    if (frame.identifier == can_dbc::RolloverStatus::identifier) {
        return accept(frame, status_receiver_, status_) ? EcuFrameKind::status : EcuFrameKind::refused;
    }
    return EcuFrameKind::foreign;
}

void EcuFrames::take_warning(const can_dbc::RolloverWarning& message) {
    output_.state = static_cast<WarningState>(message.state);
    output_.side = static_cast<WarningSide>(message.side);
    output_.roll_stability_indicator = static_cast<double>(message.roll_stability_indicator);
    output_.lateral_acceleration_mps2 = static_cast<double>(message.lateral_acceleration_mps2);
    output_.lateral_acceleration_threshold_mps2 =
        static_cast<double>(message.lateral_acceleration_threshold_mps2);
}

void EcuFrames::take_estimate(const can_dbc::RollCentreEstimate& message) {
    output_.roll_centre_vertical_movement_m = static_cast<double>(message.vertical_movement_m);
    output_.roll_centre_lateral_movement_m = static_cast<double>(message.lateral_movement_m);
    output_.roll_stiffness_deviation_nmprad =
        static_cast<double>(message.roll_stiffness_deviation_n_m_per_rad);
    output_.roll_damping_deviation_nmsprad =
        static_cast<double>(message.roll_damping_deviation_n_m_s_per_rad);
}

}  // namespace sil
