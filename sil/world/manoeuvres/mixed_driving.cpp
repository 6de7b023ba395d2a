#include "sil/world/manoeuvres/mixed_driving.hpp"

#include <algorithm>
#include <cmath>

#include "sil/chance.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {
namespace {

constexpr double largest_handwheel_rad = 6.0;

// How hard a driver turns.
struct Temper {
    double share_of_hard_turns;
    double most_g;  // in the others
};
constexpr Temper mixed{0.4, 0.5};
constexpr Temper ordinary{0.0, 0.4};

enum class Segment : std::uint8_t { straight, turn, lane_change, weave };

// The course of the handwheel in one segment, as a share of its angle.
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
                return std::sin(2.0 * 3.14159265358979323846 * since_s / period_s);
            case Segment::straight:
                break;
        }
        return 0.0;
    }
};

class MixedDriver final : public Driver {
 public:
    MixedDriver(const Temper& temper, std::uint64_t seed, double handwheel_at_0_3_g_rad)
        : temper_{temper}, chance_{seed}, handwheel_at_0_3_g_rad_{handwheel_at_0_3_g_rad} {}

    DriverCommand command(const Truth& truth) override {
        if (truth.time_s >= course_.begin_s + course_.duration_s) {
            course_ = next_course(truth.time_s);
        }
        DriverCommand command;
        command.speed_share = course_.speed_share;
        command.steering_wheel_angle_rad = angle_rad(truth.speed_mps) * course_.share(truth.time_s);
        return command;
    }

 private:
    // The linear single-track model has delta = a (l / v^2 + K); both parts are held to be equal at 50 mph.
    double angle_rad(double speed_mps) const {
        const double ratio = from_mph(50.0) / std::max(speed_mps, 5.0);
        const double angle = handwheel_at_0_3_g_rad_ * course_.acceleration_mps2 / (0.3 * g_mps2) * 0.5 *
                             (1.0 + ratio * ratio);
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
    Chance chance_;
    double handwheel_at_0_3_g_rad_;
    Course course_{};
};

Manoeuvre driving(const Temper& temper, const char* name, std::uint64_t seed, double duration_s) {
    Manoeuvre manoeuvre;
    manoeuvre.name = name;
    manoeuvre.duration_s = duration_s;
    manoeuvre.initial_speed_mps = from_kmh(110.0);
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = [temper, seed](const VehicleParameters& parameters) {
        return std::make_unique<MixedDriver>(temper, seed, handwheel_angle_at_0_3_g_rad(parameters));
    };
    return manoeuvre;
}

}  // namespace

Manoeuvre mixed_driving(std::uint64_t seed, double duration_s) {
    return driving(mixed, "mixed-driving", seed, duration_s);
}

Manoeuvre ordinary_driving(std::uint64_t seed, double duration_s) {
    return driving(ordinary, ordinary_driving_name, seed, duration_s);
}

}  // namespace sil
