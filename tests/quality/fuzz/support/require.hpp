// Assertions of a fuzz target. An input that breaks it ends the program, which libFuzzer reports and keeps.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace fuzz {

// Ends the program with `what` unless `holds`.
inline void require(bool holds, const char* what) {
    if (!holds) {
        std::fprintf(stderr, "broken: %s\n", what);
        std::abort();
    }
}

}  // namespace fuzz
