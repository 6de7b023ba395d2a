// A member without a first value.
// Caught by: cppcoreguidelines-pro-type-member-init, modernize-use-equals-default
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

class Counter {
 public:
    Counter() {}
    std::uint32_t count() const { return count_; }

 private:
    std::uint32_t count_;
};

}  // namespace planted
