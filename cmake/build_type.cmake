# Without a build type CMake compiles without an optimiser: a step then takes many times the instructions, and more stack.
# The default here is Release with -O2, as in the documented figures. A preset, another build type, and an -O among the flags,
# as an integrator's toolchain file may have one, come before it.
get_property(several_build_types GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(several_build_types OR CMAKE_BUILD_TYPE OR CMAKE_CXX_FLAGS MATCHES "(^| )-O")
    return()
endif()
if(NOT PROJECT_IS_TOP_LEVEL)
    # The project around this one decides, for all of its parts.
    message(WARNING "rsi is compiled without an optimiser, as CMAKE_BUILD_TYPE is empty: right, but a step takes many "
        "times the instructions. Configure with -DCMAKE_BUILD_TYPE=Release, or give an -O among CMAKE_CXX_FLAGS.")
    return()
endif()
set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
foreach(language C CXX)
    string(REPLACE -O3 -O2 flags "${CMAKE_${language}_FLAGS_RELEASE}")
    set(CMAKE_${language}_FLAGS_RELEASE ${flags} CACHE STRING "Flags of the build type Release" FORCE)
endforeach()
message(STATUS "rsi: no build type was given; building Release with -O2")
