// Path follower: a driver's hands that steer towards a point ahead on the wanted path.
#pragma once

#include "sil/world/vehicle/parameters.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

struct PathPoint {
    double x_m{0.0};
    double y_m{0.0};
};

// Steers for the lateral acceleration that would bring the vehicle, on an arc, from where it is and the
// direction in which it moves to a point that it will reach after the preview time. Knows how much handwheel
// the vehicle needs for that.
class PathFollower {
 public:
    // `understeer_gradient_s2pm`: extra road wheel angle per lateral acceleration.
    PathFollower(const VehicleParameters& parameters, double understeer_gradient_s2pm, double preview_s)
        : ratio_{parameters.steering.ratio},
          wheelbase_m_{wheelbase_m(parameters.geometry)},
          understeer_gradient_s2pm_{understeer_gradient_s2pm},
          preview_s_{preview_s} {}

    // How far ahead the driver looks.
    double preview_m(const Truth& truth) const;

    // `target`: on the path, `preview_m` ahead.
    double handwheel_rad(const Truth& truth, const PathPoint& target) const;

 private:
    double ratio_;
    double wheelbase_m_;
    double understeer_gradient_s2pm_;
    double preview_s_;
};

// From the handwheel angle that gives 0.3 g at 50 mph (see slowly_increasing_steer.hpp).
double understeer_gradient_s2pm(const VehicleParameters& parameters, double handwheel_at_0_3_g_rad);

}  // namespace sil
