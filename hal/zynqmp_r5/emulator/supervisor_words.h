/* The emulator's supervisor and the image: what they share, for assembly and C++ alike
 * (firmware/images/zynqmp_r5/emulator/release.S). */
#ifndef HAL_ZYNQMP_R5_EMULATOR_SUPERVISOR_WORDS_H
#define HAL_ZYNQMP_R5_EMULATOR_SUPERVISOR_WORDS_H

#include "hal/zynqmp_r5/memory_map.h"

#define RSI_SUPERVISOR_COUNTDOWN RSI_RETAINED_FREE
#define RSI_SUPERVISOR_PERIOD_MS 10

#endif
