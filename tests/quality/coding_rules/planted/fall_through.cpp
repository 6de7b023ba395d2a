// A case that falls into the next.
// Caught by: clang -Wimplicit-fallthrough, g++ -Wimplicit-fallthrough=
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

std::uint32_t colour_violation(Colour colour) {
    std::uint32_t answer = 0U;
    switch (colour) {
        case Colour::red:
            answer = 1U;
        case Colour::green:
            answer += 2U;
            break;
        case Colour::blue:
            answer = 3U;
            break;
    }
    return answer;
}

}  // namespace planted
