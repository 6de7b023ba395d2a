# A test has one ctest label: the folder that it is in, from tests/, as sil/drives. Behind it may stand, each after a colon,
#   once         takes long and says little more under sanitizers: left out there
#   vcan         needs a CAN interface; tests/run gives it one
#   on_request   not part of any group that tests/run runs by default
#   command      with sanitizers, tests of sil's commands: rsi-sil holds every study

# The group of the folder that this is called in.
function(folder_group result)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/tests ${CMAKE_CURRENT_SOURCE_DIR})
    set(${result} ${folder} PARENT_SCOPE)
endfunction()

# label_tests([ONCE TEST...] [VCAN TEST...] [ON_REQUEST TEST...]): the last line of a folder with tests made by add_test.
function(label_tests)
    cmake_parse_arguments(PARSE_ARGV 0 tests "" "" "ONCE;VCAN;ON_REQUEST")
    folder_group(group)
    get_property(all DIRECTORY PROPERTY TESTS)
    foreach(test IN LISTS all)
        get_property(label TEST ${test} PROPERTY LABELS)
        if(label)  # a program's tests have theirs
            continue()
        endif()
        set(label ${group})
        if(RSI_SANITIZERS AND group MATCHES "^sil/")
            string(APPEND label :command)
        endif()
        foreach(kind once vcan on_request)
            string(TOUPPER ${kind} list)
            if(test IN_LIST tests_${list})
                string(APPEND label :${kind})
            endif()
        endforeach()
        set_property(TEST ${test} PROPERTY LABELS ${label})
    endforeach()
endfunction()

# add_gtest_program(PROGRAM [ONCE FILTER] [VCAN] [COMMAND]): registers the tests of a GoogleTest program; those that FILTER
# matches run once. VCAN: one after the other, because they share the interface. COMMAND: they start rsi-sil. With
# sanitizers a program runs whole, in two halves: AddressSanitizer makes the start of a process take longer than most
# tests.
function(add_gtest_program program)
    cmake_parse_arguments(PARSE_ARGV 1 tests "VCAN;COMMAND" "ONCE" "")
    folder_group(group)
    if(RSI_SANITIZERS)
        if(tests_COMMAND)
            string(APPEND group :command)
        endif()
        foreach(half 0 1)
            add_test(NAME ${program}.${half} COMMAND ${program} --gtest_brief=1 --gtest_filter=-${tests_ONCE})
            set_tests_properties(${program}.${half} PROPERTIES
                LABELS ${group} ENVIRONMENT "GTEST_TOTAL_SHARDS=2;GTEST_SHARD_INDEX=${half}")
        endforeach()
        return()
    endif()
    set(properties LABELS ${group})
    if(tests_VCAN)
        set(properties LABELS ${group}:vcan RESOURCE_LOCK can_interface)
    endif()
    gtest_discover_tests(${program} TEST_FILTER "-${tests_ONCE}" TEST_LIST ${program}_repeated PROPERTIES ${properties})
    if(tests_ONCE)
        gtest_discover_tests(${program} TEST_FILTER "${tests_ONCE}" TEST_LIST ${program}_once PROPERTIES LABELS ${group}:once)
    endif()
endfunction()
