// A function of the base is hidden.
// Caught by: clang -Woverloaded-virtual, cppcoreguidelines-special-member-functions, g++
// -Woverloaded-virtual
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

class Base {
 public:
    Base(const Base&) = delete;
    Base& operator=(const Base&) = delete;
    virtual void set(std::uint32_t value) = 0;

 protected:
    Base() = default;
    ~Base() = default;
};

class Derived : public Base {
 public:
    virtual void set(float value) = 0;

 protected:
    Derived() = default;
    ~Derived() = default;
};

}  // namespace planted
