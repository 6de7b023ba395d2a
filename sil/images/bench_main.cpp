// rsi-ecu-r5f-bench: the firmware with XCP and diagnosis on the emulated Cortex-R5F. For the emulator; never
// flashed: its keys are public, its seeds can be guessed, and it keeps nothing over a loss of
// power.
#include "hal/zynqmp_r5/startup/exceptions.hpp"
#include "images/zynqmp_r5/ecu_image.hpp"
#include "images/zynqmp_r5/warning_recorder.hpp"
#include "sil/images/bench_ecu.hpp"

namespace {

[[gnu::section(".retained")]] sil::BenchMemory memory;

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

 private:
    sil::BenchEcu ecu_;
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

sil::BenchMemory& sil::bench_memory() noexcept {
    return memory;
}

int main() {
    ecu.run(can_settings());
}
