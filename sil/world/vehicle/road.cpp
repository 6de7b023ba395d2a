// Road surfaces: plane, banked circle, mirror image.
#include "sil/world/vehicle/road.hpp"

#include <cmath>
#include <utility>

namespace sil {

PlaneRoad::PlaneRoad(double bank_rad, double friction_factor) : slope_{std::tan(bank_rad)} {
    point_.normal = Vector3{0.0, -std::sin(bank_rad), std::cos(bank_rad)};
    point_.friction_factor = friction_factor;
}

RoadPoint PlaneRoad::at(double /*x_m*/, double y_m) const noexcept {
    RoadPoint point = point_;
    point.height_m = slope_ * y_m;
    return point;
}

BankedCircleRoad::BankedCircleRoad(double radius_m, double outer_bank_rad, double friction_factor)
    : radius_m_{radius_m},
      slope_{std::tan(outer_bank_rad)},
      cosine_{std::cos(outer_bank_rad)},
      sine_{std::sin(outer_bank_rad)},
      friction_factor_{friction_factor} {}

RoadPoint BankedCircleRoad::at(double x_m, double y_m) const noexcept {
    const double from_centre_y = y_m - radius_m_;
    const double distance = std::sqrt(x_m * x_m + from_centre_y * from_centre_y);
    const double inverse_distance = 1.0 / std::max(distance, 1.0);
    RoadPoint point;
    point.height_m = slope_ * (distance - radius_m_);
    point.normal =
        Vector3{-sine_ * x_m * inverse_distance, -sine_ * from_centre_y * inverse_distance, cosine_};
    point.friction_factor = friction_factor_;
    return point;
}

MirroredRoad::MirroredRoad(std::unique_ptr<const Road> original) : original_{std::move(original)} {}

RoadPoint MirroredRoad::at(double x_m, double y_m) const noexcept {
    RoadPoint point = original_->at(x_m, -y_m);
    point.normal.y() = -point.normal.y();
    point.beyond_kerb_m = -point.beyond_kerb_m;
    return point;
}

Vector3 MirroredRoad::mean_normal(double x_m, double y_m) const noexcept {
    Vector3 normal = original_->mean_normal(x_m, -y_m);
    normal.y() = -normal.y();
    return normal;
}

}  // namespace sil
