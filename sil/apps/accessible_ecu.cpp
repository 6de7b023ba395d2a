#include "sil/apps/accessible_ecu.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstring>

#include "sil/files/parameter_section_file.hpp"
#include "sil/files/require_accepted.hpp"

namespace sil {

AccessibleEcu::AccessibleEcu(rsi::hal::CanBus& bus, const rsi::hal::Clock& clock,
                             rsi::hal::Watchdog& watchdog, const rsi::Parameters& parameters,
                             const Accesses& accesses, bool is_switched_on) {
    if (accesses.diagnosis != nullptr) {
        start_diagnosis(bus, *accesses.diagnosis, is_switched_on);
    }
    CalibrationAccess* const access = accesses.calibration;
    if (access != nullptr) {
        calibrated_.emplace(bus, clock, watchdog, access->seed_and_key(), access->section().data(),
                            access->section().size(), &access->stored_section());
        calibrated_->ecu().report_test_keys(access->keys());
        start_calibrated(parameters);
    } else {
        plain_.emplace(bus, clock, watchdog);
        if (accesses.diagnosis != nullptr) {
            plain_->report_test_keys(accesses.diagnosis->keys());
        }
        start_plain(parameters, accesses.diagnosis);
    }
    if (diagnosis_) {
        static_cast<void>(ecu().add_listener(diagnosis_->listener()));
    }
    say_refused();
}

void AccessibleEcu::step(std::uint32_t missed_cycles) {
    if (calibrated_) {
        calibrated_->step(missed_cycles);
    } else {
        plain_->step(missed_cycles);
    }
    if (diagnosis_) {
        diagnosis_->step(ecu());
    }
}

void AccessibleEcu::stop() {
    if (diagnosis_) {
        diagnosis_->stop();
    }
}

void AccessibleEcu::start_diagnosis(rsi::hal::CanBus& bus, DiagnosisAccess& access, bool is_switched_on) {
    diagnosis_.emplace(bus, rsi::diagnosis::Addresses{}, access.identification(), access.one(),
                       access.other());
    diagnosis_->use(access.seed_and_key());
    diagnosis_->use(access.store());
    diagnosis_->start(is_switched_on);
}

void AccessibleEcu::start_calibrated(const rsi::Parameters& parameters) {
    require_accepted(calibrated_->init().validation);
    has_stored_ = std::memcmp(&calibrated_->ecu().parameters(), &parameters, sizeof parameters) != 0;
}

void AccessibleEcu::start_plain(const rsi::Parameters& parameters, DiagnosisAccess* access) {
    const bool is_downloaded = (access != nullptr) && access->store().restore();
    if (access != nullptr) {
        plain_->report_stored_section(access->store().refusal());
    }
    if (is_downloaded) {
        require_accepted(plain_->init(access->store().section(), access->store().length()).validation);
        fmt::print("rsi-ecu: starts with the parameters that were downloaded\n");
    } else {
        require_accepted(plain_->init(parameters));
    }
}

void AccessibleEcu::say_refused() {
    const rsi::application::ParametersRefusal refusal = ecu().stored_refusal();
    if (refusal != rsi::application::ParametersRefusal::none) {
        fmt::print(
            "rsi-ecu: the section that was stored is not used: {}. Next: download or store it anew\n",
            explain({refusal, rsi::Validation{0, "a value", "is out of range or contradicts another"}}));
        std::fflush(stdout);
    }
}

}  // namespace sil
