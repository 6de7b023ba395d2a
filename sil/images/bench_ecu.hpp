// Bench ECU: the ECU with XCP and diagnosis, as an image for a bench has it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "access/stored_count.hpp"
#include "application/calibrated_ecu.hpp"
#include "diagnosis/diagnosis.hpp"
#include "diagnosis/section_store.hpp"
#include "hal/interface/clock.hpp"
#include "hal/interface/random_source.hpp"
#include "hal/interface/reset_reason.hpp"
#include "hal/memory/retained_record.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "rsi/version.h"

namespace sil {

// In place of a random source, where neither the emulated machine nor the silicon has a generator that this
// project drives. Fit for no product.
//
// They follow from the moments at which they were asked for, in counts of the free-running timer: other seeds
// each time, which a listener on the bus finds by trying.
class GuessableNumbers final : public hal::RandomSource {
 public:
    // `clock` must outlive this object.
    explicit GuessableNumbers(const hal::Clock& clock) noexcept : clock_{clock} {}

    bool fill(std::uint8_t* bytes, std::size_t length) noexcept override {
        state_ ^= static_cast<std::uint32_t>(clock_.now().nanoseconds);
        for (std::size_t place = 0U; place < length; ++place) {
            state_ =
                state_ * 1664525U + 1013904223U;  // of Numerical Recipes; its upper bits are the better ones
            bytes[place] = static_cast<std::uint8_t>(state_ >> 24U);
        }
        return true;
    }

 private:
    const hal::Clock& clock_;
    std::uint32_t state_{0U};
};

struct BenchMemory {
    hal::RetainedMemory<diagnosis::KeptData::record_length> one;
    hal::RetainedMemory<diagnosis::KeptData::record_length> other;
    hal::RetainedMemory<application::section::length> section;
    hal::RetainedMemory<access_control::stored_count_length> calibration_attempts;
    hal::RetainedMemory<access_control::stored_count_length> diagnosis_attempts;
};

// The image's; no start clears it.
BenchMemory& bench_memory() noexcept;

// Has what image::EcuImage asks of an ECU. The keys are public, and it reports that on the bus.
class BenchEcu {
 public:
    // All must outlive the ECU.
    BenchEcu(hal::CanBus& bus, const hal::Clock& clock, hal::Watchdog& watchdog) noexcept
        : bus_{bus},
          clock_{clock},
          watchdog_{watchdog},
          random_{clock},
          diagnosis_{bus, diagnosis::Addresses{}, identification_, one_, other_} {}

    void set_reset_reason(hal::ResetReason reason) noexcept { reset_reason_ = reason; }

    // With the section that XCP or a tester has stored since power-on, else with this one.
    application::ParameterSectionAnswer init(const std::uint8_t* section, std::size_t length) noexcept {
        calibration_access_.start();
        diagnosis_access_.start();
        diagnosis_.use(diagnosis_access_);
        diagnosis_.use(store_);
        diagnosis_.start(reset_reason_ == hal::ResetReason::power_on);
        ecu_.emplace(bus_, clock_, watchdog_, calibration_access_, section, length, &section_);
        application::RolloverEcu& ecu = ecu_->ecu();
        ecu.set_reset_reason(reset_reason_);
        ecu.use_keys(keys_);
        static_cast<void>(ecu.listen(diagnosis_.listener()));
        return ecu_->init();
    }

    void step(std::uint32_t missed_cycles) noexcept {
        ecu_->step(missed_cycles);
        diagnosis_.step(ecu_->ecu());
    }

    // A tester has asked for it and has his answer.
    bool is_reset_requested() const noexcept { return diagnosis_.is_reset_requested(); }

 private:
    hal::CanBus& bus_;
    const hal::Clock& clock_;
    hal::Watchdog& watchdog_;
    hal::ResetReason reset_reason_{hal::ResetReason::power_on};
    hal::RetainedRecord<diagnosis::KeptData::record_length> one_{bench_memory().one};
    hal::RetainedRecord<diagnosis::KeptData::record_length> other_{bench_memory().other};
    hal::RetainedRecord<application::section::length> section_{bench_memory().section};
    hal::RetainedRecord<access_control::stored_count_length> calibration_attempts_{
        bench_memory().calibration_attempts};
    hal::RetainedRecord<access_control::stored_count_length> diagnosis_attempts_{
        bench_memory().diagnosis_attempts};
    hal::SoftwareKeys keys_{hal::test_keys};
    GuessableNumbers random_;
    access_control::SeedAndKey calibration_access_{keys_, hal::KeySlot::calibration, random_,
                                                   calibration_attempts_};
    access_control::SeedAndKey diagnosis_access_{keys_, hal::KeySlot::diagnosis, random_,
                                                 diagnosis_attempts_};
    diagnosis::SectionStore store_{section_};
    const diagnosis::Identification identification_{
        diagnosis::text_of<diagnosis::ShortText>("Rollover warning"),
        diagnosis::text_of<diagnosis::ShortText>(RSI_VERSION),
        diagnosis::text_of<diagnosis::LongText>("of the image"),
        diagnosis::text_of<diagnosis::ShortText>("Cortex-R5F"),
        diagnosis::text_of<diagnosis::ShortText>("bench")};
    diagnosis::Diagnosis diagnosis_;
    std::optional<application::CalibratedEcu> ecu_{};
};

}  // namespace sil
