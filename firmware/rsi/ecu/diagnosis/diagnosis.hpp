// Diagnosis: the trouble memory, and a tester on the bus, beside an ECU that knows nothing of either.
//
//   diagnosis::Diagnosis diagnosis{bus, {}, identification, one_place, other_place};
//   application::RolloverEcu ecu{bus, clock, watchdog};
//   ecu.add_listener(diagnosis.listener());
//   diagnosis.start(is_new_operation_cycle);
//   each cycle: ecu.step(missed_cycles); diagnosis.step(ecu);
//
// Nothing of it is linked into an image that does not name it.
#pragma once

#include "rsi/ecu/application/rollover_ecu.hpp"
#include "rsi/ecu/diagnosis/iso_tp.hpp"
#include "rsi/ecu/diagnosis/kept_data.hpp"
#include "rsi/ecu/diagnosis/uds_server.hpp"
#include "rsi/ecu/monitoring/diagnostic_memory.hpp"

namespace rsi::diagnosis {

class Diagnosis {
 public:
    // All must outlive this object. The places take KeptData::record_length bytes each.
    Diagnosis(hal::CanBus& bus, const Addresses& addresses, const Identification& identification,
              hal::Storage& one, hal::Storage& other) noexcept
        : transport_{bus, addresses}, kept_{one, other}, server_{transport_, kept_, identification} {}

    // Hears a tester's frames.
    hal::FrameListener& listener() noexcept { return transport_; }

    // Without them nothing is unlocked, and no parameter section is taken.
    void use(access::SeedAndKey& access) noexcept { server_.use(access); }
    void use(SectionTarget& target) noexcept { server_.use(target); }

    // Before the first cycle. `is_new_operation_cycle`: the ignition was switched on; false after a reset
    // that only the controller noticed.
    [[gnu::cold]] void start(bool is_new_operation_cycle) noexcept {
        kept_.restore();
        kept_.codes().start(is_new_operation_cycle);
    }

    // After each step of the ECU.
    void step(application::RolloverEcu& ecu) noexcept {
        step(ecu.diagnostic_memory(), ecu.inputs(), ecu.outputs(), ecu.calibration());
        ecu.set_sending(lets_ecu_send());
        ecu.report_storage(is_storage_failing());
        ecu.restart_debounce(cleared_codes());
    }

    // The same with the findings of an ECU, which asks lets_ecu_send() whether to send,
    // is_storage_failing() and cleared_codes().
    void step(const monitoring::DiagnosticMemory& memory, const rsi::Inputs& inputs,
              const rsi::Outputs& outputs, const application::CalibrationIdentity& calibration) noexcept {
        kept_.codes().update({memory.confirmed_codes(), memory.active_codes(), memory.tested_codes()},
                             memory.snapshot(), calibration.checksum);
        server_.step(memory, inputs, outputs, calibration);
        kept_.end_cycle();
    }

    // Before the control unit is switched off in an orderly way.
    void stop() noexcept { kept_.store_the_rest(); }

    // A tester has asked for it and has his answer.
    bool is_reset_requested() const noexcept { return server_.is_reset_requested(); }

    Session session() const noexcept { return server_.session(); }

    // Its memory takes no record, or has lost one.
    bool is_storage_failing() const noexcept { return kept_.is_failing(); }

    // Codes that a tester has cleared in this step: their debounce counts are to begin anew.
    monitoring::CodeSet cleared_codes() const noexcept { return kept_.codes().cleared_codes(); }

    // False while a tester keeps the ECU's own frames from the bus.
    bool lets_ecu_send() const noexcept { return server_.lets_ecu_send(); }

 private:
    IsoTp transport_;
    KeptData kept_;
    UdsServer server_;
};

}  // namespace rsi::diagnosis
