// All names of a namespace at once.
// Caught by: google-build-using-namespace
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

using namespace std;
std::uint32_t violation(std::uint32_t value) {
    return value;
}

}  // namespace planted
