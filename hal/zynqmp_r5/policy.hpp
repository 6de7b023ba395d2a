// Differences between the silicon and its emulator (QEMU 7.2, machine xlnx-zcu102), in one type each. An
// image chooses one when it is built (RSI_ZYNQMP_POLICY_SILICON or RSI_ZYNQMP_POLICY_EMULATOR) and includes
// nothing of the other; everything else is the same.
#pragma once

#if defined(RSI_ZYNQMP_POLICY_EMULATOR)
#include "hal/zynqmp_r5/emulator/emulator_policy.hpp"
#elif defined(RSI_ZYNQMP_POLICY_SILICON)
#include "hal/zynqmp_r5/silicon_policy.hpp"
#else
#error "which policy? rsi_add_r5f_image(NAME silicon|emulator ...) defines it"
#endif

namespace rsi::hal::zynqmp_r5 {

#if defined(RSI_ZYNQMP_POLICY_EMULATOR)
using Policy = EmulatorPolicy;
#else
using Policy = SiliconPolicy;
#endif

}  // namespace rsi::hal::zynqmp_r5
