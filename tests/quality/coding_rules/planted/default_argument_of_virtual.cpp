// A default that depends on the type of the pointer.
// Caught by: google-default-arguments
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

class Base {
 public:
    Base(const Base&) = delete;
    Base& operator=(const Base&) = delete;
    virtual void set(std::uint32_t value = 1U) = 0;

 protected:
    Base() = default;
    ~Base() = default;
};

}  // namespace planted
