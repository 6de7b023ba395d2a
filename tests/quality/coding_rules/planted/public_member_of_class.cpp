// A class half open.
// Caught by: misc-non-private-member-variables-in-classes
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

class Counter {
 public:
    void count() { count_ = count_ + step; }
    std::uint32_t value() const { return count_; }
    std::uint32_t step{1U};

 private:
    std::uint32_t count_{0U};
};

}  // namespace planted
