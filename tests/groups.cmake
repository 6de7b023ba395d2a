# A test's groups are the folders that it is in: a test of tests/sil/drives has the ctest labels `sil` and `drives`.
# Labels of another kind stand behind them:
#   once         takes long and says little more under sanitizers: left out there
#   vcan         needs a CAN interface; tests/run gives it one
#   on_request   not part of any group that tests/run runs by default

# The groups of the folder that this is called in.
function(folder_groups result)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/tests ${CMAKE_CURRENT_SOURCE_DIR})
    string(REPLACE "/" ";" groups "${folder}")
    set(${result} ${groups} PARENT_SCOPE)
endfunction()

# label_tests([ONCE TEST...] [VCAN TEST...] [ON_REQUEST TEST...]): the last line of a folder with tests made by add_test.
function(label_tests)
    cmake_parse_arguments(PARSE_ARGV 0 tests "" "" "ONCE;VCAN;ON_REQUEST")
    folder_groups(groups)
    get_property(all DIRECTORY PROPERTY TESTS)
    foreach(test IN LISTS all)
        get_property(labels TEST ${test} PROPERTY LABELS)
        if(NOT labels)  # a program's tests have theirs
            set_property(TEST ${test} PROPERTY LABELS ${groups})
        endif()
    endforeach()
    foreach(kind once vcan on_request)
        string(TOUPPER ${kind} list)
        foreach(test IN LISTS tests_${list})
            set_property(TEST ${test} APPEND PROPERTY LABELS ${kind})
        endforeach()
    endforeach()
endfunction()

# add_gtest_program(PROGRAM [ONCE FILTER] [LABELS LABEL...] [PROPERTIES NAME VALUE...])
#
# Registers the tests of a GoogleTest program; those that FILTER matches run once. With sanitizers a program runs whole, in
# two halves: AddressSanitizer makes the start of a process take longer than most tests.
function(add_gtest_program program)
    cmake_parse_arguments(PARSE_ARGV 1 tests "" "ONCE" "LABELS;PROPERTIES")
    folder_groups(groups)
    set(labels ${groups} ${tests_LABELS})
    if(RSI_SANITIZERS)
        foreach(half 0 1)
            add_test(NAME ${program}.${half} COMMAND ${program} --gtest_brief=1 --gtest_filter=-${tests_ONCE})
            set_tests_properties(${program}.${half} PROPERTIES
                LABELS "${labels}" ENVIRONMENT "GTEST_TOTAL_SHARDS=2;GTEST_SHARD_INDEX=${half}")
        endforeach()
        return()
    endif()
    gtest_discover_tests(${program} TEST_FILTER "-${tests_ONCE}" TEST_LIST ${program}_repeated
        PROPERTIES LABELS "${labels}" ${tests_PROPERTIES})
    if(tests_ONCE)
        gtest_discover_tests(${program} TEST_FILTER "${tests_ONCE}" TEST_LIST ${program}_once
            PROPERTIES LABELS "${labels};once" ${tests_PROPERTIES})
    endif()
endfunction()
