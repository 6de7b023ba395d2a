// Input error: what is wrong with a file or a value that was given.
#pragma once

#include <stdexcept>

namespace sil {

// Its what() names the place (file, line and key or column, or the option), what is wrong and what to do;
// ready to be shown.
class InputError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

}  // namespace sil
