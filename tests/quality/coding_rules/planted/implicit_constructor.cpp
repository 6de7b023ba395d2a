// A conversion that nobody asked for.
// Caught by: google-explicit-constructor
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

class Angle {
 public:
    Angle(float value_rad) : value_rad_{value_rad} {}
    float value_rad() const { return value_rad_; }

 private:
    float value_rad_;
};

}  // namespace planted
