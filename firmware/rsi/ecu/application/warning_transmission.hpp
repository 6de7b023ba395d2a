// Warning transmission: from the component's outputs to protected frames on the bus.
#pragma once

#include "rsi/language.hpp"

#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/application/parameter_section.hpp"
#include "rsi/ecu/application/section_authority.hpp"
#include "rsi/ecu/application/sensor_reception.hpp"
#include "rsi/ecu/monitoring/degradation.hpp"
#include "rsi/ecu/monitoring/diagnostic_memory.hpp"
#include "rsi/hal/can_bus.hpp"
#include "rsi/hal/reset_reason.hpp"
#include "rsi/types.hpp"

namespace rsi::application {

// Health of platform and application in one cycle.
struct Health {
    ParametersRefusal parameters_refusal{ParametersRefusal::missing};  // those in use, or the stored section
    bool parameters_invalid{true};
    bool receive_overflow{false};
    bool bus_error{false};
    bool cycle_overrun{false};         // this cycle began late
    std::uint32_t cycle_overruns{0U};  // since the start
    hal::ResetReason reset_reason{};   // of the last start
    Protection protection{Protection::unsealed};
    ReceptionReport reception{};
    monitoring::Degradation degradation{};
    monitoring::DiagnosticRecord diagnosis{};  // the code that this cycle's RolloverDiagnosis carries
};

class WarningTransmission {
 public:
    // Sends all frames of the ECU in the order of the DBC file: the warning first, because it is the most
    // urgent, and the status last, so that it marks the end of the cycle's frames. A frame that the bus does
    // not take is not repeated, because the next cycle's is newer.
    void send(hal::CanBus& bus, const rsi::Outputs& outputs, const Health& health) noexcept;

 private:
    template <typename Message>
    struct SenderOf {
        can_dbc::e2e::Profile11Sender sender{Message::e2e_data_id};
    };

    template <typename List>
    class Senders;

    template <typename... Messages>
    class Senders<can_dbc::MessageList<Messages...>> : private SenderOf<Messages>... {
     public:
        void send(hal::CanBus& bus, const rsi::Outputs& outputs, const Health& health) noexcept;
    };

    Senders<can_dbc::MessagesFromRolloverEcu> senders_{};
};

}  // namespace rsi::application
