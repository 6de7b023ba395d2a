#include "sil/studies/identification/prepared_drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sil/studies/drives/resample.hpp"
#include "sil/studies/identification/zero_phase_filter.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double lifted_load_share = 0.02;                          // of the wheel's load at the start
constexpr double straight_steering_rad = 0.6 / degrees_per_radian;  // at the steering wheel
constexpr double straight_yaw_rate_radps = 0.008;
constexpr double shortest_straight_s = 0.3;
constexpr std::size_t shortest_segment = 50U;
// Signs and units: how the yaw rate at this speed, and the steering, must agree with the lateral
// acceleration.
constexpr double slowest_turn_mps = 5.0;
constexpr double clear_turn_mps2 = 0.1 * g_mps2;
constexpr double largest_unit_error = 3.0;  // beyond any slip, slope or drift; a wrong unit makes 9.8 or 57
constexpr double clear_correlation = 0.5;
constexpr double tipping_roll_rad = 0.35;  // what comes later are blows
constexpr std::size_t edge = 5U;           // samples at both ends where filter and derivative do not commute

using Signal = std::vector<double>;
using Cycles = std::vector<DriveCycle>;

Signal signal_of(const Cycles& cycles, double DriveSample::* member) {
    Signal signal;
    for (const DriveCycle& cycle : cycles) {
        signal.push_back(cycle.sample.*member);
    }
    return signal;
}

bool complete(const Signal& signal) {
    return std::all_of(signal.begin(), signal.end(), [](double value) { return std::isfinite(value); });
}

bool has_loads(const DriveSample& sample) {
    return std::all_of(sample.wheel_load_n.begin(), sample.wheel_load_n.end(),
                       [](double value) { return std::isfinite(value); });
}

double load_moment_nm(const DriveSample& sample, double track_width_m) {
    const auto& load = sample.wheel_load_n;
    return 0.5 * track_width_m * (load[front_right] + load[rear_right] - load[front_left] - load[rear_left]);
}

bool usable(const DriveCycle& cycle) {
    return cycle.has_frames && std::isfinite(cycle.sample.lateral_specific_force_mps2) &&
           std::isfinite(cycle.sample.roll_rate_radps) && std::isfinite(cycle.sample.roll_angle_rad);
}

struct Agreement {
    double slope{};  // of y over x
    double correlation{};
    std::size_t count{};
};

// Of the pairs that `use` takes; nothing is taken off, because a turn is large beside any offset.
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

// The longest part without a gap.
Cycles longest_whole_part(const Cycles& cycles) {
    std::size_t best_begin = 0U, best_length = 0U, begin = 0U;
    for (std::size_t k = 0U; k <= cycles.size(); ++k) {
        if (k < cycles.size() && usable(cycles[k])) {
            continue;
        }
        if (k - begin > best_length) {
            best_begin = begin;
            best_length = k - begin;
        }
        begin = k + 1U;
    }
    const auto first = cycles.begin() + static_cast<std::ptrdiff_t>(best_begin);
    return {first, first + static_cast<std::ptrdiff_t>(best_length)};
}

std::array<double, 2> road_forces(double lateral, double vertical, double roll) {
    const double sine = std::sin(roll), cosine = std::cos(roll);
    if (!std::isfinite(vertical)) {  // as the firmware does: no heave, a level road
        return {(lateral - g_mps2 * sine) / cosine, g_mps2};
    }
    return {lateral * cosine - vertical * sine, lateral * sine + vertical * cosine};
}

struct Cut {
    std::optional<double> time_s;
    std::string reason;
};

class Preparation {
 public:
    Preparation(const Drive& drive, const VehicleData& vehicle, const PreparationOptions& options)
        : drive_{drive}, vehicle_{vehicle}, options_{options} {}

    PreparedDrive run() {
        refuse_without_roll_angle();
        cycles_ = longest_whole_part(to_cycles(drive_));
        refuse_too_short("");
        refuse_wrong_signs_and_units();
        PreparedDrive prepared;
        prepared.name = drive_.name;
        prepared.offsets = offsets();
        const Cut cut = find_cut(prepared.offsets);
        prepared.cut_s = cut.time_s;
        prepared.cut_reason = cut.reason;
        if (cut.time_s) {
            const auto end = std::find_if(cycles_.begin(), cycles_.end(), [&cut](const DriveCycle& cycle) {
                return cycle.sample.time_s >= *cut.time_s;
            });
            cycles_.erase(end, cycles_.end());
            refuse_too_short(cut.reason);
        }
        fill(prepared);
        return prepared;
    }

 private:
    void refuse_without_roll_angle() const {
        const bool any =
            std::any_of(drive_.samples.begin(), drive_.samples.end(),
                        [](const DriveSample& sample) { return std::isfinite(sample.roll_angle_rad); });
        if (!any) {
            throw IdentificationError(
                fmt::format("{}: has no roll angle. The roll stiffness is moment over roll angle: add a "
                            "column roll_angle_deg "
                            "(of the body relative to the road, for example from two ride-height sensors)",
                            drive_.name));
        }
    }

    void refuse_too_short(const std::string& reason) const {
        if (cycles_.size() < shortest_segment) {
            throw IdentificationError(
                fmt::format("{}: only {:.2f} s can be used{}{}. Record at least some seconds with lateral "
                            "acceleration, roll "
                            "rate and roll angle all present before a wheel lifts",
                            drive_.name, sample_time_s * static_cast<double>(cycles_.size()),
                            reason.empty() ? "" : ": ", reason));
        }
    }

    // Before anything is cut: a wrong unit would cut the drive and blame the driver.
    void refuse_wrong_signs_and_units() const {
        const Signal lateral = smooth(&DriveSample::lateral_specific_force_mps2);
        const Signal yaw_rate = smooth(&DriveSample::yaw_rate_radps);
        const Signal speed = smooth(&DriveSample::speed_mps);
        if (complete(yaw_rate) && complete(speed)) {
            Signal turn;
            for (std::size_t k = 0U; k < speed.size() && !tips(cycles_[k].sample); ++k) {
                turn.push_back(yaw_rate[k] * speed[k]);
            }
            refuse_wrong_turn(agreement(turn, lateral, [&](std::size_t k) {
                return speed[k] > slowest_turn_mps &&
                       std::max(std::abs(turn[k]), std::abs(lateral[k])) > clear_turn_mps2;
            }));
            refuse_wrong_steering(turn, speed);
        }
    }

    bool tips(const DriveSample& sample) const {
        return std::abs(sample.roll_angle_rad) > tipping_roll_rad ||
               (drive_.one_wheel_lift_s && sample.time_s > *drive_.one_wheel_lift_s);
    }

    void refuse_wrong_turn(const Agreement& turn) const {
        if (turn.count < shortest_segment || std::abs(turn.correlation) < clear_correlation) {
            return;
        }
        if (turn.slope < 0.0) {
            throw IdentificationError(fmt::format(
                "{}: lateral acceleration and yaw rate have opposite signs. In a left turn both are "
                "positive, "
                "and so are roll angle and steering-wheel angle: turn the sign of the column that is not",
                drive_.name));
        }
        if (turn.slope > largest_unit_error || turn.slope < 1.0 / largest_unit_error) {
            throw IdentificationError(fmt::format(
                "{}: the lateral acceleration is {:.2g} times yaw rate times speed, and both should be the "
                "same. Check the units that the columns' names say: 9.8 comes from m/s^2 in a column named "
                "_g, 57 from deg in one named _rad, 3.6 from km/h",
                drive_.name, turn.slope));
        }
    }

    void refuse_wrong_steering(const Signal& turn, const Signal& speed) const {
        const Signal steering = smooth(&DriveSample::steering_wheel_angle_rad);
        if (!complete(steering)) {
            return;
        }
        const Agreement steered = agreement(steering, turn, [&](std::size_t k) {
            return speed[k] > slowest_turn_mps && std::abs(turn[k]) > clear_turn_mps2;
        });
        if (steered.count >= shortest_segment && steered.correlation < -clear_correlation) {
            throw IdentificationError(
                fmt::format("{}: steering-wheel angle and yaw rate have opposite signs. In a left turn both "
                            "are positive: "
                            "turn the sign of the steering-wheel angle",
                            drive_.name));
        }
    }

    Signal smooth(double DriveSample::* member) const {
        Signal signal = signal_of(cycles_, member);
        return complete(signal)
                   ? filter_without_delay(std::move(signal), options_.filter_lag_s, sample_time_s)
                   : Signal(cycles_.size(), std::numeric_limits<double>::quiet_NaN());
    }

    Signal smooth_load_moment() const {
        Signal signal;
        for (const DriveCycle& cycle : cycles_) {
            signal.push_back(has_loads(cycle.sample) ? load_moment_nm(cycle.sample, vehicle_.track_width_m)
                                                     : std::numeric_limits<double>::quiet_NaN());
        }
        return complete(signal)
                   ? filter_without_delay(std::move(signal), options_.filter_lag_s, sample_time_s)
                   : signal;
    }

    // How many samples pass before the driver steers: by the steering wheel, else by the yaw rate.
    std::size_t straight_samples() const {
        const Signal steering = smooth(&DriveSample::steering_wheel_angle_rad);
        const Signal yaw_rate = smooth(&DriveSample::yaw_rate_radps);
        const bool by_steering = complete(steering);
        const Signal& signal = by_steering ? steering : yaw_rate;
        const double limit = by_steering ? straight_steering_rad : straight_yaw_rate_radps;
        std::size_t count = 0U;
        while (count < signal.size() && std::abs(signal[count] - signal.front()) < limit) {
            ++count;
        }
        // The filter lets the turn shine back.
        const auto margin = static_cast<std::size_t>(4.0 * options_.filter_lag_s / sample_time_s);
        count = count > margin ? count - margin : 0U;
        // A steady turn is not a straight road.
        const bool turning = complete(yaw_rate) && std::abs(yaw_rate.front()) > 0.05;
        return turning ? 0U : count;
    }

    double mean(double DriveSample::* member, std::size_t count) const {
        double sum = 0.0;
        for (std::size_t k = 0U; k < count; ++k) {
            sum += cycles_[k].sample.*member;
        }
        return sum / static_cast<double>(count);
    }

    SensorOffsets offsets() const {
        SensorOffsets offsets;
        const std::size_t count = straight_samples();
        offsets.straight_s = sample_time_s * static_cast<double>(count);
        if (offsets.straight_s < shortest_straight_s) {
            return offsets;
        }
        offsets.known = true;
        const double bank = mean(&DriveSample::bank_angle_rad, count);
        offsets.lateral_mps2 = mean(&DriveSample::lateral_specific_force_mps2, count) -
                               (std::isfinite(bank) ? g_mps2 * std::sin(bank) : 0.0);
        offsets.roll_angle_rad = mean(&DriveSample::roll_angle_rad, count);
        offsets.roll_rate_radps = mean(&DriveSample::roll_rate_radps, count);
        offsets.yaw_rate_radps = mean(&DriveSample::yaw_rate_radps, count);
        offsets.steering_wheel_angle_rad = mean(&DriveSample::steering_wheel_angle_rad, count);
        for (std::size_t k = 0U; k < count; ++k) {
            offsets.load_moment_nm +=
                load_moment_nm(cycles_[k].sample, vehicle_.track_width_m) / static_cast<double>(count);
        }
        return offsets;
    }

    Cut find_cut(const SensorOffsets& offsets) const {
        Cut cut;
        const auto earlier = [&cut](double time_s, const std::string& reason) {
            if (!cut.time_s || time_s < *cut.time_s) {
                cut = Cut{time_s, reason};
            }
        };
        if (cycles_.back().sample.time_s > options_.until_s) {
            earlier(options_.until_s, "as asked for");
        }
        if (drive_.one_wheel_lift_s) {
            earlier(*drive_.one_wheel_lift_s, "a wheel lifts, as the file says");
        }
        const bool loads = std::all_of(cycles_.begin(), cycles_.end(),
                                       [](const DriveCycle& cycle) { return has_loads(cycle.sample); });
        if (loads) {
            cut_by_loads(earlier);
        } else {
            cut_by_acceleration(offsets, earlier);
        }
        return cut;
    }

    template <typename Earlier>
    void cut_by_loads(const Earlier& earlier) const {
        for (const DriveCycle& cycle : cycles_) {
            for (std::size_t wheel = 0U; wheel < wheel_count; ++wheel) {
                const double at_start = cycles_.front().sample.wheel_load_n[wheel];
                if (cycle.sample.wheel_load_n[wheel] < lifted_load_share * at_start) {
                    earlier(cycle.sample.time_s, "a wheel lifts, as the wheel loads show");
                    return;
                }
            }
        }
    }

    template <typename Earlier>
    void cut_by_acceleration(const SensorOffsets& offsets, const Earlier& earlier) const {
        const Signal lateral = smooth(&DriveSample::lateral_specific_force_mps2);
        const Signal vertical = smooth(&DriveSample::vertical_specific_force_mps2);
        const Signal roll = smooth(&DriveSample::roll_angle_rad);
        const double limit = options_.lift_share * static_stability_factor(vehicle_);
        for (std::size_t k = 0U; k < lateral.size(); ++k) {
            const auto [parallel, normal] =
                road_forces(lateral[k] - offsets.lateral_mps2, vertical[k], roll[k] - offsets.roll_angle_rad);
            if (std::abs(parallel) > limit * normal) {
                earlier(
                    cycles_[k].sample.time_s,
                    fmt::format("{:.2f} g is reached, {:.0f} % of the track's half over the CG's height, and "
                                "without wheel loads nobody knows whether a wheel has lifted",
                                limit, 100.0 * options_.lift_share));
                return;
            }
        }
    }

    // f_cg = f_imu - alpha x r - omega x (omega x r) with pitch rate zero, as the firmware does it.
    void fill(PreparedDrive& prepared) const {
        const SensorOffsets& offsets = prepared.offsets;
        const Signal lateral = smooth(&DriveSample::lateral_specific_force_mps2);
        const Signal vertical = smooth(&DriveSample::vertical_specific_force_mps2);
        const Signal roll = smooth(&DriveSample::roll_angle_rad);
        const Signal roll_rate = smooth(&DriveSample::roll_rate_radps);
        const Signal yaw_rate = smooth(&DriveSample::yaw_rate_radps);
        const Signal speed = smooth(&DriveSample::speed_mps);
        const Signal steering = smooth(&DriveSample::steering_wheel_angle_rad);
        const Signal load_moment = smooth_load_moment();
        const Signal roll_acceleration = differentiate(roll_rate, sample_time_s);
        const Signal yaw_acceleration = differentiate(yaw_rate, sample_time_s);
        const double gyro_offset = offsets.known ? offsets.roll_rate_radps : mean_rate_error(roll, roll_rate);
        for (std::size_t k = edge; k + edge < roll.size(); ++k) {
            const double p = roll_rate[k] - gyro_offset;
            const double r = std::isfinite(yaw_rate[k]) ? yaw_rate[k] - offsets.yaw_rate_radps : 0.0;
            const double yaw = std::isfinite(yaw_acceleration[k]) ? yaw_acceleration[k] : 0.0;
            const double f_y = lateral[k] - offsets.lateral_mps2 -
                               (yaw * vehicle_.imu_x_m - roll_acceleration[k] * vehicle_.imu_z_m) +
                               (p * p + r * r) * vehicle_.imu_y_m;
            const double f_z = vertical[k] - roll_acceleration[k] * vehicle_.imu_y_m -
                               p * (r * vehicle_.imu_x_m - p * vehicle_.imu_z_m);
            const double phi = roll[k] - offsets.roll_angle_rad;
            const auto [parallel, normal] = road_forces(f_y, f_z, phi);
            prepared.samples.push_back(
                RollSample{cycles_[k].sample.time_s, parallel, normal, parallel + normal * std::tan(phi), phi,
                           p, roll_acceleration[k], yaw_rate[k] - offsets.yaw_rate_radps, speed[k],
                           steering[k] - (offsets.known && std::isfinite(offsets.steering_wheel_angle_rad)
                                              ? offsets.steering_wheel_angle_rad
                                              : 0.0),
                           load_moment[k] - (offsets.known ? offsets.load_moment_nm : 0.0)});
            prepared.largest_parallel_mps2 = std::max(prepared.largest_parallel_mps2, std::abs(parallel));
            prepared.largest_roll_angle_rad = std::max(prepared.largest_roll_angle_rad, std::abs(phi));
        }
        prepared.has_wheel_loads = complete(load_moment);
        prepared.has_steering = complete(yaw_rate) && complete(speed) && complete(steering);
    }

    // Without a straight start: what the gyro says too much between the first and the last roll angle.
    static double mean_rate_error(const Signal& roll, const Signal& roll_rate) {
        double sum = 0.0;
        for (const double rate : roll_rate) {
            sum += rate;
        }
        const double time_s = sample_time_s * static_cast<double>(roll.size() - 1U);
        return sum / static_cast<double>(roll_rate.size()) - (roll.back() - roll.front()) / time_s;
    }

    const Drive& drive_;
    const VehicleData& vehicle_;
    const PreparationOptions& options_;
    Cycles cycles_;
};

}  // namespace

PreparedDrive prepare_drive(const Drive& drive, const VehicleData& vehicle,
                            const PreparationOptions& options) {
    return Preparation{drive, vehicle, options}.run();
}

}  // namespace sil
