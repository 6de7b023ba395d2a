# Arm Cortex-R5F: real-time processors of the XA Zynq UltraScale+ MPSoC; Arm instructions, VFPv3 with 16 registers.
set(processor_flags "-mcpu=cortex-r5 -marm -mfpu=vfpv3-d16 -mfloat-abi=hard")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
