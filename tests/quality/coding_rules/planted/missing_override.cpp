// An override that does not say so.
// Caught by: clang -Wsuggest-override, g++ -Wsuggest-override, modernize-use-override
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

class Base {
 public:
    Base(const Base&) = delete;
    Base& operator=(const Base&) = delete;
    virtual std::uint32_t value() const = 0;

 protected:
    Base() = default;
    ~Base() = default;
};

class Derived final : public Base {
 public:
    std::uint32_t value() const { return 1U; }
};

}  // namespace planted
