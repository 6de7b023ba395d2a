// A class that can be destroyed by half.
// Caught by: clang -Wnon-virtual-dtor, cppcoreguidelines-special-member-functions,
// cppcoreguidelines-virtual-class-destructor, g++ -Wnon-virtual-dtor
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

class Base {
 public:
    Base(const Base&) = delete;
    Base& operator=(const Base&) = delete;
    Base() = default;
    virtual std::uint32_t value() const = 0;
};

}  // namespace planted
