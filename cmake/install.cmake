# Files that `cmake --install` puts in place for find_package(rsi) in another project; docs/integration.md.
#   rsi::rsi            the component, with its C interface and its C++ one
#   rsi::application    around it the frames: end-to-end check, freshness, encoding, diagnosis, parameter section
#   rsi::access         seed and key for XCP and UDS, for the application too
#   rsi::diagnosis      trouble codes, ISO-TP and UDS beside the application, on request
#   rsi::calibration_pages, rsi::xcp    XCP on CAN around the application, on request
#   rsi::can_dbc, rsi::hal_interface    headers that the application stands on
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(rsi_installed rsi access application calibration_pages diagnosis xcp can_dbc hal_interface)
foreach(target IN LISTS rsi_installed)
    add_library(rsi::${target} ALIAS ${target})  # one name, however the project was taken in
endforeach()
set_target_properties(access PROPERTIES OUTPUT_NAME rsi_access)
set_target_properties(application PROPERTIES OUTPUT_NAME rsi_application)
set_target_properties(calibration_pages PROPERTIES OUTPUT_NAME rsi_calibration_pages)
set_target_properties(xcp PROPERTIES OUTPUT_NAME rsi_xcp)
set_target_properties(diagnosis PROPERTIES OUTPUT_NAME rsi_diagnosis)

if(NOT PROJECT_IS_TOP_LEVEL)
    return()
endif()

# The folders have general names, so they get one of their own.
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/rsi_component)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/rsi)
set(header_patterns FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")

install(TARGETS ${rsi_installed} EXPORT rsiTargets INCLUDES DESTINATION ${headers})
install(DIRECTORY firmware/rsi can_dbc/include/rsi hal/interface/rsi DESTINATION ${headers} ${header_patterns})
install(DIRECTORY firmware/calibrations DESTINATION ${CMAKE_INSTALL_DATADIR}/rsi)
install(DIRECTORY firmware/selftest firmware/calibrations DESTINATION ${headers} ${header_patterns})
install(FILES firmware/selftest/selftest.c can_dbc/rollover_warning.dbc LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/rsi)

install(EXPORT rsiTargets NAMESPACE rsi:: DESTINATION ${package})
configure_package_config_file(cmake/rsiConfig.cmake.in ${PROJECT_BINARY_DIR}/rsiConfig.cmake
    INSTALL_DESTINATION ${package} PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rsiConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rsiConfig.cmake ${PROJECT_BINARY_DIR}/rsiConfigVersion.cmake
    DESTINATION ${package})
