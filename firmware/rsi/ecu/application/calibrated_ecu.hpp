// Calibrated ECU: a RolloverEcu with an XCP slave for measurement and calibration.
#pragma once

#include "rsi/ecu/application/calibration_pages.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "rsi/ecu/xcp/slave.hpp"

namespace rsi::application {

// An image without XCP uses a RolloverEcu and links nothing of this.
class CalibratedEcu {
 public:
    // All must outlive the ECU. `section`, of which `length` bytes may be read, is the reference page;
    // `stored` keeps the working page (nullptr: it cannot be stored).
    CalibratedEcu(hal::CanBus& bus, const hal::Clock& clock, hal::Watchdog& watchdog,
                  access::SeedAndKey& access, const std::uint8_t* section, std::size_t length,
                  SectionRecord* stored,
                  const xcp::Identifiers& identifiers = xcp::default_identifiers) noexcept
        : bus_{bus},
          clock_{clock},
          pages_{ecu_, section, length, stored},
          slave_{pages_, access, identifiers},
          ecu_{bus, clock, watchdog} {
        static_cast<void>(ecu_.add_listener(slave_));
    }

    // For the set-up calls of RolloverEcu, before init.
    RolloverEcu& ecu() noexcept { return ecu_; }

    // With the stored section if there is a good one, else with that of the image.
    ParameterSectionAnswer init() noexcept { return pages_.init(); }

    // One cycle of 10 ms: changes parameters first, then steps the ECU. XCP responses come last, so that they
    // never delay the warning frame.
    void step(std::uint32_t missed_cycles) noexcept {
        pages_.begin_cycle();
        ecu_.step(missed_cycles);
        const std::uint32_t failures = slave_.end_cycle(bus_, clock_, missed_cycles);
        if (failures > 0U) {
            ecu_.ignore_send_failures(failures);
        }
    }

    // As RolloverEcu's.
    hal::Time cycle_shift() const noexcept { return ecu_.cycle_shift(); }

    const xcp::Slave& slave() const noexcept { return slave_; }

 private:
    hal::CanBus& bus_;
    const hal::Clock& clock_;
    CalibrationPages pages_;
    xcp::Slave slave_;
    RolloverEcu ecu_;
};

}  // namespace rsi::application
