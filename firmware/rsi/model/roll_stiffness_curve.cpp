#include "rsi/model/roll_stiffness_curve.hpp"

#include "rsi/numeric/square_root.hpp"

namespace rsi {
namespace {

constexpr float least_slope_share = 0.25F;  // of K_f
constexpr float furthest_rad = 1.5F;        // of any roll angle that the model is for

// The smallest z = phi^2 at which a + b z + c z^2 has fallen to zero, at most furthest_rad^2; a > 0.
float first_zero(float a, float b, float c) {
    constexpr float furthest = furthest_rad * furthest_rad;
    const float discriminant = b * b - 4.0F * a * c;
    if (discriminant < 0.0F) {
        return furthest;
    }
    const float divisor = square_root(discriminant) - b;
    return (2.0F * a < furthest * divisor) ? 2.0F * a / divisor : furthest;
}

}  // namespace

RollStiffnessCurve::RollStiffnessCurve(const Parameters& parameters, float factor)
    : linear_(factor * parameters.roll_stiffness_nmprad),
      cubic_(factor * parameters.roll_stiffness_cubic_nmprad3),
      quintic_(factor * parameters.roll_stiffness_quintic_nmprad5),
      slope_cubic_(3.0F * cubic_),
      slope_quintic_(5.0F * quintic_),
      // The same range whatever the factor.
      curved_to_rad_(square_root(first_zero((1.0F - least_slope_share) * parameters.roll_stiffness_nmprad,
                                            3.0F * parameters.roll_stiffness_cubic_nmprad3,
                                            5.0F * parameters.roll_stiffness_quintic_nmprad5))),
      line_slope_(linear_ + curved_to_rad_ * curved_to_rad_ *
                                (slope_cubic_ + curved_to_rad_ * curved_to_rad_ * slope_quintic_)) {}

}  // namespace rsi
