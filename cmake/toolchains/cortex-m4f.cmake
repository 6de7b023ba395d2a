# Arm Cortex-M4F: FPv4 unit, single precision only.
# Tuned as for the Cortex-R5, because g++'s costs of the Cortex-M4 take every a*b + c apart. Its VMLA rounds the product
# too, so the bits are those of the two instructions; it takes three cycles, as they do when the sum waits for the product.
set(processor_flags "-mcpu=cortex-m4 -mtune=cortex-r5 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
