// A definition that every unit repeats.
// Caught by: clang -Wmissing-prototypes, g++ -Wmissing-declarations, misc-definitions-in-headers
#pragma once

#include <cstdint>

namespace planted {

std::uint32_t twice(std::uint32_t value) {
    return 2U * value;
}

}  // namespace planted
