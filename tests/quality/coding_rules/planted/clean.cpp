// Nothing: the words new, throw and double, in a comment or a "goto" in a text, are no violation.
// Caught by: nothing
#include "tests/quality/coding_rules/planted/planted.hpp"

#include <array>

namespace planted {
namespace {

constexpr std::array<std::uint32_t, 3> table{1U, 2U, 3U};

constexpr const char* words = "malloc, while (true), 0.5 and reinterpret_cast";

class Counter {
 public:
    void time(std::uint32_t by) { count_ += by; }
    std::uint32_t count() const { return count_; }

 private:
    std::uint32_t count_{0U};
};

}  // namespace

std::uint32_t violation(std::uint32_t value) {
    Counter counter;
    for (const std::uint32_t entry : table) {
        counter.time(entry);
    }
    std::uint32_t answer = 0U;
    if (value > counter.count()) {
        answer = value;
    } else if (*words == 'm') {
        answer = counter.count();
    } else {
        // Neither.
    }
    return answer;
}

}  // namespace planted
