#include "sil/world/simulation/ecu_frames.hpp"

#include "can_dbc/codec/message.hpp"
#include "sil/units.hpp"

namespace sil {

template <typename Message>
EcuFrameKind EcuFrames::take_as(EcuFrameKind kind, const hal::CanFrame& frame,
                                can_dbc::e2e::Profile11Receiver& receiver) {
    const can_dbc::e2e::CheckResult check = receiver.check(frame.data, frame.length);
    if (!can_dbc::e2e::is_usable(check.status)) {
        ++frames_refused_;
        return EcuFrameKind::refused;
    }
    ++frames_received_;
    keep(can_dbc::decode<Message>(frame.data).value);
    return kind;
}

EcuFrameKind EcuFrames::take(const hal::CanFrame& frame) {
    using namespace can_dbc;
    if (frame.extended || frame.flexible_data_rate) {
        return EcuFrameKind::foreign;
    }
    switch (frame.identifier) {
        case RolloverWarning::identifier:
            return take_as<RolloverWarning>(EcuFrameKind::warning, frame, warning_receiver_);
        case RollCentreEstimate::identifier:
            return take_as<RollCentreEstimate>(EcuFrameKind::estimate, frame, estimate_receiver_);
        case RollIndicesAhead::identifier:
            return take_as<RollIndicesAhead>(EcuFrameKind::indices, frame, indices_ahead_receiver_);
        case RollIndicesClassic::identifier:
            return take_as<RollIndicesClassic>(EcuFrameKind::indices, frame, indices_classic_receiver_);
        case RollObserver::identifier:
            return take_as<RollObserver>(EcuFrameKind::observer, frame, observer_receiver_);
        case RolloverDiagnosis::identifier:
            return take_as<RolloverDiagnosis>(EcuFrameKind::diagnosis, frame, diagnosis_receiver_);
        case RolloverStatus::identifier:
            return take_as<RolloverStatus>(EcuFrameKind::status, frame, status_receiver_);
        default:
            return EcuFrameKind::foreign;
    }
}

void EcuFrames::keep(const can_dbc::RolloverWarning& message) {
    output_.state = static_cast<WarningState>(message.state);
    output_.side = static_cast<WarningSide>(message.side);
    output_.roll_stability_indicator = static_cast<double>(message.roll_stability_indicator);
    output_.lateral_acceleration_mps2 = static_cast<double>(message.lateral_acceleration_mps2);
    output_.lateral_acceleration_threshold_mps2 =
        static_cast<double>(message.lateral_acceleration_threshold_mps2);
}

void EcuFrames::keep(const can_dbc::RollCentreEstimate& message) {
    output_.roll_centre_vertical_movement_m = static_cast<double>(message.vertical_movement_m);
    output_.roll_centre_lateral_movement_m = static_cast<double>(message.lateral_movement_m);
    output_.roll_stiffness_deviation_nmprad =
        static_cast<double>(message.roll_stiffness_deviation_n_m_per_rad);
    output_.roll_damping_deviation_nmsprad =
        static_cast<double>(message.roll_damping_deviation_n_m_s_per_rad);
}

void EcuFrames::keep(const can_dbc::RollIndicesAhead& message) {
    output_.predicted_load_transfer_ratio = static_cast<double>(message.predicted_load_transfer_ratio);
    output_.predicted_rsi = static_cast<double>(message.predicted_rsi);
    output_.load_transfer_ratio = static_cast<double>(message.load_transfer_ratio);
    output_.extended_rsi = static_cast<double>(message.extended_rsi);
}

void EcuFrames::keep(const can_dbc::RollIndicesClassic& message) {
    output_.published_rsi = static_cast<double>(message.published_rsi);
    output_.bank_free_rsi = static_cast<double>(message.bank_free_rsi);
    output_.dynamic_stability_index = static_cast<double>(message.dynamic_stability_index);
    output_.energy_margin = static_cast<double>(message.energy_margin);
    output_.rollover_index = static_cast<double>(message.rollover_index);
    output_.time_to_rollover_s = static_cast<double>(message.time_to_rollover_s);
}

void EcuFrames::keep(const can_dbc::RollObserver& message) {
    output_.observed_roll_angle_rad =
        static_cast<double>(message.observed_roll_angle_deg) / degrees_per_radian;
    output_.observed_bank_angle_rad =
        static_cast<double>(message.observed_bank_angle_deg) / degrees_per_radian;
    output_.roll_centre_deviation_m = static_cast<double>(message.roll_centre_deviation_m);
    output_.roll_source = static_cast<RollSource>(message.roll_source);
    output_.roll_sensor_disagrees = message.roll_sensor_disagrees;
    output_.estimate_frozen = message.estimate_frozen;
}

}  // namespace sil
