// Draw: a counter-based random number a quantity, scaled to its interval.
#include "sil/studies/campaign/draw.hpp"

#include "sil/random.hpp"
#include "sil/world/sensors/sensor_options.hpp"

namespace sil {
namespace {

// The numbers are part of the reproducible result: never change one, only add.
enum class Quantity : std::uint64_t {
    vehicle = 1,
    manoeuvre = 2,
    direction = 3,
    speed_factor = 4,
    steering_factor = 5,
    friction_factor = 6,
    load_share = 7,
    load_height_factor = 8,
    cg_height_error = 9,
    stiffness_error = 10,
    mass_error = 11,
    lateral_bias = 12,
    vertical_bias = 13,
    sensor_seed = 14,
    mass_sensor_error = 15,
    roll_tilt = 16,
    pitch_tilt = 17,
    yaw_tilt = 18,
    lever_arm_x = 19,
    lever_arm_y = 20,
    lever_arm_z = 21,
    mass_signal_factor = 22,
    handwheel_rate = 23,
};

class RandomNumbers {
 public:
    RandomNumbers(std::uint64_t seed, std::uint64_t run) : key_{scrambled(scrambled(seed) ^ run)} {}

    std::uint64_t bits(Quantity quantity) const {
        return scrambled(key_ ^ scrambled(static_cast<std::uint64_t>(quantity)));
    }

    // Uniform on [0, 1), a multiple of 2^-53.
    double unit(Quantity quantity) const { return unit_interval(bits(quantity)); }

    double within(Quantity quantity, const Interval& interval) const {
        return interval.lowest + unit(quantity) * (interval.highest - interval.lowest);
    }

    double either_way(Quantity quantity, double largest) const {
        return within(quantity, {-largest, largest});
    }

 private:
    std::uint64_t key_;
};

std::size_t weighted_manoeuvre(const std::vector<CampaignManoeuvre>& manoeuvres, double unit) {
    double sum = 0.0;
    for (const CampaignManoeuvre& manoeuvre : manoeuvres) {
        sum += manoeuvre.weight;
    }
    double left = unit * sum;
    for (std::size_t i = 0U; i + 1U < manoeuvres.size(); ++i) {
        left -= manoeuvres[i].weight;
        if (left < 0.0) {
            return i;
        }
    }
    return manoeuvres.size() - 1U;
}

// A vehicle's own factor for a manoeuvre.
double factor_of(const std::vector<double>& factors, std::size_t manoeuvre) {
    return factors.empty() ? 1.0 : factors[manoeuvre];
}

}  // namespace

RunDraw draw_run(const CampaignSettings& settings, std::uint64_t number) {
    const RandomNumbers random{settings.seed, number};
    const CampaignSpread& spread = settings.spread;
    RunDraw draw;
    draw.number = number;
    draw.vehicle = static_cast<std::size_t>(random.unit(Quantity::vehicle) *
                                            static_cast<double>(settings.vehicles.size()));
    draw.manoeuvre = weighted_manoeuvre(settings.manoeuvres, random.unit(Quantity::manoeuvre));
    const CampaignManoeuvre& manoeuvre = settings.manoeuvres[draw.manoeuvre];
    draw.mirrored = random.unit(Quantity::direction) < 0.5;
    const CampaignVehicle& vehicle = settings.vehicles[draw.vehicle];
    draw.speed_factor = random.within(Quantity::speed_factor, manoeuvre.speed_factor) *
                        factor_of(vehicle.speed_factors, draw.manoeuvre);
    draw.steering_factor = random.within(Quantity::steering_factor, manoeuvre.steering_factor) *
                           factor_of(vehicle.steering_factors, draw.manoeuvre);
    draw.handwheel_rate_degps = random.within(Quantity::handwheel_rate, manoeuvre.handwheel_rate_degps);
    draw.friction_factor = random.within(Quantity::friction_factor, spread.friction_factor);
    draw.load_share = random.within(Quantity::load_share, spread.load_share);
    draw.load_height_factor = random.within(Quantity::load_height_factor, spread.load_height_factor);
    draw.cg_height_error = random.either_way(Quantity::cg_height_error, spread.cg_height_error);
    draw.stiffness_error = random.either_way(Quantity::stiffness_error, spread.stiffness_error);
    draw.mass_error = random.either_way(Quantity::mass_error, spread.mass_error);
    draw.mass_sensor_error = random.either_way(
        Quantity::mass_sensor_error, vehicle.mass_sensor && spread.sensor_noise ? mass_sensor_accuracy : 0.0);
    if (vehicle.mass_sensor && !is_one(spread.mass_signal_factor)) {
        const double factor = random.within(Quantity::mass_signal_factor, spread.mass_signal_factor);
        draw.mass_sensor_error = factor * (1.0 + draw.mass_sensor_error) - 1.0;
    }
    draw.lateral_bias_g = random.either_way(Quantity::lateral_bias, spread.accelerometer_bias_g);
    draw.vertical_bias_g = random.either_way(Quantity::vertical_bias, spread.accelerometer_bias_g);
    draw.housing_tilt_deg = {random.either_way(Quantity::roll_tilt, spread.housing_tilt_deg),
                             random.either_way(Quantity::pitch_tilt, spread.housing_tilt_deg),
                             random.either_way(Quantity::yaw_tilt, spread.housing_tilt_deg)};
    draw.lever_arm_error_m = {random.either_way(Quantity::lever_arm_x, spread.lever_arm_error_m),
                              random.either_way(Quantity::lever_arm_y, spread.lever_arm_error_m),
                              random.either_way(Quantity::lever_arm_z, spread.lever_arm_error_m)};
    draw.sensor_seed = random.bits(Quantity::sensor_seed) >> 1U;
    return draw;
}

}  // namespace sil
