// An error that is thrown.
// Caught by: clang compile-error, clang-diagnostic-error, exceptions, g++ compile-error
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t violation(std::uint32_t value) {
    if (value > 7U) {
        throw value;
    }
    return value;
}

}  // namespace planted
