# Programs that run on every target: rsi_add_target_program(NAME SOURCE...) makes build/PRESET/targets/NAME (.elf on a
# board), which tests/targets/run_on_target starts. The sources give target::run(), see
# tests/targets/support/program.hpp; no libraries are linked but what target_link_libraries adds.

set(RSI_BOARD "" CACHE STRING
    "Board whose start-up code and linker script a program gets: mps2-an386, mps2-an500, xlnx-zcu102; empty with Linux")

function(rsi_add_target_program name)
    add_executable(${name} ${ARGN})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
    if(RSI_BOARD)
        target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/targets/support/bare_metal.cpp)
        target_link_libraries(${name} PRIVATE rsi_options_firmware hal_semihosting rsi_board)
        set_target_properties(${name} PROPERTIES SUFFIX .elf)
        target_link_options(${name} PRIVATE -Wl,-Map=${PROJECT_BINARY_DIR}/targets/${name}.map)
        if(RSI_BOARD STREQUAL "xlnx-zcu102")
            target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/targets/support/zynqmp_r5_exception.cpp)
        endif()
    else()
        target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/targets/support/linux.cpp)
        target_link_libraries(${name} PRIVATE rsi_options_firmware)
    endif()
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/targets)
endfunction()
