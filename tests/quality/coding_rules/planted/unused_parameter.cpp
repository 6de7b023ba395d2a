// A parameter that nobody uses.
// Caught by: clang -Wunused-parameter, g++ -Wunused-parameter, misc-unused-parameters
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t one(std::uint32_t value) {
    return 1U;
}

}  // namespace planted
