// RollSensor: roll and bank with their errors.
#include "sil/world/sensors/roll_sensor.hpp"

namespace sil {

RollSensor::RollSensor(const RollSensorOptions& options, std::uint64_t seed)
    : reference_(options.reference),
      reports_bank_(options.reports_bank),
      roll_angle_(options.roll_angle_rad, seed, NoiseStream::roll_angle),
      bank_angle_(options.bank_angle_rad, seed, NoiseStream::bank_angle) {}

void RollSensor::report(const Truth& truth, SensorSample& sample) {
    const bool against_horizon = reference_ == RollReference::horizon;
    sample.roll_angle_rad =
        roll_angle_.measure(against_horizon ? truth.roll_to_horizon_rad : truth.roll_angle_rad);
    sample.bank_angle_rad =
        reports_bank_ ? bank_angle_.measure(truth.bank_angle_rad) : SensorSample::not_available;
}

}  // namespace sil
