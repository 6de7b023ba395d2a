#include "sil/studies/faults/turned_housings.hpp"

#include <array>

#include "sil/units.hpp"

namespace sil {
namespace {

constexpr std::array about_x_deg{2.0, 4.0, 6.0};
constexpr std::array about_z_deg{2.0, 6.0, 30.0};
constexpr std::array lasting_about_x_deg{4.0, 6.0};
constexpr std::array lasting_mps2{0.6, 1.0, 1.5};

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

std::vector<TurnedHousing> lasting_offsets(const SensorOptions& usual) {
    std::vector<TurnedHousing> all;
    for (const double angle_deg : lasting_about_x_deg) {
        const Fault turned{FaultKind::turned_about_x, FaultPlace::inertial_signals,
                           angle_deg / degrees_per_radian};
        for (const Fault& fault : in_each_sign(turned)) {
            all.push_back({fault, usual});
            all.back().options.imu.tilt.roll_rad = fault.magnitude;
        }
    }
    for (const double offset_mps2 : lasting_mps2) {
        const Fault offset{FaultKind::offset, FaultPlace::lateral_acceleration, offset_mps2};
        for (const Fault& fault : in_each_sign(offset)) {
            all.push_back({fault, usual});
            all.back().options.imu.lateral_acceleration_mps2.bias = fault.magnitude;
        }
    }
    return all;
}

}  // namespace sil
