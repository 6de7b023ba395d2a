# Configures a project in a fresh folder, builds TARGET and runs the program RUN; either may be left empty.
#   cmake -DSOURCE=... -DFOLDER=... -DGENERATOR=... -DC_COMPILER=... -DCXX_COMPILER=... -DOPTIONS="-DA=1 -DB=2"
#         -DTARGET=... -DRUN=... -P fresh_build.cmake
file(REMOVE_RECURSE ${FOLDER})
separate_arguments(OPTIONS)
execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER} -G ${GENERATOR} -DCMAKE_C_COMPILER=${C_COMPILER}
            -DCMAKE_CXX_COMPILER=${CXX_COMPILER} ${OPTIONS}
    RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${SOURCE} cannot be configured with ${OPTIONS}")
endif()
if(TARGET)
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER} --target ${TARGET} RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "target ${TARGET} of ${SOURCE} cannot be built with ${OPTIONS}")
    endif()
endif()
if(RUN)
    execute_process(COMMAND ${FOLDER}/${RUN} RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${RUN} of ${SOURCE} ended with ${result}")
    endif()
endif()
