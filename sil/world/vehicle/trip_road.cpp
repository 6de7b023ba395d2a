#include "sil/world/vehicle/trip_road.hpp"

#include <algorithm>

namespace sil {

KerbRoad::KerbRoad(double face_y_m, double height_m, double friction_factor)
    : face_y_m_{face_y_m}, height_m_{height_m}, friction_factor_{friction_factor} {}

RoadPoint KerbRoad::at(double /*x_m*/, double y_m) const noexcept {
    RoadPoint point;
    point.friction_factor = friction_factor_;
    if (y_m > face_y_m_) {
        point.beyond_kerb_m = y_m - face_y_m_;
        point.kerb_height_m = height_m_;
    }
    return point;
}

SoftShoulderRoad::SoftShoulderRoad(double edge_y_m, double softness, double friction_factor,
                                   double soft_friction_factor)
    : edge_y_m_{edge_y_m},
      softness_{softness},
      friction_factor_{friction_factor},
      soft_friction_factor_{soft_friction_factor} {}

RoadPoint SoftShoulderRoad::at(double /*x_m*/, double y_m) const noexcept {
    constexpr double transition_m = 0.5;
    const double share = std::clamp((y_m - edge_y_m_) / transition_m, 0.0, 1.0);
    RoadPoint point;
    point.friction_factor = friction_factor_ + share * (soft_friction_factor_ - friction_factor_);
    point.softness = share * softness_;
    return point;
}

}  // namespace sil
