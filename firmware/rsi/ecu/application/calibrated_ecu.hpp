// Calibrated ECU: the ECU with XCP around it.
#pragma once

#include "rsi/ecu/application/calibration_pages.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "rsi/ecu/xcp/slave.hpp"

namespace rsi::application {

// An ECU that answers XCP. Without XCP use a RolloverEcu; nothing of this is then linked. As
// RolloverEcu, but for the section: it is kept as the reference page, so it must live as long, as all others
// must.
class CalibratedEcu {
 public:
    CalibratedEcu(hal::CanBus& bus, const hal::Clock& clock, hal::Watchdog& watchdog,
                  access::SeedAndKey& access, const std::uint8_t* section, std::size_t length,
                  hal::Storage* storage,
                  const xcp::Identifiers& identifiers = xcp::default_identifiers) noexcept
        : bus_{bus},
          clock_{clock},
          pages_{ecu_, section, length, storage},
          slave_{pages_, access, identifiers},
          ecu_{bus, clock, watchdog} {
        static_cast<void>(ecu_.listen(slave_));
    }

    // Before init, as the platform knows: reset reason, storage of the load.
    RolloverEcu& ecu() noexcept { return ecu_; }

    // With the stored section if there is a good one, else with that of the image.
    ParameterSectionAnswer init() noexcept { return pages_.init(); }

    // One cycle of 10 ms: a change of the parameters first, then the ECU, then the answers of XCP, behind the
    // warning on the bus.
    void step(std::uint32_t missed_cycles) noexcept {
        pages_.begin_cycle();
        ecu_.step(missed_cycles);
        const std::uint32_t failures = slave_.end_cycle(bus_, clock_, missed_cycles);
        if (failures > 0U) {
            ecu_.forgive_send_failures(failures);
        }
    }

    const xcp::Slave& slave() const noexcept { return slave_; }

 private:
    hal::CanBus& bus_;
    const hal::Clock& clock_;
    CalibrationPages pages_;
    xcp::Slave slave_;
    RolloverEcu ecu_;
};

}  // namespace rsi::application
