#include "tests/sil/identification/known_body.hpp"

#include <algorithm>
#include <cmath>

#include "sil/units.hpp"

namespace identification_test {
namespace {

constexpr double step_s = 1.0e-4;
constexpr int steps_a_sample = 100;

struct RollState {
    double angle{};
    double rate{};
    double acceleration{};
};

// Along the road and normal to it.
struct Force {
    double parallel_mps2{};
    double normal_mps2{};
};

Force on_the_road(double lateral_mps2, double bank_rad) {
    return {lateral_mps2 * std::cos(bank_rad) + sil::g_mps2 * std::sin(bank_rad),
            sil::g_mps2 * std::cos(bank_rad) - lateral_mps2 * std::sin(bank_rad)};
}

// m_s H (A + N tan phi) = M(phi) + c phi' + Ixx phi''
double roll_acceleration(const KnownBody& body, const RollState& state, const Force& force) {
    const double arm_m = body.sprung_cg_height_m - body.roll_centre_height_m;
    const double tipping_nm =
        body.sprung_mass_kg * arm_m * (force.parallel_mps2 + force.normal_mps2 * std::tan(state.angle));
    return (tipping_nm - body.moment_nm(state.angle) - body.damping_nmsprad * state.rate) / body.inertia_kgm2;
}

void set_wheel_loads(const KnownBody& body, const RollState& state, double lateral_mps2,
                     sil::DriveSample& sample) {
    const double alpha =
        body.sprung_mass_kg * body.roll_centre_height_m + body.unsprung_mass_kg * body.unsprung_cg_height_m;
    const double moment_nm =
        alpha * lateral_mps2 + body.moment_nm(state.angle) + body.damping_nmsprad * state.rate;
    const double quarter_n = 0.25 * (body.sprung_mass_kg + body.unsprung_mass_kg) * sil::g_mps2;
    const double transferred_n = 0.5 * moment_nm / body.track_width_m;
    sample.wheel_load_n = {quarter_n - transferred_n, quarter_n + transferred_n, quarter_n - transferred_n,
                           quarter_n + transferred_n};
}

// The IMU's forces from those at the CG, with the rigid body's kinematics and no pitch.
void set_forces(const KnownBody& body, const RollState& state, const Force& force, double yaw_rate,
                double yaw_acceleration, sil::DriveSample& sample) {
    const double sine = std::sin(state.angle), cosine = std::cos(state.angle);
    const double p = state.rate, r = yaw_rate;
    sample.lateral_acceleration_mps2 = force.parallel_mps2 * cosine + force.normal_mps2 * sine +
                                       yaw_acceleration * body.imu_x_m - state.acceleration * body.imu_z_m -
                                       (p * p + r * r) * body.imu_y_m;
    sample.vertical_acceleration_mps2 = -force.parallel_mps2 * sine + force.normal_mps2 * cosine +
                                        state.acceleration * body.imu_y_m +
                                        p * (r * body.imu_x_m - p * body.imu_z_m);
}

// A gyro turns with the road, too. The change of this rate is left out: the bank is slow.
double twist_radps(const Recording& recording, double time_s) {
    return recording.bank_rad
               ? (recording.bank_rad(time_s + 1.0e-3) - recording.bank_rad(time_s - 1.0e-3)) / 2.0e-3
               : 0.0;
}

double smooth_step(double time_s, double start_s) {
    const double x = std::clamp((time_s - start_s) / 0.2, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

}  // namespace

double KnownBody::moment_nm(double phi) const {
    return stiffness_nmprad * phi + stiffness_cubic_nmprad3 * std::pow(phi, 3) +
           stiffness_quintic_nmprad5 * std::pow(phi, 5);
}

sil::Drive drive_of(const KnownBody& body, double duration_s,
                    const std::function<double(double)>& lateral_mps2, const Recording& recording) {
    sil::Drive drive;
    drive.name = "known_body";
    RollState state;
    for (int k = 0; step_s * k < duration_s; ++k) {
        const double time_s = step_s * k;
        const double lateral = lateral_mps2(time_s);
        const double bank = recording.bank_rad ? recording.bank_rad(time_s) : 0.0;
        const Force force = on_the_road(lateral, bank);
        state.acceleration = roll_acceleration(body, state, force);
        if (k % steps_a_sample == 0) {
            sil::DriveSample sample;
            sample.time_s = time_s;
            sample.roll_rate_radps =
                state.rate + twist_radps(recording, time_s) + recording.roll_rate_offset_radps;
            sample.roll_angle_rad =
                state.angle + recording.roll_offset_rad + (recording.roll_against_gravity ? bank : 0.0);
            const auto turn_mps2 = [&](double at_s) {
                return lateral_mps2(at_s) - (recording.sideslip_mps2 ? recording.sideslip_mps2(at_s) : 0.0);
            };
            const double yaw_rate = turn_mps2(time_s) / body.speed_mps;
            const double yaw_acceleration =
                (turn_mps2(time_s + 1.0e-3) - turn_mps2(time_s - 1.0e-3)) / 2.0e-3 / body.speed_mps;
            set_forces(body, state, force, yaw_rate, yaw_acceleration, sample);
            if (recording.motion) {
                sample.speed_mps = body.speed_mps;
                sample.yaw_rate_radps = yaw_rate;
            }
            sample.lateral_acceleration_mps2 += recording.lateral_offset_mps2;
            if (recording.steering) {
                sample.steering_wheel_angle_rad =
                    body.steering_ratio * (recording.demand_mps2 ? recording.demand_mps2(time_s) : lateral) *
                    (body.wheelbase_m / (body.speed_mps * body.speed_mps) + body.understeer_gradient_s2pm);
            }
            if (recording.wheel_loads) {
                set_wheel_loads(body, state, force.parallel_mps2, sample);
            }
            drive.samples.push_back(sample);
        }
        state.rate += step_s * state.acceleration;
        state.angle += step_s * state.rate;
    }
    return drive;
}

sil::Drive ramp_of(const KnownBody& body, double largest_mps2, const Recording& recording) {
    return drive_of(
        body, 62.0,
        [largest_mps2](double time_s) {
            const double within = std::fmod(std::max(time_s - 1.0, 0.0), 30.0);
            const double side = time_s < 31.0 ? 1.0 : -1.0;
            return time_s > 61.0 ? 0.0 : side * largest_mps2 * (1.0 - std::abs(within - 15.0) / 15.0);
        },
        recording);
}

sil::Drive steps_of(const KnownBody& body, const Recording& recording) {
    return drive_of(
        body, 14.0,
        [](double time_s) {
            return 3.0 * (smooth_step(time_s, 1.0) - smooth_step(time_s, 4.0) - smooth_step(time_s, 7.0) +
                          smooth_step(time_s, 10.0));
        },
        recording);
}

sil::VehicleData data_sheet_of(const KnownBody& body) {
    sil::VehicleData data;
    data.name = "known body";
    data.total_mass_kg = body.sprung_mass_kg + body.unsprung_mass_kg;
    data.sprung_mass_kg = body.sprung_mass_kg;
    data.unsprung_mass_kg = body.unsprung_mass_kg;
    data.sprung_cg_height_m = body.sprung_cg_height_m;
    data.unsprung_cg_height_m = body.unsprung_cg_height_m;
    data.track_width_m = body.track_width_m;
    data.wheelbase_m = body.wheelbase_m;
    data.steering_ratio = body.steering_ratio;
    data.imu_x_m = body.imu_x_m;
    data.imu_y_m = body.imu_y_m;
    data.imu_z_m = body.imu_z_m;
    return data;
}

}  // namespace identification_test
