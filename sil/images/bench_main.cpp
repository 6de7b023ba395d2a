// rsi-ecu-r5f-bench: the firmware with XCP and diagnosis on the emulated Cortex-R5F. For the emulator; never
// flashed: its keys are public, its seeds can be guessed, and it keeps nothing over a loss of
// power.
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/memory/retained_record.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "hal/zynqmp_r5/startup/exceptions.hpp"
#include "images/zynqmp_r5/ecu_image.hpp"
#include "images/zynqmp_r5/warning_recorder.hpp"
#include "rsi/ecu/access/stored_count.hpp"
#include "rsi/ecu/application/calibrated_ecu.hpp"
#include "rsi/ecu/diagnosis/diagnosis.hpp"
#include "rsi/ecu/diagnosis/section_store.hpp"
#include "rsi/hal/clock.hpp"
#include "rsi/hal/random_source.hpp"
#include "rsi/hal/reset_reason.hpp"
#include "rsi/version.h"

namespace {

// In place of a random source, where neither the emulated machine nor the silicon has a generator that this
// project drives. Fit for no product.
//
// They follow from the moments at which they were asked for, in counts of the free-running timer: other seeds
// each time, which a listener on the bus finds by trying.
class GuessableNumbers final : public rsi::hal::RandomSource {
 public:
    // `clock` must outlive this object.
    explicit GuessableNumbers(const rsi::hal::Clock& clock) noexcept : clock_{clock} {}

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
    const rsi::hal::Clock& clock_;
    std::uint32_t state_{0U};
};

struct BenchMemory {
    rsi::hal::RetainedMemory<rsi::diagnosis::KeptData::record_length> one;
    rsi::hal::RetainedMemory<rsi::diagnosis::KeptData::record_length> other;
    rsi::hal::RetainedMemory<rsi::application::SectionRecord::length> section_one;
    rsi::hal::RetainedMemory<rsi::application::SectionRecord::length> section_other;
    rsi::hal::RetainedMemory<rsi::access::stored_count_length> calibration_attempts;
    rsi::hal::RetainedMemory<rsi::access::stored_count_length> diagnosis_attempts;
};

// No start clears it.
[[gnu::section(".retained")]] BenchMemory memory;

// Has what rsi::image::EcuImage asks of an ECU. The keys are public, and it reports that on the bus.
class BenchEcu {
 public:
    // All must outlive the ECU.
    BenchEcu(rsi::hal::CanBus& bus, const rsi::hal::Clock& clock, rsi::hal::Watchdog& watchdog) noexcept
        : bus_{bus},
          clock_{clock},
          watchdog_{watchdog},
          random_{clock},
          diagnosis_{bus, rsi::diagnosis::Addresses{}, identification_, one_, other_} {}

    void set_reset_reason(rsi::hal::ResetReason reason) noexcept { reset_reason_ = reason; }

    // With the section that XCP or a tester has stored since power-on, else with this one.
    rsi::application::ParameterSectionAnswer init(const std::uint8_t* section, std::size_t length) noexcept {
        calibration_access_.start();
        diagnosis_access_.start();
        diagnosis_.use(diagnosis_access_);
        diagnosis_.use(store_);
        diagnosis_.start(reset_reason_ == rsi::hal::ResetReason::power_on);
        ecu_.emplace(bus_, clock_, watchdog_, calibration_access_, section, length, &section_);
        rsi::application::RolloverEcu& ecu = ecu_->ecu();
        ecu.set_reset_reason(reset_reason_);
        ecu.report_test_keys(keys_);
        static_cast<void>(ecu.add_listener(diagnosis_.listener()));
        return ecu_->init();
    }

    void step(std::uint32_t missed_cycles) noexcept {
        ecu_->step(missed_cycles);
        diagnosis_.step(ecu_->ecu());
    }

    rsi::hal::Time cycle_shift() const noexcept { return ecu_->cycle_shift(); }

    // A tester has asked for it and has his answer.
    bool is_reset_requested() const noexcept { return diagnosis_.is_reset_requested(); }

 private:
    rsi::hal::CanBus& bus_;
    const rsi::hal::Clock& clock_;
    rsi::hal::Watchdog& watchdog_;
    rsi::hal::ResetReason reset_reason_{rsi::hal::ResetReason::power_on};
    rsi::hal::RetainedRecord<rsi::diagnosis::KeptData::record_length> one_{memory.one};
    rsi::hal::RetainedRecord<rsi::diagnosis::KeptData::record_length> other_{memory.other};
    rsi::hal::RetainedRecord<rsi::application::SectionRecord::length> section_one_{memory.section_one};
    rsi::hal::RetainedRecord<rsi::application::SectionRecord::length> section_other_{memory.section_other};
    rsi::application::SectionRecord section_{section_one_, section_other_};
    rsi::hal::RetainedRecord<rsi::access::stored_count_length> calibration_attempts_{
        memory.calibration_attempts};
    rsi::hal::RetainedRecord<rsi::access::stored_count_length> diagnosis_attempts_{memory.diagnosis_attempts};
    rsi::hal::SoftwareKeys keys_{rsi::hal::test_keys};
    GuessableNumbers random_;
    rsi::access::SeedAndKey calibration_access_{keys_, rsi::hal::KeySlot::calibration, random_,
                                                calibration_attempts_};
    rsi::access::SeedAndKey diagnosis_access_{keys_, rsi::hal::KeySlot::diagnosis, random_,
                                              diagnosis_attempts_};
    rsi::diagnosis::SectionStore store_{section_};
    const rsi::diagnosis::Identification identification_{
        rsi::diagnosis::text_of<rsi::diagnosis::ShortText>("Rollover warning"),
        rsi::diagnosis::text_of<rsi::diagnosis::ShortText>(RSI_VERSION),
        rsi::diagnosis::text_of<rsi::diagnosis::LongText>("of the image"),
        rsi::diagnosis::text_of<rsi::diagnosis::ShortText>("Cortex-R5F"),
        rsi::diagnosis::text_of<rsi::diagnosis::ShortText>("bench")};
    rsi::diagnosis::Diagnosis diagnosis_;
    std::optional<rsi::application::CalibratedEcu> ecu_{};
};

// Starts the controller anew when a tester has asked for it.
class Ecu {
 public:
    Ecu(rsi::hal::CanBus& bus, const rsi::hal::Clock& clock, rsi::hal::Watchdog& watchdog) noexcept
        : ecu_{bus, clock, watchdog} {}
    void set_reset_reason(rsi::hal::ResetReason reason) noexcept { ecu_.set_reset_reason(reason); }
    rsi::application::ParameterSectionAnswer init(const std::uint8_t* section, std::size_t length) noexcept {
        return ecu_.init(section, length);
    }
    void step(std::uint32_t missed_cycles) noexcept {
        ecu_.step(missed_cycles);
        if (ecu_.is_reset_requested()) {
            rsi::hal::zynqmp_r5::reset_now();
        }
    }
    rsi::hal::Time cycle_shift() const noexcept { return ecu_.cycle_shift(); }

 private:
    BenchEcu ecu_;
};

rsi::image::EcuImage<rsi::image::WarningRecorder, Ecu> ecu;

// Those of the image that is flashed, and what XCP and testers send.
constexpr rsi::hal::zynqmp_r5::CanSettings can_settings() {
    constexpr rsi::diagnosis::Addresses addresses{};
    rsi::hal::zynqmp_r5::CanSettings settings = rsi::image::can_settings();
    settings.accepted[settings.accepted_count] = rsi::hal::zynqmp_r5::accepting(std::array<std::uint32_t, 3>{
        rsi::xcp::default_identifiers.command, addresses.physical_request, addresses.functional_request});
    ++settings.accepted_count;
    return settings;
}

}  // namespace

int main() {
    ecu.run(can_settings());
}
