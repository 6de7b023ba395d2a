# cmake --build --preset release --target package: the release of this commit, in build/package; see CONTRIBUTING.md.
if(RSI_BUILD_SIL AND PROJECT_IS_TOP_LEVEL AND PROJECT_BINARY_DIR STREQUAL "${PROJECT_SOURCE_DIR}/build/release")
    set(installed ${rsi_installed})
    list(REMOVE_ITEM installed can_dbc hal_interface)  # headers
    add_custom_target(package
        COMMAND ${PROJECT_SOURCE_DIR}/cmake/environment/build cortex-r5f rsi-ecu-r5f ${installed}
        COMMAND ${PROJECT_SOURCE_DIR}/cmake/release/package
        DEPENDS rsi-sil rsi-ecu a2l odx-table rsi_wheel ${installed}
        USES_TERMINAL VERBATIM)
endif()
