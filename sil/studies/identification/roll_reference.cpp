#include "sil/studies/identification/roll_reference.hpp"

#include <fmt/format.h>

#include <cmath>

#include "sil/studies/identification/bisection.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr double clear_bank_rad = 0.5 / degrees_per_radian;
constexpr double bank_agreement = 0.3;  // of the angle
constexpr double bank_share = 0.5;      // of the bank that the angle must follow
constexpr double bank_correlation = 0.7;
constexpr double steep_bank_rad = 1.0 / degrees_per_radian;  // more than a slide looks like
constexpr double bank_rest = 0.3;                            // of it, in an angle that does not follow
constexpr double steady_radps = 0.05;                        // a body that rolls faster also slips
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

struct BankFollowed {
    double share{};  // of the bank's changes
    double correlation{};
    double bank_rms_rad{};
};

// The accelerometer tells both angles: what the suspension yields to is all that it shows, and what is not
// yaw rate times speed is gravity's share.
BankFollowed bank_followed(const VehicleData& vehicle, const RollFit& roll, const PreparedDrive& drive) {
    double count = 0.0, b = 0.0, e = 0.0, bb = 0.0, be = 0.0, ee = 0.0;
    for (const RollSample& sample : drive.samples) {
        if (sample.speed_mps > steady_mps && std::abs(sample.roll_rate_radps) < steady_radps) {
            const double force = sample.overturning_mps2 * std::cos(sample.roll_angle_rad);
            const double suspension =
                suspension_angle_rad(roll, vehicle.sprung_mass_kg * roll.arm_m * sample.overturning_mps2);
            const double bank = (force - sample.yaw_rate_radps * sample.speed_mps) / g_mps2 - suspension;
            const double more = sample.roll_angle_rad - suspension;
            count += 1.0;
            b += bank;
            e += more;
            bb += bank * bank;
            be += bank * more;
            ee += more * more;
        }
    }
    if (count < static_cast<double>(fewest_steady_samples)) {
        return {};
    }
    const double bank_variance = (bb - b * b / count) / count;
    const double common = (be - b * e / count) / count;
    const double variance = (ee - e * e / count) / count;
    if (!(bank_variance > 0.0 && variance > 0.0)) {
        return {};
    }
    return {common / bank_variance, common / std::sqrt(bank_variance * variance), std::sqrt(bank_variance)};
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
    const BankFollowed followed = bank_followed(vehicle, roll, drive);
    if (followed.bank_rms_rad > clear_bank_rad && followed.share > bank_share &&
        followed.correlation > bank_correlation) {
        return SeenRollReference{RollReference::horizon,
                                 fmt::format("the roll angle moves with the road's bank, by {:.0f} % of it",
                                             100.0 * followed.share)};
    }
    if (followed.bank_rms_rad > steep_bank_rad && std::abs(followed.share) < bank_rest) {
        return SeenRollReference{
            RollReference::road,
            fmt::format("the road's bank moves by {:.1f} deg rms, and the roll angle does not follow it",
                        followed.bank_rms_rad * degrees_per_radian)};
    }
    return std::nullopt;
}

}  // namespace sil
