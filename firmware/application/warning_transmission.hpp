// Warning transmission: from the component's outputs to protected frames on the bus.
#pragma once

#include "application/parameter_section.hpp"
#include "application/sensor_reception.hpp"
#include "can_dbc/e2e/profile_11.hpp"
#include "can_dbc/generated/rollover_warning.hpp"
#include "hal/interface/can_bus.hpp"
#include "hal/interface/reset_reason.hpp"
#include "monitoring/degradation.hpp"
#include "monitoring/diagnostic_memory.hpp"
#include "rsi/types.hpp"

namespace application {

// What the platform and the application know of their own health.
struct Health {
    ParametersRefusal parameters_refusal{ParametersRefusal::missing};
    bool receive_overflow{false};
    bool bus_error{false};
    bool cycle_overrun{false};         // this cycle began late
    std::uint32_t cycle_overruns{0U};  // since the start
    hal::ResetReason reset_reason{};   // of the last start
    ReceptionReport reception{};
    monitoring::Degradation degradation{};
    monitoring::DiagnosticRecord diagnosis{};  // the one that this cycle tells of
};

class WarningTransmission {
 public:
    // Sends the warning first, because it matters most, and the status last: who has seen the status has seen
    // all of the cycle. A frame that the bus does not take is not repeated; the next cycle's is newer.
    void send(hal::CanBus& bus, const rsi::Outputs& outputs, const Health& health) noexcept;

 private:
    can_dbc::e2e::Profile11Sender warning_{can_dbc::RolloverWarning::e2e_data_id};
    can_dbc::e2e::Profile11Sender estimate_{can_dbc::RollCentreEstimate::e2e_data_id};
    can_dbc::e2e::Profile11Sender indices_ahead_{can_dbc::RollIndicesAhead::e2e_data_id};
    can_dbc::e2e::Profile11Sender indices_classic_{can_dbc::RollIndicesClassic::e2e_data_id};
    can_dbc::e2e::Profile11Sender observer_{can_dbc::RollObserver::e2e_data_id};
    can_dbc::e2e::Profile11Sender diagnosis_{can_dbc::RolloverDiagnosis::e2e_data_id};
    can_dbc::e2e::Profile11Sender status_{can_dbc::RolloverStatus::e2e_data_id};
};

}  // namespace application
