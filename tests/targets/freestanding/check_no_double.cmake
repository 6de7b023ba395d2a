# Fails when an archive computes in double precision: many targets have hardware for float only.
#   cmake -DOBJDUMP=objdump -DARCHIVE=librsi.a -P check_no_double.cmake
set(x86 "\t(v?(add|sub|mul|div|sqrt|min|max|ucomi|comi)(sd|pd)|v?cvt[a-z0-9]*[sp]d[a-z0-9]*)[ \t]")
set(arm "\tf[a-z]+[ \t]+d[0-9]")

execute_process(COMMAND ${OBJDUMP} --disassemble --no-show-raw-insn ${ARCHIVE}
                OUTPUT_VARIABLE listing RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR NOT listing MATCHES "\tret")
    message(FATAL_ERROR "${OBJDUMP} cannot disassemble ${ARCHIVE}")
endif()
# Semicolons and brackets would be list syntax.
string(REGEX REPLACE "[][;]" "" listing "${listing}")
string(REPLACE "\n" ";" lines "${listing}")
foreach(line IN LISTS lines)
    if(line MATCHES "^[0-9a-f]+ <(.*)>:$")
        set(function "${CMAKE_MATCH_1}")
    elseif(line MATCHES "${x86}" OR line MATCHES "${arm}")
        message(FATAL_ERROR "${ARCHIVE} computes in double precision in ${function}: ${line}")
    endif()
endforeach()
