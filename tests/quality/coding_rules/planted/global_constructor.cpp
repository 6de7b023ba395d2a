// Code before main.
// Caught by: clang -Wglobal-constructors
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

struct Counter {
    std::uint32_t count{start()};
};
const Counter counter{};
std::uint32_t violation(std::uint32_t value) {
    return value + counter.count;
}

}  // namespace planted
