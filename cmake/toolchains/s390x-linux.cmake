# IBM Z with Linux: no vehicle has one; it is here because it stores the most significant byte first.
set(CMAKE_SYSTEM_PROCESSOR s390x)
include(${CMAKE_CURRENT_LIST_DIR}/linux-cross.cmake)
