// A switch that forgets an enumerator.
// Caught by: clang -Wswitch, g++ -Wswitch
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t colour_violation(Colour colour) {
    std::uint32_t answer = 0U;
    switch (colour) {
        case Colour::red:
            answer = 1U;
            break;
        case Colour::green:
            answer = 2U;
            break;
    }
    return answer;
}

}  // namespace planted
