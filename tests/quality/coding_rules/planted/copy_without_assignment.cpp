// Copied one way, not the other.
// Caught by: cppcoreguidelines-special-member-functions, modernize-use-equals-default
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

class Handle {
 public:
    explicit Handle(std::uint32_t value) : value_{value} {}
    Handle(const Handle& other) : value_{other.value_} {}
    std::uint32_t value() const { return value_; }

 private:
    std::uint32_t value_;
};

}  // namespace planted
