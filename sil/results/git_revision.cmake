# Writes OUTPUT, a header with the git revision of SOURCE_DIR; an empty revision where git or the history is missing.
find_program(git git)
set(revision "")
if(git)
    execute_process(COMMAND ${git} -C ${SOURCE_DIR} describe --always --dirty --abbrev=12
        OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
set(content "#define RSI_GIT_REVISION \"${revision}\"\n")

set(previous "")
if(EXISTS ${OUTPUT})
    file(READ ${OUTPUT} previous)
endif()
if(NOT content STREQUAL previous)
    file(WRITE ${OUTPUT} "${content}")
endif()
