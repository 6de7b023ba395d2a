# Two sets of compile options, as interface targets:
#   rsi_options_host       warnings and floating-point rules for everything that runs on a host
#   rsi_options_firmware   the same, and what an embedded target forbids: exceptions, RTTI, guarded statics
#
# -ffp-contract=off keeps the compiler from fusing a*b+c, which changes the last bit from target to target.
# -fno-math-errno lets sqrt become one instruction; sqrt is correctly rounded on every target.

option(RSI_WARNINGS_AS_ERRORS "Treat every compiler warning as an error" OFF)
option(RSI_UNITY_BUILDS "Compile the sources of a target together: quick from scratch, slow after one changed line" ON)
set(RSI_SANITIZERS "" CACHE STRING "Sanitizers for all targets, for example address,undefined")

add_library(rsi_options_host INTERFACE)
target_compile_features(rsi_options_host INTERFACE cxx_std_17)
target_compile_options(rsi_options_host INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wcast-align
    $<$<COMPILE_LANGUAGE:CXX>:-Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual>
    $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion>  # clang means double{x} too, where it is wanted
    $<$<BOOL:${RSI_WARNINGS_AS_ERRORS}>:-Werror>
    -ffp-contract=off -fno-math-errno)
if(RSI_SANITIZERS)
    target_compile_options(rsi_options_host INTERFACE
        -fsanitize=${RSI_SANITIZERS} -fno-sanitize-recover=all -fno-omit-frame-pointer
        -fno-sanitize=vptr  # wants the type information that the firmware does not have
        # Outside the firmware AddressSanitizer, which notices the access, is enough: these take much time.
        -fno-sanitize=null,object-size,pointer-overflow)
    target_link_options(rsi_options_host INTERFACE -fsanitize=${RSI_SANITIZERS})
endif()

# Copied, not linked: linked options would come last and switch the checks of pointers off again.
add_library(rsi_options_firmware INTERFACE)
target_compile_features(rsi_options_firmware INTERFACE cxx_std_17)
get_target_property(rsi_host_options rsi_options_host INTERFACE_COMPILE_OPTIONS)
target_compile_options(rsi_options_firmware INTERFACE ${rsi_host_options}
    -fno-exceptions $<$<COMPILE_LANGUAGE:CXX>:-fno-rtti -fno-threadsafe-statics> -ffunction-sections -fdata-sections)
if(RSI_SANITIZERS)
    target_link_options(rsi_options_firmware INTERFACE -fsanitize=${RSI_SANITIZERS})
endif()
if(RSI_SANITIZERS MATCHES "undefined")
    target_compile_options(rsi_options_firmware INTERFACE -fsanitize=null,object-size,pointer-overflow)
endif()

# Warnings that make no sense for C sources (the C99 test of the C interface compiles with a subset of its own).
set(RSI_C_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow
    $<$<BOOL:${RSI_WARNINGS_AS_ERRORS}>:-Werror>)
