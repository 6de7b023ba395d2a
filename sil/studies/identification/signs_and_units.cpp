#include "sil/studies/identification/signs_and_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/units.hpp"

namespace sil {
namespace {

// How the yaw rate at this speed, and the steering, must agree with the lateral acceleration.
constexpr std::size_t shortest_turn = 50U;
constexpr double slowest_turn_mps = 5.0;
constexpr double clear_turn_mps2 = 0.1 * g_mps2;
constexpr double beyond_bank_mps2 = 0.25 * g_mps2;  // an acceleration that no road's bank gives on a straight
constexpr double largest_unit_error = 3.0;  // beyond any slip, slope or drift; a wrong unit makes 9.8 or 57
constexpr double moderate_turn_mps2 = 0.5 * g_mps2;
constexpr double largest_acceleration_mps2 = 1.5 * g_mps2;
constexpr double least_gradient_deg =
    0.4;  // deg/g; half of the stiffest vehicle's, a wrong unit makes 0.2 at most
constexpr double largest_gradient_deg = 40.0;
constexpr double clear_correlation = 0.5;
constexpr double same_motion_correlation = 0.9;  // of one motion in two units; a skid has less
constexpr double tipping_roll_rad = 0.35;        // later samples are blows

struct Agreement {
    double slope{};  // of y over x
    double correlation{};
    std::size_t count{};
};

// Slope of the pairs that `use` takes; nothing is taken off, because a turn is large beside any offset.
template <typename Use>
Agreement agreement(const Signal& x, const Signal& y, const Use& use) {
    double xx = 0.0, xy = 0.0, yy = 0.0;
    Agreement result;
    for (std::size_t k = 0U; k < std::min(x.size(), y.size()); ++k) {
        if (use(k)) {
            xx += x[k] * x[k];
            xy += x[k] * y[k];
            yy += y[k] * y[k];
            ++result.count;
        }
    }
    if (xx > 0.0 && yy > 0.0) {
        result.slope = xy / xx;
        result.correlation = xy / std::sqrt(xx * yy);
    }
    return result;
}

class SignsAndUnits {
 public:
    SignsAndUnits(const Drive& drive, const Cycles& cycles, double filter_lag_s)
        : drive_{drive}, cycles_{cycles}, filter_lag_s_{filter_lag_s} {}

    void look() const {
        const Signal lateral = signal(&DriveSample::lateral_acceleration_mps2);
        const Signal yaw_rate = signal(&DriveSample::yaw_rate_radps);
        const Signal speed = signal(&DriveSample::speed_mps);
        if (complete(yaw_rate) && complete(speed)) {
            Signal turn;
            for (std::size_t k = 0U; k < speed.size() && !tips(cycles_[k].sample); ++k) {
                turn.push_back(yaw_rate[k] * speed[k]);
            }
            refuse_wrong_turn(agreement(turn, lateral, [&](std::size_t k) {
                return speed[k] > slowest_turn_mps &&
                       (std::abs(turn[k]) > clear_turn_mps2 || std::abs(lateral[k]) > beyond_bank_mps2);
            }));
            refuse_wrong_steering(turn, speed);
        } else {
            refuse_large_acceleration(lateral);
        }
        refuse_wrong_roll_angle(lateral);
    }

 private:
    Signal signal(double DriveSample::* member) const { return smooth(cycles_, member, filter_lag_s_); }

    // Without yaw rate or speed only the size tells.
    void refuse_large_acceleration(const Signal& lateral) const {
        std::size_t count = 0U;
        for (std::size_t k = 0U; k < lateral.size() && !tips(cycles_[k].sample); ++k) {
            count += std::abs(lateral[k]) > largest_acceleration_mps2 ? 1U : 0U;
        }
        if (count >= shortest_turn) {
            throw IdentificationError(fmt::format(
                "{}: the lateral acceleration stays beyond {:.1f} g for {:.1f} s, which no tyre gives. "
                "Check the unit that the column's name says: 9.8 comes from m/s^2 in a column named _g",
                drive_.name, largest_acceleration_mps2 / g_mps2, sample_time_s * static_cast<double>(count)));
        }
    }

    void refuse_wrong_roll_angle(const Signal& lateral) const {
        const Signal roll = signal(&DriveSample::roll_angle_rad);
        std::size_t end = 0U;
        while (end < lateral.size() && std::abs(lateral[end]) < moderate_turn_mps2 &&
               !(drive_.one_wheel_lift_s && cycles_[end].sample.time_s > *drive_.one_wheel_lift_s)) {
            ++end;
        }
        const Agreement rolled = agreement(
            lateral, roll, [&](std::size_t k) { return k < end && std::abs(lateral[k]) > clear_turn_mps2; });
        if (rolled.count < shortest_turn || std::abs(rolled.correlation) < clear_correlation) {
            return;
        }
        const double gradient = std::abs(rolled.slope) * g_mps2 * degrees_per_radian;
        if (gradient < least_gradient_deg || gradient > largest_gradient_deg) {
            throw IdentificationError(
                fmt::format("{}: the roll angle is {:.2g} deg per g of lateral acceleration, and vehicles "
                            "have 1 to 12. Check the unit that the column's name says: rad in a column "
                            "named roll_angle_deg makes 57 times too little, deg in one named "
                            "roll_angle_rad 57 times too much",
                            drive_.name, gradient));
        }
    }

    bool tips(const DriveSample& sample) const {
        return std::abs(sample.roll_angle_rad) > tipping_roll_rad ||
               (drive_.one_wheel_lift_s && sample.time_s > *drive_.one_wheel_lift_s);
    }

    void refuse_wrong_turn(const Agreement& turn) const {
        if (turn.count < shortest_turn || std::abs(turn.correlation) < clear_correlation) {
            return;
        }
        if (turn.slope < 0.0) {
            throw IdentificationError(fmt::format(
                "{}: lateral acceleration and yaw rate have opposite signs. In a left turn both are "
                "positive, and so are roll angle and steering-wheel angle: turn the sign of the column "
                "that is not",
                drive_.name));
        }
        const bool same_size = turn.slope < largest_unit_error && turn.slope > 1.0 / largest_unit_error;
        if (turn.correlation > same_motion_correlation && !same_size) {
            throw IdentificationError(fmt::format(
                "{}: the lateral acceleration is {:.2g} times yaw rate times speed, and both should be the "
                "same. Check the units that the columns' names say: 9.8 comes from m/s^2 in a column named "
                "_g, 57 from deg in one named _rad, 3.6 from km/h",
                drive_.name, turn.slope));
        }
    }

    void refuse_wrong_steering(const Signal& turn, const Signal& speed) const {
        const Signal steering = signal(&DriveSample::steering_wheel_angle_rad);
        if (!complete(steering)) {
            return;
        }
        const Agreement steered = agreement(steering, turn, [&](std::size_t k) {
            return speed[k] > slowest_turn_mps && std::abs(turn[k]) > clear_turn_mps2;
        });
        if (steered.count >= shortest_turn && steered.correlation < -clear_correlation) {
            throw IdentificationError(
                fmt::format("{}: steering-wheel angle and yaw rate have opposite signs. In a left turn "
                            "both are positive: turn the sign of the steering-wheel angle",
                            drive_.name));
        }
    }

    const Drive& drive_;
    const Cycles& cycles_;
    double filter_lag_s_;
};

}  // namespace

void refuse_wrong_signs_and_units(const Drive& drive, const Cycles& cycles, double filter_lag_s) {
    SignsAndUnits{drive, cycles, filter_lag_s}.look();
}

}  // namespace sil
