// A function that nobody calls.
// Caught by: clang -Wunused-function, g++ -Wunused-function
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

namespace {

std::uint32_t forgotten(std::uint32_t value) {
    return value;
}

}  // namespace
std::uint32_t violation(std::uint32_t value) {
    return value;
}

}  // namespace planted
