// Rollover ECU: the application that a platform's main loop calls every 10 ms. Frames in, step, frames out.
#pragma once

#include "rsi/language.hpp"

#include <cstddef>
#include <cstdint>

#include "rsi/component.hpp"
#include "rsi/ecu/application/calibration_identity.hpp"
#include "rsi/ecu/application/cycle_phase.hpp"
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
    // All three must outlive the ECU. Order of calls: the set-up calls that the platform needs
    // (report_test_keys, set_reset_reason, use_storage, add_listener), one init(), then step() in every
    // cycle.
    RolloverEcu(hal::CanBus& bus, const hal::Clock& clock, hal::Watchdog& watchdog) noexcept
        : bus_{bus}, clock_{clock}, watchdog_{watchdog} {}

    // Starts the component. When the parameters are refused, the ECU still runs: it sends "unavailable", the
    // diagnostic flag ParametersInvalid and, as ParametersRefusal, why.
    rsi::Validation init(const rsi::Parameters& parameters) noexcept;

    // The same with the parameters of a parameter section (parameter_section.hpp) in memory. `length`: bytes
    // that may be read from `section` on.
    ParameterSectionAnswer init(const std::uint8_t* section, std::size_t length) noexcept;

    // Takes over other parameters between two cycles, under the preconditions of rsi::Component::change; the
    // change began from parameters(). Restarts the input monitoring only if the vehicle or its sensors have
    // changed. An ECU that has refused its parameters starts with these, without the load that is stored.
    [[gnu::cold]] void change(const rsi::ParameterChange& change) noexcept;

    // The parameters of the last init() or change(); all zeros after a refusal.
    const rsi::Parameters& parameters() const noexcept { return parameters_; }

    // Initialises from a section that must carry a good seal. An accepted one raises the authority's version,
    // so that older sections are refused from then on.
    ParameterSectionAnswer init(const std::uint8_t* section, std::size_t length,
                                SectionAuthority& authority) noexcept;

    // Before init, on a platform with seed and key for XCP or UDS: if `keys` holds the public test keys, the
    // signal Protection says so.
    void report_test_keys(const hal::KeyStore& keys) noexcept { has_test_keys_ = keys.has_test_keys(); }

    // Before init, on a platform that knows why it started. Sent in every cycle; after power-on the stored
    // load is trusted less, because the vehicle may have been loaded meanwhile.
    void set_reset_reason(hal::ResetReason reason) noexcept { reset_reason_ = reason; }

    // Before init, on a platform with non-volatile memory: keeps there what it learns of the load and of
    // the lateral accelerometer. `storage` must outlive the ECU.
    void use_storage(hal::Storage& storage) noexcept { load_keeper_.use(storage); }

    // Before the first cycle, on a platform that can store a section: `refusal` is the reason for which the
    // stored one is not used, though the ECU runs on the image's; `none`: nothing is stored, or all is well.
    // Sets the code stored_parameters_refused, and is sent as ParametersRefusal.
    [[gnu::cold]] void report_stored_section(ParametersRefusal refusal) noexcept;
    ParametersRefusal stored_refusal() const noexcept { return stored_refusal_; }

    // Each cycle, on a platform that stores more than the load: a memory of diagnosis, or the one in which
    // XCP stores sections, takes no record, or has lost one. Each sets the code storage_failed, as the memory
    // of the load does.
    void report_storage(bool is_failing) noexcept { is_storage_failing_ = is_failing; }
    void report_calibration_storage(bool is_failing) noexcept {
        is_calibration_storage_failing_ = is_failing;
    }

    // After a clear by a tester: the debounce counts of these codes begin anew, so that none of what came
    // before counts. One that is confirmed stays so until it heals.
    void restart_debounce(monitoring::CodeSet codes) noexcept {
        if (codes != 0U) {
            memory_.restart(codes);
        }
    }

    // For XCP and diagnosis on the same bus: `listener` gets all received frames except those of the sensors,
    // and must outlive the ECU. False: there are two listeners already.
    bool add_listener(hal::FrameListener& listener) noexcept { return reception_.add_listener(listener); }

    // False suppresses the ECU's frames; all else goes on.
    void set_sending(bool is_sending) noexcept { is_sending_ = is_sending; }

    // `count` frames of XCP that the bus has not taken since the last step: keeps them out of the code
    // bus_error, which monitors the ECU's own frames.
    void ignore_send_failures(std::uint32_t count) noexcept { send_failure_count_ += count; }

    // One cycle of 10 ms. `missed_cycles`: number of periods without a cycle since the last call, normally 0;
    // after more than two the component is reset, because its models integrate over a fixed step of 10 ms.
    // Feeds the watchdog last, unless a self-check (parameters, memory, estimate, outputs) has failed in this
    // cycle: a fault that persists ends in a watchdog reset, and until then the state is "unavailable".
    void step(std::uint32_t missed_cycles) noexcept;

    // After step(): how much later than 10 ms after this cycle the next one should begin, within +-0.1 ms;
    // earlier if negative. A platform that follows it takes up the IMU's frames 1 ms after they came, one
    // that does not, up to 10 ms.
    hal::Time cycle_shift() const noexcept { return cycle_shift_; }

    // Outputs and qualified inputs of the last cycle, for diagnosis, measurement and recording.
    const rsi::Outputs& outputs() const noexcept { return outputs_; }
    const rsi::Inputs& inputs() const noexcept { return inputs_; }
    // Name and checksum of the parameters in use, for diagnosis.
    const CalibrationIdentity& calibration() const noexcept { return calibration_; }
    // Findings of the monitoring, for diagnosis.
    const monitoring::DiagnosticMemory& diagnostic_memory() const noexcept { return memory_; }

 private:
    [[gnu::cold]] void start_component(const std::uint8_t* section,
                                       const ParameterSectionAnswer& answer) noexcept;
    [[gnu::cold]] void restore_learnt() noexcept;
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
    rsi::Parameters parameters_{};  // checked by parameter_guard_
    SensorReception reception_{};
    WarningTransmission transmission_{};
    monitoring::DiagnosticMemory memory_{};
    monitoring::InputMonitor input_monitor_{};
    monitoring::ParameterGuard parameter_guard_{};
    monitoring::MemoryGuard<rsi::Component> component_guard_{component_};
    monitoring::ClockCheck clock_check_{};
    LoadKeeper load_keeper_{};
    CalibrationIdentity calibration_{};
    rsi::Inputs inputs_{no_inputs};
    rsi::Outputs outputs_{};
    // Codes whose checks run in every cycle; that of the stored section only where one can be stored.
    monitoring::CodeSet tests_of_every_cycle_{monitoring::set_of(
        monitoring::DiagnosticCode::parameters_refused, monitoring::DiagnosticCode::parameters_damaged,
        monitoring::DiagnosticCode::memory_restored, monitoring::DiagnosticCode::cycle_overrun,
        monitoring::DiagnosticCode::cycle_stall, monitoring::DiagnosticCode::clock_jump,
        monitoring::DiagnosticCode::bus_error, monitoring::DiagnosticCode::storage_failed)};
    ParametersRefusal refusal_{ParametersRefusal::missing};
    ParametersRefusal stored_refusal_{ParametersRefusal::none};
    bool has_test_keys_{false};
    bool is_sending_{true};
    bool is_storage_failing_{false};
    bool is_calibration_storage_failing_{false};
    Protection protection_{Protection::unsealed};
    hal::ResetReason reset_reason_{hal::ResetReason::power_on};
    hal::Time cycle_shift_{};
    std::uint32_t cycles_{0U};  // since the start
    std::uint32_t cycle_overruns_{0U};
    // Values of BusStatistics in the last cycle, to detect an increase.
    std::uint32_t overflow_count_{0U};
    std::uint32_t send_failure_count_{0U};
};

}  // namespace rsi::application
