#include "sil/world/manoeuvres/mixed_driving.hpp"

#include <algorithm>
#include <cmath>

#include "sil/random.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/path_follower.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"
#include "sil/world/manoeuvres/steady_steering.hpp"

namespace sil {
namespace {

constexpr double largest_handwheel_rad = 6.0;
constexpr double smallest_speed_mps = 5.0;

// How hard a driver turns.
struct Temper {
    double share_of_hard_turns;
    double most_g;             // in the others
    double correction;         // share of what is felt too much or too little that goes into the wheel
    double speed_share_per_s;  // how fast another speed is wanted
    double handwheel_radps;    // how fast the hands are
};
constexpr Temper mixed{0.4, 0.5, 0.0, 1.0e3, 1.0e6};
// About 1 m/s^2: accelerating or braking harder than that in a turn takes the grip from an axle.
constexpr Temper ordinary{0.0, 0.4, 1.5, 0.03, from_degrees(500.0)};

enum class Segment : std::uint8_t { straight, turn, lane_change, weave };

// The course of one segment: of its acceleration, the share that is wanted.
struct Course {
    Segment segment{Segment::straight};
    double begin_s{0.0};
    double duration_s{0.0};
    double ramp_s{1.0};
    double period_s{3.0};
    double acceleration_mps2{0.0};  // signed
    double speed_share{1.0};

    double share(double time_s) const {
        const double since_s = time_s - begin_s;
        switch (segment) {
            case Segment::turn:
                return std::clamp(std::min(since_s, duration_s - since_s) / ramp_s, 0.0, 1.0);
            case Segment::lane_change:
            case Segment::weave:
                return std::sin(2.0 * pi * since_s / period_s);
            case Segment::straight:
                break;
        }
        return 0.0;
    }
};

class MixedDriver final : public CopiedDriver<MixedDriver> {
 public:
    MixedDriver(const Temper& temper, std::uint64_t seed, const VehicleParameters& vehicle)
        : temper_{temper},
          chance_{seed},
          steering_{vehicle, understeer_gradient_s2pm(vehicle, handwheel_angle_at_0_3_g_rad(vehicle))} {}

    DriverCommand command(const Truth& truth) override {
        if (truth.time_s >= course_.begin_s + course_.duration_s) {
            course_ = next_course(truth.time_s);
        }
        DriverCommand command;
        const double since_s = truth.time_s - last_s_;
        last_s_ = truth.time_s;
        const double most_change = temper_.speed_share_per_s * since_s;
        speed_share_ += std::clamp(course_.speed_share - speed_share_, -most_change, most_change);
        command.speed_share = speed_share_;
        const double wanted_mps2 = course_.acceleration_mps2 * course_.share(truth.time_s);
        const double wanted_rad =
            angle_rad(wanted_mps2 + temper_.correction * (wanted_mps2 - truth.lateral_acceleration_mps2),
                      truth.speed_mps);
        const double most_turned_rad = temper_.handwheel_radps * since_s;
        handwheel_rad_ =
            std::clamp(wanted_rad, handwheel_rad_ - most_turned_rad, handwheel_rad_ + most_turned_rad);
        command.steering_wheel_angle_rad = handwheel_rad_;
        return command;
    }

 private:
    double angle_rad(double acceleration_mps2, double speed_mps) const {
        const double angle =
            steering_.handwheel_rad(acceleration_mps2, std::max(speed_mps, smallest_speed_mps));
        return std::clamp(angle, -largest_handwheel_rad, largest_handwheel_rad);
    }

    Course next_course(double time_s) {
        Course course;
        course.begin_s = time_s;
        course.segment = static_cast<Segment>(chance_.below(4U));
        course.ramp_s = chance_.between(0.3, 2.0);
        course.period_s = chance_.between(2.0, 5.0);
        course.speed_share = chance_.between(0.3, 1.0);
        const bool hard = chance_.between(0.0, 1.0) < temper_.share_of_hard_turns;
        const double acceleration_g =
            hard ? chance_.between(0.5, 0.9) : chance_.between(0.02, temper_.most_g);
        course.acceleration_mps2 = (chance_.below(2U) == 0U ? 1.0 : -1.0) * acceleration_g * g_mps2;
        switch (course.segment) {
            case Segment::straight:
                course.duration_s = chance_.between(2.0, 20.0);
                break;
            case Segment::turn:
                course.duration_s = 2.0 * course.ramp_s + (hard ? 1.5 : chance_.between(1.0, 8.0));
                break;
            case Segment::lane_change:
                course.duration_s = course.period_s;
                break;
            case Segment::weave:
                course.duration_s = course.period_s * static_cast<double>(2U + chance_.below(4U));
                break;
        }
        return course;
    }

    Temper temper_;
    RandomStream chance_;
    SteadySteering steering_;
    Course course_{};
    double speed_share_{1.0};
    double handwheel_rad_{0.0};
    double last_s_{0.0};
};

Manoeuvre driving(const Temper& temper, const char* name, std::uint64_t seed, double duration_s) {
    Manoeuvre manoeuvre;
    manoeuvre.name = name;
    manoeuvre.duration_s = duration_s;
    manoeuvre.initial_speed_mps = from_kmh(110.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.asks_for_handwheel_angle = true;
    manoeuvre.make_driver = [temper, seed](const VehicleParameters& parameters) {
        return std::make_unique<MixedDriver>(temper, seed, parameters);
    };
    return manoeuvre;
}

}  // namespace

Manoeuvre mixed_driving(std::uint64_t seed, double duration_s) {
    return driving(mixed, "mixed-driving", seed, duration_s);
}

Manoeuvre ordinary_driving(std::uint64_t seed, double duration_s, double share_of_acceleration) {
    Temper temper = ordinary;
    temper.most_g *= share_of_acceleration;
    return driving(temper, ordinary_driving_name, seed, duration_s);
}

}  // namespace sil
