#include "sil/studies/identification/prepared_drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sil/studies/drives/resample.hpp"
#include "sil/studies/identification/drive_signals.hpp"
#include "sil/studies/identification/lift_cut.hpp"
#include "sil/studies/identification/signs_and_units.hpp"
#include "sil/studies/identification/zero_phase_filter.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double straight_steering_rad = 0.6 / degrees_per_radian;  // at the steering wheel
constexpr double straight_yaw_rate_radps = 0.008;
// Much, because of the noise that the filter leaves: a slow turn shows late.
constexpr double straight_acceleration_mps2 = 0.25;
constexpr double straight_acceleration_share = 0.5;
constexpr double turn_radps = 0.05;  // a steady turn is not a straight road
constexpr double turn_mps2 = 1.0;    // nor is this a sensor's offset
constexpr double shortest_straight_s = 0.3;
constexpr std::size_t shortest_segment = 50U;
constexpr std::size_t edge = 5U;  // samples at both ends where filter and derivative do not commute

class Preparation {
 public:
    Preparation(const Drive& drive, const VehicleData& vehicle, const PreparationOptions& options)
        : drive_{drive}, vehicle_{vehicle}, options_{options} {}

    PreparedDrive run() {
        refuse_without_roll_angle();
        cycles_ = longest_whole_part(to_cycles(drive_));
        refuse_too_short("");
        refuse_wrong_signs_and_units(drive_, cycles_, options_.filter_lag_s);
        PreparedDrive prepared;
        prepared.name = drive_.name;
        prepared.offsets = offsets();
        const Cut cut = find_cut(drive_, cycles_, vehicle_, options_, prepared.offsets);
        prepared.cut_s = cut.time_s;
        prepared.cut_reason = cut.reason;
        prepared.cut_by_load_transfer = cut.by_load_transfer;
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
                            "column roll_angle_deg (of the body relative to the road, for example from "
                            "two ride-height sensors)",
                            drive_.name));
        }
    }

    void refuse_too_short(const std::string& reason) const {
        if (cycles_.size() < shortest_segment) {
            throw IdentificationError(
                fmt::format("{}: only {:.2f} s can be used{}{}. Record at least some seconds with lateral "
                            "acceleration, roll rate and roll angle all present before a wheel lifts",
                            drive_.name, sample_time_s * static_cast<double>(cycles_.size()),
                            reason.empty() ? "" : ": ", reason));
        }
    }

    Signal smooth(double DriveSample::* member) const {
        return sil::smooth(cycles_, member, options_.filter_lag_s);
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

    // A signal that tells straight from turn.
    struct Straight {
        const char* judged_by;
        Signal signal;
        double limit;
        double share{1.0};  // that is straight of what looks so
    };

    // The earlier it shows the turn, the better.
    Straight straight() const {
        Signal steering = smooth(&DriveSample::steering_wheel_angle_rad);
        if (complete(steering)) {
            return {"steering-wheel angle", std::move(steering), straight_steering_rad};
        }
        Signal yaw_rate = smooth(&DriveSample::yaw_rate_radps);
        if (complete(yaw_rate)) {
            return {"yaw rate", std::move(yaw_rate), straight_yaw_rate_radps};
        }
        return {"lateral acceleration", smooth(&DriveSample::lateral_acceleration_mps2),
                straight_acceleration_mps2, straight_acceleration_share};
    }

    // How many samples pass before the driver steers.
    std::size_t straight_samples(const Straight& straight) const {
        const Signal& signal = straight.signal;
        std::size_t count = 0U;
        while (count < signal.size() && std::abs(signal[count] - signal.front()) < straight.limit) {
            ++count;
        }
        // The filter lets the turn shine back.
        const auto margin = static_cast<std::size_t>(4.0 * options_.filter_lag_s / sample_time_s);
        count = count > margin ? count - margin : 0U;
        return starts_in_a_turn() ? 0U
                                  : static_cast<std::size_t>(straight.share * static_cast<double>(count));
    }

    bool starts_in_a_turn() const {
        const Signal yaw_rate = smooth(&DriveSample::yaw_rate_radps);
        return complete(yaw_rate)
                   ? std::abs(yaw_rate.front()) > turn_radps
                   : std::abs(smooth(&DriveSample::lateral_acceleration_mps2).front()) > turn_mps2;
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
        const Straight straight = this->straight();
        offsets.judged_by = straight.judged_by;
        const std::size_t count = straight_samples(straight);
        offsets.straight_s = sample_time_s * static_cast<double>(count);
        if (offsets.straight_s < shortest_straight_s) {
            return offsets;
        }
        offsets.known = true;
        const double bank = mean(&DriveSample::bank_angle_rad, count);
        offsets.lateral_mps2 = mean(&DriveSample::lateral_acceleration_mps2, count) -
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

    // f_cg = f_imu - alpha x r - omega x (omega x r) with pitch rate zero, as the firmware does it.
    void fill(PreparedDrive& prepared) const {
        const SensorOffsets& offsets = prepared.offsets;
        const Signal lateral = smooth(&DriveSample::lateral_acceleration_mps2);
        const Signal vertical = smooth(&DriveSample::vertical_acceleration_mps2);
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
