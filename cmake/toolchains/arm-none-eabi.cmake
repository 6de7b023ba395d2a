# Common to the bare-metal Arm targets: Debian's gcc-arm-none-eabi with newlib-nano, no operating system.
# A target's own file sets `processor_flags` and includes this one.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)

set(CMAKE_C_FLAGS_INIT "${processor_flags}")
# Debug information, stack use and call graph, which tests/targets/budgets reads; none of them changes the code.
set(analysis_flags "-g -fstack-usage -fcallgraph-info=su")
set(CMAKE_CXX_FLAGS_INIT "${processor_flags} ${analysis_flags} -fno-exceptions -fno-rtti -fno-threadsafe-statics")
set(CMAKE_ASM_FLAGS_INIT "${processor_flags}")
set(CMAKE_EXE_LINKER_FLAGS_INIT "--specs=nano.specs -nostartfiles -Wl,--gc-sections")

# The compiler is tried without linking: a program needs a board's start-up code and linker script.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Nothing of the host's may be found by accident; Eigen, headers without a library, is named.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(Eigen3_DIR /usr/share/eigen3/cmake CACHE PATH "Eigen's CMake package (Debian: libeigen3-dev)")
