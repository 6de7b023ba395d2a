// Rollover ECU: the application that a platform's main loop calls every 10 ms. Frames in, step, frames out.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rsi/component.hpp"
#include "rsi/ecu/application/load_keeper.hpp"
#include "rsi/ecu/application/parameter_section.hpp"
#include "rsi/ecu/application/section_authority.hpp"
#include "rsi/ecu/application/sensor_reception.hpp"
#include "rsi/ecu/application/warning_transmission.hpp"
#include "rsi/ecu/monitoring/clock_check.hpp"
#include "rsi/ecu/monitoring/diagnostic_memory.hpp"
#include "rsi/ecu/monitoring/input_monitor.hpp"
#include "rsi/ecu/monitoring/memory_guard.hpp"
#include "rsi/ecu/monitoring/parameter_guard.hpp"
#include "rsi/hal/can_bus.hpp"
#include "rsi/hal/clock.hpp"
#include "rsi/hal/reset_reason.hpp"
#include "rsi/hal/storage.hpp"
#include "rsi/hal/watchdog.hpp"

namespace rsi::application {

class RolloverEcu {
 public:
    // All three must outlive the ECU.
    RolloverEcu(hal::CanBus& bus, const hal::Clock& clock, hal::Watchdog& watchdog) noexcept
        : bus_{bus}, clock_{clock}, watchdog_{watchdog} {}

    // Starts the component. When the parameters are refused, the ECU still runs: it sends "unavailable", the
    // diagnostic flag ParametersInvalid and, as ParametersRefusal, why.
    rsi::Validation init(const rsi::Parameters& parameters) noexcept;

    // The same with the parameters of a section of the image, of whose memory `length` bytes may be read.
    ParameterSectionAnswer init(const std::uint8_t* section, std::size_t length) noexcept;

    // Between two cycles: goes on with the parameters of a change that is ready and began from parameters(),
    // as rsi::Component::change says. The checks of the inputs begin anew only where they depend on what has
    // changed. An ECU that has refused its parameters starts with these.
    [[gnu::cold]] void change(const rsi::ParameterChange& change) noexcept;

    // Those in use, as far as they were accepted.
    const rsi::Parameters& parameters() const noexcept { return parameters_; }

    // The same for a platform that takes sealed sections only. The section in use raises the authority's
    // version.
    ParameterSectionAnswer init(const std::uint8_t* section, std::size_t length,
                                SectionAuthority& authority) noexcept;

    // For a platform whose XCP or UDS asks for a key, before init: a public key is reported on the bus.
    void use_keys(const hal::KeyStore& keys) noexcept { has_test_keys_ = keys.has_test_keys(); }

    // For a platform that knows why it started; sent in every cycle. Before init: after a loss of power the
    // stored load is doubted.
    void set_reset_reason(hal::ResetReason reason) noexcept { reset_reason_ = reason; }

    // For a platform with a memory that outlives a loss of power; before init. `storage` must outlive the
    // ECU.
    void use_storage(hal::Storage& storage) noexcept { load_keeper_.use(storage); }

    // For XCP and diagnosis on the same bus: hears all frames that are no sensor's. `listener` must outlive
    // the ECU. False: two do so already.
    bool listen(hal::FrameListener& listener) noexcept { return reception_.listen(listener); }

    // False: the ECU goes on, and its frames stay away from the bus.
    void set_sending(bool is_sending) noexcept { is_sending_ = is_sending; }

    // Number of frames of others, sent by the same bus since the last step, that were not taken: no fault of
    // the bus.
    void forgive_send_failures(std::uint32_t count) noexcept { send_failure_count_ += count; }

    // One cycle of 10 ms. `missed_cycles`: how many periods passed without a cycle since the last call, 0
    // when all is well; after more than two the component starts anew, because its models know no step but 10
    // ms. Feeds the watchdog at its end, unless the ECU has found itself damaged: then only a start from new
    // helps, and until it comes the ECU says "unavailable".
    void step(std::uint32_t missed_cycles) noexcept;

    // Outputs and inputs of the last cycle, for a platform that shows or records it.
    const rsi::Outputs& outputs() const noexcept { return outputs_; }
    const rsi::Inputs& inputs() const noexcept { return inputs_; }
    // Findings of the monitoring, for diagnosis.
    const monitoring::DiagnosticMemory& diagnostic_memory() const noexcept { return memory_; }

 private:
    [[gnu::cold]] void start_with(const ParameterSectionAnswer& answer) noexcept;
    [[gnu::cold]] void restore_load() noexcept;
    Health health(hal::Time now, std::uint32_t missed_cycles) noexcept;
    void report_reception(const ReceptionReport& reception) noexcept;
    void report_platform(const Health& health, hal::Time now, std::uint32_t missed_cycles) noexcept;
    rsi::Inputs qualified(const rsi::Inputs& inputs, const ReceptionReport& reception,
                          std::uint32_t missed_cycles) noexcept;
    [[gnu::cold]] void start_checks() noexcept;
    bool check_itself() noexcept;
    bool internal_fault() const noexcept;
    bool bus_error(const hal::BusStatistics& statistics) noexcept;
    bool receive_overflow(const hal::BusStatistics& statistics) noexcept;

    hal::CanBus& bus_;
    const hal::Clock& clock_;
    hal::Watchdog& watchdog_;
    rsi::Component component_;
    rsi::Parameters parameters_{};  // as started with, watched by the guard
    SensorReception reception_{};
    WarningTransmission transmission_{};
    monitoring::DiagnosticMemory memory_{};
    monitoring::InputMonitor input_monitor_{};
    monitoring::ParameterGuard parameter_guard_{};
    monitoring::MemoryGuard<rsi::Component> component_guard_{component_};
    monitoring::ClockCheck clock_check_{};
    LoadKeeper load_keeper_{};
    rsi::Inputs inputs_{no_inputs};
    rsi::Outputs outputs_{};
    ParametersRefusal refusal_{ParametersRefusal::missing};
    bool has_test_keys_{false};
    bool is_sending_{true};
    Protection protection_{Protection::unsealed};
    hal::ResetReason reset_reason_{hal::ResetReason::power_on};
    std::uint32_t cycles_{0U};  // since the start
    std::uint32_t cycle_overruns_{0U};
    std::uint32_t overflow_count_{0U};
    std::uint32_t send_failure_count_{0U};
};

}  // namespace rsi::application
