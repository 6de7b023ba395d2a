# The structures of the C interface, by a C compiler with either size of enumerations: on the host for the unit tests, on the
# controllers because what does not compile there is a difference.
foreach(enums with_short_enums without_short_enums)
    add_library(layout_${enums} OBJECT ${CMAKE_CURRENT_LIST_DIR}/enum_layout.c)
    set_target_properties(layout_${enums} PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
    target_compile_definitions(layout_${enums} PRIVATE PROBE=layout_${enums})
    target_include_directories(layout_${enums} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/firmware)
endforeach()
target_compile_options(layout_with_short_enums PRIVATE ${RSI_C_WARNINGS} -fshort-enums)
target_compile_options(layout_without_short_enums PRIVATE ${RSI_C_WARNINGS} -fno-short-enums)
