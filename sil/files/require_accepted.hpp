// For programs, which go no further with parameters that the firmware refuses.
#pragma once

#include <stdexcept>
#include <string>

#include "rsi/types.hpp"

namespace sil {

// Throws std::invalid_argument with a sentence of the field's name and the reason when the parameters are
// refused.
inline void require_accepted(const rsi::Validation& answer) {
    if (answer.accepted == 0) {
        throw std::invalid_argument("the component refuses its parameter " + std::string{answer.field} +
                                    ": " + answer.reason);
    }
}

}  // namespace sil
