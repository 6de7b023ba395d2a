// An exception on the Cortex-R5F ends a test's program; hal/zynqmp_r5/startup/start.S calls this.
#include <cstdint>

#include "hal/semihosting/semihosting.hpp"

namespace {

constexpr int fault_status = 120;  // exit status of the emulator, unlike any that a test returns

}  // namespace

extern "C" [[noreturn]] void zynqmp_r5_on_exception(std::uint32_t, std::uint32_t, std::uint32_t) {
    rsi::hal::semihosting::print("zynqmp_r5: an exception ended the program\n");
    rsi::hal::semihosting::exit(fault_status);
}
