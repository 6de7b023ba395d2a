#include "sil/studies/identification/roll_reference.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>

#include <cmath>
#include <vector>

#include "sil/studies/identification/bisection.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double clear_bank_rad = 0.5 / degrees_per_radian;
constexpr double bank_agreement = 0.3;  // of the angle
constexpr double followed_share = 0.7;  // of the bank that the angle must follow
constexpr double not_followed_share = 0.3;
constexpr double confirmed_share = 0.5;  // of the bank, by which the accelerometer may see more or less
constexpr double bank_correlation = 0.7;
constexpr double largest_tyre_roll_radpmps2 = 2.5 / degrees_per_radian / g_mps2;
constexpr double steady_radps = 0.05;  // a body that rolls faster is not where its suspension would hold it
constexpr double steady_mps = 5.0;
constexpr std::size_t fewest_steady_samples = 100U;

// At rest on a bank an accelerometer and an attitude sensor show the same angle, which a sensor of the
// suspension hardly sees.
bool straight_shows_bank(const SensorOffsets& offsets) {
    const double bank_rad = offsets.lateral_mps2 / g_mps2;
    return offsets.known && std::abs(offsets.roll_angle_rad) > clear_bank_rad &&
           std::abs(offsets.roll_angle_rad - bank_rad) < bank_agreement * std::abs(bank_rad);
}

// The angle of the suspension at which its moment is `moment_nm`.
double suspension_angle_rad(const RollFit& roll, double moment_nm) {
    const double angle =
        last_where([&](double phi) { return roll.moment_nm(phi) < std::abs(moment_nm); }, 0.0, 0.5);
    return std::copysign(angle, moment_nm);
}

// Signs of a road's bank, sample by sample.
struct BankSigns {
    std::vector<double> bank_rad;  // by the roll rate: the body's inclination less the suspension's angle
    std::vector<double>
        accelerometer_rad;          // the same by the accelerometer; sideslip that grows looks like it
    std::vector<double> angle_rad;  // roll angle less the suspension's angle
    std::vector<double> time_s;
    std::vector<double> turn_mps2;
};

// Only where the suspension's angle is known from the force; the roll rate is integrated over all.
BankSigns bank_signs(const VehicleData& vehicle, const RollFit& roll, const PreparedDrive& drive) {
    BankSigns signs;
    double inclination_rad = 0.0;
    for (const RollSample& sample : drive.samples) {
        inclination_rad += sample_time_s * sample.roll_rate_radps;
        if (sample.speed_mps > steady_mps && std::abs(sample.roll_rate_radps) < steady_radps) {
            const double force = sample.overturning_mps2 * std::cos(sample.roll_angle_rad);
            const double turn = sample.yaw_rate_radps * sample.speed_mps;
            const double suspension =
                suspension_angle_rad(roll, vehicle.sprung_mass_kg * roll.arm_m * sample.overturning_mps2);
            signs.bank_rad.push_back(inclination_rad - suspension);
            signs.accelerometer_rad.push_back((force - turn) / g_mps2 - suspension);
            signs.angle_rad.push_back(sample.roll_angle_rad - suspension);
            signs.time_s.push_back(sample.time_s);
            signs.turn_mps2.push_back(turn);
        }
    }
    return signs;
}

// Less what a gyro's offset explains, which grows with time, and what tyres that roll do, or a suspension
// that was fitted a little too stiff, which grow with the turn: in a turn, a bank beyond that is left.
Eigen::MatrixXd unexplained(const BankSigns& signs) {
    const auto column = [](const std::vector<double>& values) {
        return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    };
    const Eigen::VectorXd time = column(signs.time_s), turn = column(signs.turn_mps2);
    Eigen::MatrixXd explains(time.size(), 3), seen(time.size(), 3);
    explains << turn, Eigen::VectorXd::Ones(time.size()), time;
    seen << column(signs.bank_rad), column(signs.accelerometer_rad), column(signs.angle_rad);
    const Eigen::MatrixXd shares = explains.colPivHouseholderQr().solve(seen);
    seen -= turn * shares.row(0).cwiseMax(0.0).cwiseMin(largest_tyre_roll_radpmps2);
    const Eigen::MatrixXd drift = explains.rightCols(2);
    return seen - drift * drift.colPivHouseholderQr().solve(seen);
}

struct BankFollowed {
    double share{};  // of the bank's changes, by the roll angle
    double bank_rms_rad{};
};

// By the roll rate, which no sideslip reaches, and only where the accelerometer says the same. Nothing where
// no bank is sure.
std::optional<BankFollowed> bank_followed(const VehicleData& vehicle, const RollFit& roll,
                                          const PreparedDrive& drive) {
    const BankSigns signs = bank_signs(vehicle, roll, drive);
    if (signs.time_s.size() < fewest_steady_samples) {
        return std::nullopt;
    }
    const Eigen::MatrixXd seen = unexplained(signs);
    const Eigen::Vector3d common = seen.transpose() * seen.col(0);
    const double bank_rms_rad = std::sqrt(common[0] / static_cast<double>(seen.rows()));
    if (!(bank_rms_rad > clear_bank_rad)) {
        return std::nullopt;
    }
    const double confirmed = common[1] / common[0];
    const double correlation = common[1] / std::sqrt(common[0] * seen.col(1).squaredNorm());
    if (std::abs(confirmed - 1.0) > confirmed_share || correlation < bank_correlation) {
        return std::nullopt;
    }
    return BankFollowed{common[2] / common[0], bank_rms_rad};
}

}  // namespace

std::optional<SeenRollReference> seen_roll_reference(const VehicleData& vehicle, const RollFit& roll,
                                                     const PreparedDrive& drive) {
    if (straight_shows_bank(drive.offsets)) {
        return SeenRollReference{
            RollReference::horizon,
            fmt::format(
                "on the straight the roll angle and the accelerometer show the same bank, {:+.1f} deg",
                drive.offsets.roll_angle_rad * degrees_per_radian)};
    }
    if (!drive.has_steering) {
        return std::nullopt;
    }
    const auto followed = bank_followed(vehicle, roll, drive);
    if (!followed) {
        return std::nullopt;
    }
    if (followed->share > followed_share) {
        return SeenRollReference{RollReference::horizon,
                                 fmt::format("the roll angle moves with the road's bank, by {:.0f} % of it",
                                             100.0 * followed->share)};
    }
    if (followed->share < not_followed_share) {
        return SeenRollReference{
            RollReference::road,
            fmt::format("the road's bank moves by {:.1f} deg rms, and the roll angle does not follow it",
                        followed->bank_rms_rad * degrees_per_radian)};
    }
    return std::nullopt;
}

}  // namespace sil
