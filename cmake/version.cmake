# The version number has its home in project(rsi VERSION ...). firmware/rsi/version.h repeats it, and is committed because
# the firmware also compiles without CMake; it must say the same.
set(rsi_committed_version ${PROJECT_SOURCE_DIR}/firmware/rsi/version.h)
set(rsi_expected_version ${PROJECT_BINARY_DIR}/version.h)
if(PROJECT_VERSION_MAJOR GREATER 15 OR PROJECT_VERSION_MINOR GREATER 15)
    message(FATAL_ERROR "version ${PROJECT_VERSION}: major and minor number share a byte on the bus, so each is at most 15")
endif()
math(EXPR rsi_version_byte "16 * ${PROJECT_VERSION_MAJOR} + ${PROJECT_VERSION_MINOR}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/version.h.in ${rsi_expected_version} @ONLY NEWLINE_STYLE UNIX)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${rsi_committed_version})

file(READ ${rsi_expected_version} expected)
set(committed "")
if(EXISTS ${rsi_committed_version})
    file(READ ${rsi_committed_version} committed)
endif()
if(NOT committed STREQUAL expected)
    message(FATAL_ERROR "firmware/rsi/version.h does not say ${PROJECT_VERSION}, as CMakeLists.txt does; run:\n"
        "  cp ${rsi_expected_version} ${rsi_committed_version}")
endif()
