#include "sil/studies/faults/turned_housings.hpp"

#include <array>

#include "sil/units.hpp"

namespace sil {
namespace {

constexpr std::array about_x_deg{2.0, 4.0, 6.0};
constexpr std::array about_z_deg{2.0, 6.0, 30.0};
constexpr std::array lasting_about_x_deg{4.0, 6.0};
constexpr std::array lasting_mps2{0.6, 1.0, 1.5};

// The fault in each sign; `error`: what of the sensors is wrong by it.
template <typename Error>
void add(std::vector<TurnedHousing>& all, const SensorOptions& usual, const Fault& fault,
         const Error& error) {
    for (const Fault& each : in_each_sign(fault)) {
        all.push_back({each, usual});
        error(all.back().options) = each.magnitude;
    }
}

void add_turned(std::vector<TurnedHousing>& all, const SensorOptions& usual, FaultKind kind, double angle_deg,
                double MountingTilt::* axis) {
    add(all, usual, {kind, FaultPlace::inertial_signals, angle_deg / degrees_per_radian},
        [axis](SensorOptions& options) -> double& { return options.imu.tilt.*axis; });
}

}  // namespace

std::vector<TurnedHousing> turned_housings(const SensorOptions& usual) {
    std::vector<TurnedHousing> all;
    for (const double angle_deg : about_x_deg) {
        add_turned(all, usual, FaultKind::turned_about_x, angle_deg, &MountingTilt::roll_rad);
    }
    for (const double angle_deg : about_z_deg) {
        add_turned(all, usual, FaultKind::turned_about_z, angle_deg, &MountingTilt::yaw_rad);
    }
    return all;
}

std::vector<TurnedHousing> lasting_offsets(const SensorOptions& usual) {
    std::vector<TurnedHousing> all;
    for (const double angle_deg : lasting_about_x_deg) {
        add_turned(all, usual, FaultKind::turned_about_x, angle_deg, &MountingTilt::roll_rad);
    }
    for (const double offset_mps2 : lasting_mps2) {
        add(all, usual, {FaultKind::offset, FaultPlace::lateral_acceleration, offset_mps2},
            [](SensorOptions& options) -> double& { return options.imu.lateral_acceleration_mps2.bias; });
    }
    return all;
}

}  // namespace sil
