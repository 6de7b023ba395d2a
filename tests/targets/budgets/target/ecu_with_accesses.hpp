// ECU with accesses: the ECU with XCP and diagnosis, as rsi-ecu --xcp --diagnosis has them, without a
// connection.
#pragma once

#include <cstddef>
#include <cstdint>

#include "access/seed_and_key.hpp"
#include "access/stored_count.hpp"
#include "application/calibrated_ecu.hpp"
#include "diagnosis/diagnosis.hpp"
#include "diagnosis/section_store.hpp"
#include "hal/interface/key_store.hpp"
#include "hal/interface/random_source.hpp"
#include "hal/memory/memory_storage.hpp"

extern "C" const unsigned char rsi_parameter_section[application::section::length];

namespace budgets {

class EcuWithAccesses {
 public:
    // All must outlive the ECU.
    EcuWithAccesses(hal::CanBus& bus, const hal::Clock& clock, hal::Watchdog& watchdog) noexcept
        : diagnosis_{bus, diagnosis::Addresses{}, identification_, one_, other_},
          ecu_{bus,
               clock,
               watchdog,
               calibration_access_,
               rsi_parameter_section,
               sizeof rsi_parameter_section,
               &section_} {}

    // With the section that is linked; false where it is refused.
    bool init(const rsi::Parameters&) noexcept {
        calibration_access_.start();
        diagnosis_access_.start();
        diagnosis_.use(diagnosis_access_);
        diagnosis_.use(store_);
        diagnosis_.start(true);
        static_cast<void>(ecu_.ecu().listen(diagnosis_.listener()));
        return ecu_.init().refusal == application::ParametersRefusal::none;
    }

    // A function of its own, so that its calls are found in a trace.
    [[gnu::noinline]] void cycle() noexcept {
        ecu_.step(0U);
        diagnosis_.step(ecu_.ecu());
    }

    const rsi::Outputs& outputs() noexcept { return ecu_.ecu().outputs(); }

 private:
    class NoKeys final : public hal::KeyStore {
     public:
        bool authenticate(hal::KeySlot, const std::uint8_t*, std::size_t,
                          hal::AuthenticationCode&) noexcept override {
            return false;
        }
        bool has_test_keys() const noexcept override { return false; }
    };
    class NoRandom final : public hal::RandomSource {
     public:
        bool fill(std::uint8_t*, std::size_t) noexcept override { return false; }
    };

    hal::MemoryStorage<diagnosis::KeptData::record_length> one_{};
    hal::MemoryStorage<diagnosis::KeptData::record_length> other_{};
    hal::MemoryStorage<application::section::length> section_{};
    hal::MemoryStorage<access_control::stored_count_length> calibration_attempts_{};
    hal::MemoryStorage<access_control::stored_count_length> diagnosis_attempts_{};
    NoKeys keys_{};
    NoRandom random_{};
    access_control::SeedAndKey calibration_access_{keys_, hal::KeySlot::calibration, random_,
                                                   calibration_attempts_};
    access_control::SeedAndKey diagnosis_access_{keys_, hal::KeySlot::diagnosis, random_,
                                                 diagnosis_attempts_};
    diagnosis::SectionStore store_{section_};
    diagnosis::Identification identification_{};
    diagnosis::Diagnosis diagnosis_;
    application::CalibratedEcu ecu_;
};

}  // namespace budgets
