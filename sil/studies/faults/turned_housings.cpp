#include "sil/studies/faults/turned_housings.hpp"

#include <array>

#include "sil/units.hpp"

namespace sil {
namespace {

constexpr std::array about_x_deg{2.0, 4.0, 6.0};
constexpr std::array about_z_deg{2.0, 6.0, 30.0};

}  // namespace

std::vector<TurnedHousing> turned_housings(const SensorOptions& usual) {
    std::vector<TurnedHousing> all;
    const auto add = [&](FaultKind kind, double angle_deg, double MountingTilt::* axis) {
        const Fault turned{kind, FaultPlace::inertial_signals, angle_deg / degrees_per_radian};
        for (const Fault& fault : in_each_sign(turned)) {
            all.push_back({fault, usual});
            all.back().options.imu.tilt.*axis = fault.magnitude;
        }
    };
    for (const double angle_deg : about_x_deg) {
        add(FaultKind::turned_about_x, angle_deg, &MountingTilt::roll_rad);
    }
    for (const double angle_deg : about_z_deg) {
        add(FaultKind::turned_about_z, angle_deg, &MountingTilt::yaw_rad);
    }
    return all;
}

}  // namespace sil
