// Accessible ECU: the firmware with XCP and diagnosis, or without, on any bus and clock.
#pragma once

#include <cstdint>
#include <optional>

#include "rsi/ecu/application/calibrated_ecu.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "sil/apps/tool_access.hpp"

namespace sil {

// Access beside the warning; nullptr: none.
struct Accesses {
    CalibrationAccess* calibration{nullptr};
    DiagnosisAccess* diagnosis{nullptr};
};

class AccessibleEcu {
 public:
    // All must outlive the ECU. `is_switched_on`: an operation cycle begins; false after a reset. Throws
    // std::runtime_error when the parameters are refused.
    AccessibleEcu(rsi::hal::CanBus& bus, const rsi::hal::Clock& clock, rsi::hal::Watchdog& watchdog,
                  const rsi::Parameters& parameters, const Accesses& accesses, bool is_switched_on);

    void step(std::uint32_t missed_cycles);
    // How much later than usual the next cycle should begin.
    rsi::hal::Time cycle_shift() const {
        return calibrated_ ? calibrated_->cycle_shift() : plain_->cycle_shift();
    }
    // An orderly end, unlike a loss of power.
    void stop();
    // A tester wants it to start anew.
    bool is_reset_requested() const { return diagnosis_ && diagnosis_->is_reset_requested(); }

    // It has started with other parameters than those that it was given.
    bool has_stored() const { return has_stored_; }
    const rsi::Outputs& outputs() { return ecu().outputs(); }

 private:
    rsi::application::RolloverEcu& ecu() { return calibrated_ ? calibrated_->ecu() : *plain_; }
    void start_diagnosis(rsi::hal::CanBus& bus, DiagnosisAccess& access, bool is_switched_on);
    void start_calibrated(const rsi::Parameters& parameters);
    void start_plain(const rsi::Parameters& parameters, DiagnosisAccess* access);
    void say_refused();

    std::optional<rsi::diagnosis::Diagnosis> diagnosis_;
    std::optional<rsi::application::RolloverEcu> plain_;
    std::optional<rsi::application::CalibratedEcu> calibrated_;
    bool has_stored_{false};
};

}  // namespace sil
