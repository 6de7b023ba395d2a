// Trip roads: level ones on whose left something stops a vehicle that slides sideways.
#pragma once

#include "sil/world/vehicle/road.hpp"

namespace sil {

// A kerb along the x axis whose face is at y = `face_y_m`, `height_m` high. The ground behind it is on the
// level of the road, where no wheel gets.
class KerbRoad final : public Road {
 public:
    KerbRoad(double face_y_m, double height_m, double friction_factor);
    RoadPoint at(double x_m, double y_m) const noexcept override;

 private:
    double face_y_m_;
    double height_m_;
    double friction_factor_;
};

// Soft ground from y = `edge_y_m` on, complete half a metre further.
class SoftShoulderRoad final : public Road {
 public:
    // `softness`: see RoadPoint. Friction factors are those of the road and of the soft ground.
    SoftShoulderRoad(double edge_y_m, double softness, double friction_factor, double soft_friction_factor);
    RoadPoint at(double x_m, double y_m) const noexcept override;

 private:
    double edge_y_m_;
    double softness_;
    double friction_factor_;
    double soft_friction_factor_;
};

}  // namespace sil
