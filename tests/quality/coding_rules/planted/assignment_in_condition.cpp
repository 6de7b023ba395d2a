// An assignment where a question was meant.
// Caught by: bugprone-assignment-in-if-condition
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

bool is_violation(std::uint32_t value) {
    bool answer = false;
    if ((answer = (value > 7U))) {
        use(value);
    }
    return answer;
}

}  // namespace planted
