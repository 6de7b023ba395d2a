// ECU with accesses: the ECU with XCP and diagnosis, as rsi-ecu --xcp --diagnosis has them, without a
// connection.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/memory/memory_storage.hpp"
#include "rsi/ecu/access/seed_and_key.hpp"
#include "rsi/ecu/access/stored_count.hpp"
#include "rsi/ecu/application/calibrated_ecu.hpp"
#include "rsi/ecu/diagnosis/diagnosis.hpp"
#include "rsi/ecu/diagnosis/section_store.hpp"
#include "rsi/hal/key_store.hpp"
#include "rsi/hal/random_source.hpp"

extern "C" const unsigned char rsi_parameter_section[rsi::application::section::length];

namespace budgets {

class EcuWithAccesses {
 public:
    // All must outlive the ECU.
    EcuWithAccesses(rsi::hal::CanBus& bus, const rsi::hal::Clock& clock,
                    rsi::hal::Watchdog& watchdog) noexcept
        : diagnosis_{bus, rsi::diagnosis::Addresses{}, identification_, one_, other_},
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
        static_cast<void>(ecu_.ecu().add_listener(diagnosis_.listener()));
        return ecu_.init().refusal == rsi::application::ParametersRefusal::none;
    }

    // A function of its own, so that its calls are found in a trace.
    [[gnu::noinline]] void cycle() noexcept {
        ecu_.step(0U);
        diagnosis_.step(ecu_.ecu());
    }

    const rsi::Outputs& outputs() noexcept { return ecu_.ecu().outputs(); }

 private:
    class NoKeys final : public rsi::hal::KeyStore {
     public:
        bool authenticate(rsi::hal::KeySlot, const std::uint8_t*, std::size_t,
                          rsi::hal::AuthenticationCode&) noexcept override {
            return false;
        }
        bool has_test_keys() const noexcept override { return false; }
    };
    class NoRandom final : public rsi::hal::RandomSource {
     public:
        bool fill(std::uint8_t*, std::size_t) noexcept override { return false; }
    };

    rsi::hal::MemoryStorage<rsi::diagnosis::KeptData::record_length> one_{};
    rsi::hal::MemoryStorage<rsi::diagnosis::KeptData::record_length> other_{};
    rsi::hal::MemoryStorage<rsi::application::SectionRecord::length> section_one_{};
    rsi::hal::MemoryStorage<rsi::application::SectionRecord::length> section_other_{};
    rsi::application::SectionRecord section_{section_one_, section_other_};
    rsi::hal::MemoryStorage<rsi::access::stored_count_length> calibration_attempts_{};
    rsi::hal::MemoryStorage<rsi::access::stored_count_length> diagnosis_attempts_{};
    NoKeys keys_{};
    NoRandom random_{};
    rsi::access::SeedAndKey calibration_access_{keys_, rsi::hal::KeySlot::calibration, random_,
                                                calibration_attempts_};
    rsi::access::SeedAndKey diagnosis_access_{keys_, rsi::hal::KeySlot::diagnosis, random_,
                                              diagnosis_attempts_};
    rsi::diagnosis::SectionStore store_{section_};
    rsi::diagnosis::Identification identification_{};
    rsi::diagnosis::Diagnosis diagnosis_;
    rsi::application::CalibratedEcu ecu_;
};

}  // namespace budgets
