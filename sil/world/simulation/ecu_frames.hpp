// ECU frames: what the firmware answers on the bus, checked and decoded.
#pragma once

#include <cstdint>

#include "can_dbc/e2e/profile_11.hpp"
#include "can_dbc/generated/rollover_warning.hpp"
#include "hal/interface/can_bus.hpp"
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
    // Judges one frame and takes over its values. `refused`: an ECU frame that its end-to-end check does not
    // accept.
    EcuFrameKind take(const hal::CanFrame& frame);

    const EcuOutput& output() const { return output_; }
    const can_dbc::RolloverDiagnosis& diagnosis() const { return diagnosis_; }
    const can_dbc::RolloverStatus& status() const { return status_; }
    std::uint64_t frames_received() const { return frames_received_; }
    std::uint64_t frames_refused() const { return frames_refused_; }

 private:
    // One frame of this message; `kind` when its end-to-end check accepts it.
    template <typename Message>
    EcuFrameKind take_as(EcuFrameKind kind, const hal::CanFrame& frame,
                         can_dbc::e2e::Profile11Receiver& receiver);
    void keep(const can_dbc::RolloverWarning& message);
    void keep(const can_dbc::RollCentreEstimate& message);
    void keep(const can_dbc::RollIndicesAhead& message);
    void keep(const can_dbc::RollIndicesClassic& message);
    void keep(const can_dbc::RollObserver& message);
    void keep(const can_dbc::RolloverDiagnosis& message) { diagnosis_ = message; }
    void keep(const can_dbc::RolloverStatus& message) { status_ = message; }

    can_dbc::e2e::Profile11Receiver warning_receiver_{can_dbc::RolloverWarning::e2e_data_id,
                                                      can_dbc::RolloverWarning::length, 14U};
    can_dbc::e2e::Profile11Receiver estimate_receiver_{can_dbc::RollCentreEstimate::e2e_data_id,
                                                       can_dbc::RollCentreEstimate::length, 14U};
    can_dbc::e2e::Profile11Receiver indices_ahead_receiver_{can_dbc::RollIndicesAhead::e2e_data_id,
                                                            can_dbc::RollIndicesAhead::length, 14U};
    can_dbc::e2e::Profile11Receiver indices_classic_receiver_{can_dbc::RollIndicesClassic::e2e_data_id,
                                                              can_dbc::RollIndicesClassic::length, 14U};
    can_dbc::e2e::Profile11Receiver observer_receiver_{can_dbc::RollObserver::e2e_data_id,
                                                       can_dbc::RollObserver::length, 14U};
    can_dbc::e2e::Profile11Receiver diagnosis_receiver_{can_dbc::RolloverDiagnosis::e2e_data_id,
                                                        can_dbc::RolloverDiagnosis::length, 14U};
    can_dbc::e2e::Profile11Receiver status_receiver_{can_dbc::RolloverStatus::e2e_data_id,
                                                     can_dbc::RolloverStatus::length, 14U};
    EcuOutput output_{};
    can_dbc::RolloverDiagnosis diagnosis_{};
    can_dbc::RolloverStatus status_{};
    std::uint64_t frames_received_{0U};
    std::uint64_t frames_refused_{0U};
};

}  // namespace sil
