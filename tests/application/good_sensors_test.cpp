// Honest driving that looks like a fault: the sensors are good, so no code may be set.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "tests/application/bench.hpp"
#include "tests/application/roll_plane_vehicle.hpp"

namespace good_sensors_test {
namespace {

using testing_application::Bench;
using testing_application::large_suv;
using testing_application::Motion;
using testing_application::RollPlaneVehicle;
using State = rsi::can_dbc::RolloverWarning::State;

constexpr double gravity_mps2 = 9.80665;
constexpr double degrees = 57.29577951308232;
constexpr double pi = 3.14159265358979;
constexpr double sample_s = 0.01;
constexpr double start_s = 3.0;  // until the component is available

// Uniform noise, the same in every run.
class Noise {
 public:
    float operator()(double most) {
        state_ = state_ * 1664525U + 1013904223U;
        return static_cast<float>(most * (static_cast<double>(state_ >> 8U) / 8388608.0 - 1.0));
    }

 private:
    std::uint32_t state_{1U};
};

// Usual noise of each sensor; without it ideal ones repeat themselves.
void add_noise(Motion& motion, Noise& noise) {
    motion.imu.lateral_acceleration_mps2 += noise(0.08);
    motion.imu.vertical_acceleration_mps2 += noise(0.08);
    motion.imu.roll_rate_deg_per_s += noise(0.2);
    motion.roll_angle.roll_angle_deg += noise(0.05);
    motion.vehicle_motion.yaw_rate_deg_per_s += noise(0.15);
    motion.vehicle_motion.speed_kmh += noise(0.05);
    motion.vehicle_motion.steering_wheel_angle_deg += noise(0.2);
}

struct Verdict {
    std::string codes;  // numbers of all codes that were reported
    int unavailable_cycles{0};
};

Verdict drive(std::function<Motion(double)> motion, double seconds) {
    Bench bench;
    bench.drive(std::move(motion));
    bench.run_for(seconds);
    Verdict verdict;
    for (std::size_t index = 0; index < rsi::monitoring::diagnostic_code_count; ++index) {
        const auto code = static_cast<rsi::monitoring::DiagnosticCode>(index);
        const rsi::monitoring::EventStatus status = bench.diagnostic_memory().status(code);
        if (status == rsi::monitoring::EventStatus::confirmed ||
            status == rsi::monitoring::EventStatus::healed) {
            verdict.codes += std::to_string(index) + ' ';
        }
    }
    for (std::size_t index = static_cast<std::size_t>(start_s / sample_s); index < bench.cycles().size();
         ++index) {
        verdict.unavailable_cycles += bench.cycles()[index].state() == State::unavailable ? 1 : 0;
    }
    return verdict;
}

void expect_no_code(std::function<Motion(double)> motion, double seconds) {
    const Verdict verdict = drive(std::move(motion), seconds);
    EXPECT_EQ(verdict.codes, "");
    EXPECT_EQ(verdict.unavailable_cycles, 0);
}

// Smooth step from 0 to 1 within `duration_s`, and its first and second derivative.
struct Step {
    double value;
    double rate;
    double acceleration;
};
Step smooth_step(double time_s, double duration_s) {
    if (time_s <= 0.0 || time_s >= duration_s) {
        return {time_s <= 0.0 ? 0.0 : 1.0, 0.0, 0.0};
    }
    const double angle = pi * time_s / duration_s;
    const double omega = pi / duration_s;
    return {0.5 - 0.5 * std::cos(angle), 0.5 * omega * std::sin(angle),
            0.5 * omega * omega * std::cos(angle)};
}

// Single-track vehicle that rolls, on a road whose bank changes below it; the driver keeps the lane.
class VehicleOnABank {
 public:
    explicit VehicleOnABank(double speed_mps, double damping_nmsprad = 8.0e3)
        : speed_mps_{speed_mps}, damping_nmsprad_{damping_nmsprad} {}

    // 10 ms with this bank, left side up.
    void advance(const Step& bank) {
        constexpr int steps = 20;
        constexpr double step_s = sample_s / steps;
        bank_ = bank;
        for (int step = 0; step < steps; ++step) {
            const double target_rad = -0.03 * offset_m_ - 0.4 * heading_rad_;
            steer_rad_ += step_s / 0.15 * (target_rad - steer_rad_);
            const double front_n =
                -cornering_npr * ((slip_mps_ + front_m * yaw_radps_) / speed_mps_ - steer_rad_);
            const double rear_n = -cornering_npr * ((slip_mps_ - rear_m * yaw_radps_) / speed_mps_);
            force_mps2_ = (front_n + rear_n) / mass_kg;
            const double normal_mps2 = gravity_mps2 * std::cos(bank.value);
            along_body_mps2_ = force_mps2_ * std::cos(angle_rad_) + normal_mps2 * std::sin(angle_rad_);
            upward_mps2_ = normal_mps2 * std::cos(angle_rad_) - force_mps2_ * std::sin(angle_rad_);
            const double against_road_radps = rate_radps_ - bank.rate;
            const double acceleration =
                (sprung_kg * arm_m * along_body_mps2_ - stiffness_nmprad * angle_rad_ -
                 damping_nmsprad_ * against_road_radps) /
                inertia_kgm2;
            slip_mps_ += step_s * (force_mps2_ - speed_mps_ * yaw_radps_ -
                                   gravity_mps2 * std::sin(bank.value) + cg_height_m * bank.acceleration);
            yaw_radps_ += step_s * (front_m * front_n - rear_m * rear_n) / yaw_inertia_kgm2;
            heading_rad_ += step_s * yaw_radps_;
            offset_m_ += step_s * (slip_mps_ + speed_mps_ * heading_rad_);
            angle_rad_ += step_s * against_road_radps;
            rate_radps_ += step_s * acceleration;
        }
    }

    Motion motion(Noise& noise) const {
        Motion motion;
        motion.imu.lateral_acceleration_mps2 = static_cast<float>(along_body_mps2_);
        motion.imu.vertical_acceleration_mps2 = static_cast<float>(upward_mps2_);
        motion.imu.roll_rate_deg_per_s = static_cast<float>(rate_radps_ * degrees);
        motion.roll_angle.roll_angle_deg = static_cast<float>(angle_rad_ * degrees);
        motion.vehicle_motion.speed_kmh = static_cast<float>(3.6 * speed_mps_);
        motion.vehicle_motion.yaw_rate_deg_per_s = static_cast<float>(yaw_radps_ * degrees);
        motion.vehicle_motion.steering_wheel_angle_deg = static_cast<float>(20.0 * steer_rad_ * degrees);
        add_noise(motion, noise);
        return motion;
    }

 private:
    static constexpr double mass_kg = 2374.0;
    static constexpr double sprung_kg = 2060.0;
    static constexpr double cg_height_m = 0.91;
    static constexpr double arm_m = 0.707;
    static constexpr double stiffness_nmprad = 96.0e3;
    static constexpr double inertia_kgm2 = 950.0;
    static constexpr double yaw_inertia_kgm2 = 4500.0;
    static constexpr double front_m = 1.35;
    static constexpr double rear_m = 1.6;
    static constexpr double cornering_npr = 120.0e3;

    double speed_mps_;
    double damping_nmsprad_;
    Step bank_{};
    double steer_rad_{0.0};
    double slip_mps_{0.0};
    double yaw_radps_{0.0};
    double heading_rad_{0.0};
    double offset_m_{0.0};
    double angle_rad_{0.0};
    double rate_radps_{0.0};
    double force_mps2_{0.0};
    double along_body_mps2_{0.0};
    double upward_mps2_{gravity_mps2};
};

TEST(GoodSensorsOnTheRoad, OfABankThatTurnsBy12DegreesInASecondSetNoCode) {
    for (const double side : {1.0, -1.0}) {
        for (const double speed_mps : {12.0, 22.0, 30.0}) {
            for (const double damping : {5.0e3, 8.0e3, 12.0e3}) {
                SCOPED_TRACE(speed_mps);
                SCOPED_TRACE(damping);
                VehicleOnABank vehicle{speed_mps, damping};
                Noise noise;
                expect_no_code(
                    [&vehicle, &noise, side](double time_s) {
                        const Step on = smooth_step(time_s - 4.0, 1.0);
                        const Step off = smooth_step(time_s - 7.0, 1.0);
                        const double bank_rad = side * 12.0 / degrees;
                        vehicle.advance({bank_rad * (on.value - off.value), bank_rad * (on.rate - off.rate),
                                         bank_rad * (on.acceleration - off.acceleration)});
                        return vehicle.motion(noise);
                    },
                    12.0);
            }
        }
    }
}

// One side is thrown up: the force that rolls the body heaves it too.
TEST(GoodSensorsOnTheRoad, OfABumpUnderOneSideSetNoCode) {
    for (const double side : {1.0, -1.0}) {
        Noise noise;
        double rate_radps = 0.0;
        double angle_rad = 0.0;
        expect_no_code(
            [&noise, &rate_radps, &angle_rad, side](double time_s) {
                double side_force_mps2 = 0.0;
                for (int step = 0; step < 20; ++step) {
                    const double since_s = time_s - 5.0 + step * 0.0005;
                    side_force_mps2 = since_s > 0.0
                                          ? 20.0 * std::exp(-since_s / 0.06) * std::sin(24.0 * pi * since_s)
                                          : 0.0;
                    const double acceleration =
                        side * side_force_mps2 * 0.8 / 0.28 - 51.0 * angle_rad * 1.7 - 7.0 * rate_radps;
                    rate_radps += 0.0005 * acceleration;
                    angle_rad += 0.0005 * rate_radps;
                }
                Motion motion;
                motion.imu.lateral_acceleration_mps2 = static_cast<float>(gravity_mps2 * angle_rad);
                motion.imu.vertical_acceleration_mps2 += static_cast<float>(side_force_mps2);
                motion.imu.roll_rate_deg_per_s = static_cast<float>(rate_radps * degrees);
                motion.roll_angle.roll_angle_deg = static_cast<float>(angle_rad * degrees);
                add_noise(motion, noise);
                return motion;
            },
            8.0);
    }
}

// A slalom without noise; the speed is the vehicle's, which turns cost, unless it is given.
void expect_no_code_in_a_slalom(double force_mps2, double pulsation, double seconds,
                                std::optional<float> speed_kmh) {
    SCOPED_TRACE(force_mps2);
    SCOPED_TRACE(pulsation);
    RollPlaneVehicle vehicle{large_suv()};
    expect_no_code(
        [&](double time_s) {
            vehicle.advance(force_mps2 * std::sin(pulsation * time_s));
            Motion motion = vehicle.motion();
            motion.vehicle_motion.speed_kmh = speed_kmh.value_or(motion.vehicle_motion.speed_kmh);
            return motion;
        },
        seconds);
}

TEST(GoodSensorsOnTheRoad, OfASlalomAtAConstantSpeedSetNoCode) {
    for (const double pulsation : {1.0, 2.0}) {
        for (const double force_mps2 : {3.0, 4.0}) {
            expect_no_code_in_a_slalom(force_mps2, pulsation, 12.0, 80.0F);
        }
    }
}

// In reverse the yaw rate of a turn has the other sign; the speed has none.
TEST(GoodSensorsOnTheRoad, OfAVehicleInReverseSetNoCode) {
    for (const double speed_mps : {6.0, 8.0, 11.0}) {
        for (const double force_mps2 : {1.5, 2.5, 4.0}) {
            SCOPED_TRACE(speed_mps);
            SCOPED_TRACE(force_mps2);
            RollPlaneVehicle vehicle{large_suv()};
            Noise noise;
            expect_no_code(
                [&vehicle, &noise, speed_mps, force_mps2](double time_s) {
                    const double moved = smooth_step(time_s - 3.0, 3.0).value;
                    const double swing = time_s < 14.0 ? 1.0 : std::cos(time_s - 14.0);
                    vehicle.advance(force_mps2 * swing * smooth_step(time_s - 7.0, 1.0).value);
                    Motion motion = vehicle.motion();
                    const double moving_mps = speed_mps * moved + 0.01;
                    motion.vehicle_motion.speed_kmh = static_cast<float>(3.6 * moving_mps) + 0.1F;
                    motion.vehicle_motion.yaw_rate_deg_per_s =
                        static_cast<float>(-vehicle.lateral_acceleration_mps2() / moving_mps * degrees);
                    add_noise(motion, noise);
                    return motion;
                },
                25.0);
        }
    }
}

// Steady turn on a road that leans into it: what the bank takes from the lateral force it adds to the
// vertical one.
TEST(GoodSensorsOnTheRoad, OfABankedOvalSetNoCode) {
    for (const double bank_deg : {20.0, 26.0, 31.0}) {
        for (const double beyond_mps2 : {-1.0, 0.0, 4.0}) {
            SCOPED_TRACE(bank_deg);
            SCOPED_TRACE(beyond_mps2);
            Noise noise;
            double angle_rad = 0.0;
            expect_no_code(
                [&noise, &angle_rad, bank_deg, beyond_mps2](double time_s) {
                    const Step on = smooth_step(time_s - 5.0, 4.0);
                    const double bank_rad = bank_deg / degrees * on.value;
                    const double bank_rate = bank_deg / degrees * on.rate;
                    const double force_mps2 = beyond_mps2 * on.value;  // along the road, inwards
                    const double turn_mps2 = force_mps2 + gravity_mps2 * std::sin(bank_rad);
                    const double normal_mps2 =
                        gravity_mps2 * std::cos(bank_rad) + turn_mps2 * std::tan(bank_rad);
                    const double before_rad = angle_rad;
                    const double held_rad = force_mps2 * 2060.0 * 0.707 / 96.0e3;
                    angle_rad += 0.1 * (held_rad - angle_rad);
                    Motion motion;
                    motion.imu.lateral_acceleration_mps2 = static_cast<float>(
                        force_mps2 * std::cos(angle_rad) + normal_mps2 * std::sin(angle_rad));
                    motion.imu.vertical_acceleration_mps2 = static_cast<float>(
                        normal_mps2 * std::cos(angle_rad) - force_mps2 * std::sin(angle_rad));
                    motion.imu.roll_rate_deg_per_s =
                        static_cast<float>(((angle_rad - before_rad) / sample_s - bank_rate) * degrees);
                    motion.roll_angle.roll_angle_deg = static_cast<float>(angle_rad * degrees);
                    motion.vehicle_motion.speed_kmh = 180.0F;
                    motion.vehicle_motion.yaw_rate_deg_per_s = static_cast<float>(turn_mps2 / 50.0 * degrees);
                    add_noise(motion, noise);
                    return motion;
                },
                20.0);
        }
    }
}

// All wheels in the air, then a hard landing that takes the fall's speed back.
TEST(GoodSensorsOnTheRoad, OfAJumpSetNoCode) {
    for (const double flight_s : {0.3, 0.5, 0.8}) {
        SCOPED_TRACE(flight_s);
        Noise noise;
        expect_no_code(
            [&noise, flight_s](double time_s) {
                const double since_s = time_s - 5.0;
                const double landed_s = since_s - flight_s;
                double upward_mps2 = gravity_mps2;
                if (since_s > 0.0 && landed_s < 0.0) {
                    upward_mps2 = gravity_mps2 * std::exp(-since_s / 0.03);
                } else if (landed_s >= 0.0) {  // the impulse of the fall within 0.2 s, then the springs
                    const double peak_mps2 = gravity_mps2 * flight_s * pi / 0.4;
                    upward_mps2 += landed_s < 0.2 ? peak_mps2 * std::sin(pi * landed_s / 0.2) -
                                                        gravity_mps2 * std::exp(-landed_s / 0.02)
                                                  : -3.0 * std::exp(-(landed_s - 0.2) / 0.25) *
                                                        std::sin(8.0 * (landed_s - 0.2));
                }
                Motion motion;
                motion.imu.vertical_acceleration_mps2 = static_cast<float>(upward_mps2);
                add_noise(motion, noise);
                return motion;
            },
            9.0);
    }
}

// The ferry's deck turns the vehicle; its body leans against the deck as its weight makes it.
Motion on_a_ferry(double time_s, double& angle_rad) {
    const double ramp = smooth_step(time_s - 3.0, 6.0).value;
    const double omega = 2.0 * pi / 6.0;
    const double deck_rad = ramp * 12.0 / degrees * std::sin(omega * time_s);
    const double deck_radps = ramp * 12.0 / degrees * omega * std::cos(omega * time_s);
    const double force_mps2 = gravity_mps2 * std::sin(deck_rad) + 2.0 * omega * omega * deck_rad;
    const double before_rad = angle_rad;
    angle_rad += 0.1 * (force_mps2 * 2060.0 * 0.707 / (96.0e3 - 2060.0 * 0.707 * gravity_mps2) - angle_rad);
    const double along_body_mps2 = force_mps2 + gravity_mps2 * std::cos(deck_rad) * std::sin(angle_rad);
    Motion motion;
    motion.imu.lateral_acceleration_mps2 = static_cast<float>(along_body_mps2);
    motion.imu.vertical_acceleration_mps2 =
        static_cast<float>(gravity_mps2 * std::cos(deck_rad) - force_mps2 * std::sin(angle_rad));
    motion.imu.roll_rate_deg_per_s =
        static_cast<float>((deck_radps + (angle_rad - before_rad) / sample_s) * degrees);
    motion.roll_angle.roll_angle_deg = static_cast<float>(angle_rad * degrees);
    motion.vehicle_motion.speed_kmh = 0.0F;
    return motion;
}

TEST(GoodSensorsOnTheRoad, OfAFerrySetNoCode) {
    for (const bool noisy : {true, false}) {
        SCOPED_TRACE(noisy);
        Noise noise;
        double angle_rad = 0.0;
        expect_no_code(
            [&noise, &angle_rad, noisy](double time_s) {
                Motion motion = on_a_ferry(time_s, angle_rad);
                if (noisy) {
                    add_noise(motion, noise);
                }
                motion.vehicle_motion.speed_kmh = 0.0F;
                return motion;
            },
            120.0);
    }
}

// Ideal sensors repeat themselves.
TEST(GoodSensorsOnTheRoad, WithoutNoiseOfAGentleSlalomSetNoCode) {
    for (const double force_mps2 : {2.0, 3.0, 5.0}) {
        for (const double pulsation : {0.8, 1.2, 2.0}) {
            expect_no_code_in_a_slalom(force_mps2, pulsation, 20.0, {});
        }
    }
}

// The yaw rate stays zero while the bank changes the lateral force.
TEST(GoodSensorsOnTheRoad, WithoutNoiseOfAStraightOverABankSetNoCode) {
    for (const double side : {1.0, -1.0}) {
        double angle_rad = 0.0;
        expect_no_code(
            [&angle_rad, side](double time_s) {
                const Step on = smooth_step(time_s - 4.0, 2.0);
                const double bank_rad = side * 10.0 / degrees * on.value;
                const double force_mps2 = gravity_mps2 * std::sin(bank_rad);
                const double before_rad = angle_rad;
                angle_rad += 0.1 * (force_mps2 * 2060.0 * 0.707 / 82.0e3 - angle_rad);
                Motion motion;
                motion.imu.lateral_acceleration_mps2 =
                    static_cast<float>(force_mps2 + gravity_mps2 * angle_rad);
                motion.imu.vertical_acceleration_mps2 =
                    static_cast<float>(gravity_mps2 * std::cos(bank_rad) - force_mps2 * angle_rad);
                motion.imu.roll_rate_deg_per_s = static_cast<float>(
                    (side * 10.0 / degrees * on.rate + (angle_rad - before_rad) / sample_s) * degrees);
                motion.roll_angle.roll_angle_deg = static_cast<float>(angle_rad * degrees);
                return motion;
            },
            10.0);
    }
}

}  // namespace
}  // namespace good_sensors_test
