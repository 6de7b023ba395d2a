/* Memory map of the image, for the linker script, assembly and C++ alike. docs/targets.md describes it.
 *
 * Each part is a region of the memory protection unit (startup/memory_protection.cpp): its size is a power of
 * two and its start a multiple of that. */
#ifndef HAL_ZYNQMP_R5_MEMORY_MAP_H
#define HAL_ZYNQMP_R5_MEMORY_MAP_H

/* The exception vectors: the core has no vector base register. ATCM on silicon. */
#define RSI_VECTORS_START 0x00000000
#define RSI_VECTORS_SIZE 0x40

#define RSI_CODE_START 0x00100000
#define RSI_CODE_SIZE 0x20000

#define RSI_PARAMETERS_START 0x00120000
#define RSI_PARAMETERS_SIZE 0x1000

#define RSI_DATA_START 0x00130000
#define RSI_DATA_SIZE 0x8000

/* Eight parts of 2 KiB. From below: guard, stack of the exceptions, guard, two parts main stack, three parts
 * guard. */
#define RSI_STACKS_START 0x00138000
#define RSI_STACKS_SIZE 0x4000
#define RSI_FAULT_STACK_BOTTOM 0x00138800
#define RSI_FAULT_STACK_TOP 0x00139000
#define RSI_MAIN_STACK_BOTTOM 0x00139800
#define RSI_MAIN_STACK_TOP 0x0013A800

/* Neither cleared at a start nor cached. */
#define RSI_RETAINED_START 0x0013C000
#define RSI_RETAINED_SIZE 0x1000

/* From here to the end of the retained memory nothing of the image may lie: the emulator keeps words of its
 * own there (emulator/supervisor_words.h). */
#define RSI_RETAINED_FREE 0x0013CFF0

#endif
