// Allocation count: how often this program has asked for heap memory, by whatever way.
#pragma once

#include <cstdint>

namespace testing_application {

// Counts of malloc, calloc, realloc and the aligned kinds; operator new comes down to them.
std::uint64_t allocation_count();

}  // namespace testing_application
