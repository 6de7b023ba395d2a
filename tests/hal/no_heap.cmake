# Fails when a library refers to the allocator. Use: cmake -DNM=... -DLIBRARIES=a.a,b.a -P no_heap.cmake
string(REPLACE "," ";" libraries "${LIBRARIES}")
foreach(library IN LISTS libraries)
    execute_process(COMMAND ${NM} -u ${library} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
    if(NOT symbols MATCHES "clock_gettime|_ZN3rsi3hal|mbedtls_platform_zeroize")
        message(FATAL_ERROR "${library}: ${NM} shows none of the symbols that must be there; the check is blind")
    endif()
    string(REGEX MATCHALL "[ \t](malloc|calloc|realloc|free|strdup|_Zn[wa][^ \n]*|_Zd[la][^ \n]*)(@[^\n]*)?\n"
        found "${symbols}")
    if(found)
        message(FATAL_ERROR "${library} uses the heap: ${found}")
    endif()
endforeach()
