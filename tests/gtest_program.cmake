# add_gtest_program(PROGRAM GROUP [ONCE FILTER])
#
# Registers the tests of a GoogleTest program under the ctest label GROUP, those that FILTER matches under GROUP.once: they take
# long and say little more under sanitizers, where they are left out. With sanitizers a program runs whole, in two halves:
# AddressSanitizer makes the start of a process take longer than most tests.
function(add_gtest_program program group)
    cmake_parse_arguments(PARSE_ARGV 2 tests "" "ONCE" "")
    if(RSI_SANITIZERS)
        foreach(half 0 1)
            add_test(NAME ${program}.${half} COMMAND ${program} --gtest_brief=1 --gtest_filter=-${tests_ONCE})
            set_tests_properties(${program}.${half} PROPERTIES
                LABELS ${group} ENVIRONMENT "GTEST_TOTAL_SHARDS=2;GTEST_SHARD_INDEX=${half}")
        endforeach()
        return()
    endif()
    gtest_discover_tests(${program} TEST_FILTER "-${tests_ONCE}" TEST_LIST ${program}_repeated PROPERTIES LABELS ${group})
    if(tests_ONCE)
        gtest_discover_tests(${program} TEST_FILTER "${tests_ONCE}" TEST_LIST ${program}_once
            PROPERTIES LABELS ${group}.once)
    endif()
endfunction()
