// Sentence: numbers for messages to people.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace fmu {

inline std::string text_of(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

// A float of a table as it is written there: 0.2F is 0.2.
inline double as_written(float value) {
    char text[32];
    for (int digits = 6; digits <= 9; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(value));
        if (std::strtof(text, nullptr) == value) {
            break;
        }
    }
    return std::strtod(text, nullptr);
}

}  // namespace fmu
