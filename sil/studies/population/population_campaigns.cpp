#include "sil/studies/population/population_campaigns.hpp"

#include <algorithm>
#include <cmath>

#include "sil/units.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/mixed_driving.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

constexpr std::uint64_t runs_a_vehicle = 100U;
constexpr double two_minutes_s = 120.0;
constexpr std::uint64_t ordinary_runs_a_vehicle = 3U;  // of ten minutes
constexpr double reference_threshold_g = 0.75;
// The firmware takes an angle beyond 15 rad for a fault of the sensor.
constexpr double largest_handwheel_rad = 13.0;

// Unit of a manoeuvre's steering, and thus what it needs to be as severe for any vehicle.
enum class Steering {
    angle,         // degrees at the handwheel, the same for every vehicle
    acceleration,  // the vehicle's own angle for 0.3 g
    path,          // as the path needs: only speed makes it severe
    straight,      // never severe
};

struct ScaledManoeuvre {
    CampaignManoeuvre drawn;
    Steering steering;
    // Reference at which a factor of 1 gives the acceleration that lifts the inner wheels: at this factor of
    // the speed.
    double limit_speed_factor;
    double angle_rad;       // `angle` only: at the handwheel, with a factor of 1
    double acceleration_g;  // `acceleration` only: at 50 mph with a factor of 1
};

constexpr double degrees(double value) {
    return value / degrees_per_radian;
}

// Speed of the hands in deg/s, from that of a calm turn to that of a panic; a fishhook is never calm.
constexpr Interval hands{200.0, 1200.0};
constexpr Interval fast_hands{500.0, 1200.0};

// Steering factors are shares of what lifts the inner wheels in a slow turn; a manoeuvre's own swing adds to
// that.
const std::vector<ScaledManoeuvre>& scaled_driving() {
    static const std::vector<ScaledManoeuvre> list{
        {{"j-turn-110", 1.0, {0.55, 1.1}, {0.4, 2.0}, 0.0, hands}, Steering::angle, 0.8, degrees(360.0), 0.0},
        {{"j-turn-45", 1.0, {1.0, 2.4}, {0.4, 1.6}, 0.0, hands}, Steering::angle, 1.6, degrees(360.0), 0.0},
        {{"j-turn-banked", 0.5, {0.3, 0.75}, {0.9, 1.1}, 0.0}, Steering::path, 0.0, 0.0, 0.0},
        {{"fishhook-1a", 1.0, {0.55, 1.1}, {0.4, 1.4}, 0.0, fast_hands},
         Steering::acceleration,
         0.8,
         0.0,
         6.5 * 0.3},
        {{"fishhook-1b", 1.0, {0.55, 1.1}, {0.4, 1.3}, 0.0, fast_hands},
         Steering::acceleration,
         0.8,
         0.0,
         6.5 * 0.3},
        {{"sine-with-dwell", 1.0, {0.7, 1.3}, {0.6, 3.0}, 0.0}, Steering::angle, 0.95, degrees(285.0), 0.0},
        {{"double-lane-change", 1.0, {0.55, 1.3}, {0.9, 1.1}, 0.0}, Steering::path, 0.0, 0.0, 0.0},
        {{"slalom", 1.0, {0.7, 1.3}, {0.4, 1.8}, 15.0}, Steering::angle, 0.95, degrees(42.0), 0.0},
        {{"step-steer", 1.0, {0.65, 1.3}, {0.35, 1.2}, 0.0, hands}, Steering::acceleration, 0.95, 0.0, 0.4},
        {{"braking-in-turn", 1.0, {0.65, 1.2}, {0.35, 1.2}, 0.0}, Steering::acceleration, 0.9, 0.0, 0.5},
        {{"rough-turn", 1.0, {0.6, 1.2}, {0.2, 0.8}, 12.0}, Steering::acceleration, 0.9, 0.0, 0.3},
        {{"slow-ramp", 0.25, {0.7, 1.4}, {1.0, 1.0}, 60.0}, Steering::straight, 0.0, 0.0, 0.0},
        {{"rough-road", 0.3, {0.4, 1.3}, {1.0, 1.0}, 12.0}, Steering::straight, 0.0, 0.0, 0.0},
        {{"one-sided-bump", 0.3, {0.4, 2.0}, {1.0, 1.0}, 0.0}, Steering::straight, 0.0, 0.0, 0.0},
        {{"banked-straight", 0.3, {0.4, 1.3}, {1.0, 1.0}, 12.0}, Steering::straight, 0.0, 0.0, 0.0},
        {{"straight", 0.2, {0.3, 1.2}, {1.0, 1.0}, 8.0}, Steering::straight, 0.0, 0.0, 0.0},
        {{"decreasing-radius", 1.0, {0.65, 1.4}, {0.9, 1.1}, 0.0}, Steering::path, 0.0, 0.0, 0.0},
        {{"crowned-road", 1.0, {0.55, 1.3}, {0.9, 1.1}, 0.0}, Steering::path, 0.0, 0.0, 0.0},
        {{"split-friction", 0.5, {0.65, 1.3}, {0.4, 1.6}, 0.0}, Steering::acceleration, 0.95, 0.0, 0.5},
        {{"gust", 0.5, {0.65, 1.3}, {0.35, 1.2}, 0.0}, Steering::acceleration, 0.95, 0.0, 0.5},
        {{"tyre-failure", 0.5, {0.65, 1.3}, {0.3, 1.2}, 0.0}, Steering::acceleration, 0.95, 0.0, 0.4},
        {{"sloshing-load", 0.5, {0.65, 1.3}, {0.35, 1.2}, 0.0}, Steering::acceleration, 0.95, 0.0, 0.5},
        {{"sliding-load", 0.5, {0.65, 1.3}, {0.35, 1.2}, 0.0}, Steering::acceleration, 0.95, 0.0, 0.5},
        {{"trailer", 0.5, {0.65, 1.2}, {0.35, 1.2}, 0.0}, Steering::acceleration, 0.9, 0.0, 0.5},
    };
    return list;
}

const std::vector<ScaledManoeuvre>& scaled_tripping() {
    static const std::vector<ScaledManoeuvre> list{
        {{"kerb-trip", 1.0, {0.35, 1.1}, {1.0, 1.0}, 0.0}, Steering::straight, 0.0, 0.0, 0.0},
        {{"soil-trip", 1.0, {0.4, 1.3}, {1.0, 1.0}, 0.0}, Steering::straight, 0.0, 0.0, 0.0},
    };
    return list;
}

const std::vector<ScaledManoeuvre>& scaled_manoeuvres(ManoeuvreMixture mixture) {
    return mixture == ManoeuvreMixture::tripping ? scaled_tripping() : scaled_driving();
}

std::vector<CampaignManoeuvre> drawn_manoeuvres(ManoeuvreMixture mixture) {
    std::vector<CampaignManoeuvre> list;
    for (const ScaledManoeuvre& manoeuvre : scaled_manoeuvres(mixture)) {
        list.push_back(manoeuvre.drawn);
    }
    return list;
}

struct Factors {
    double speed{1.0};
    double steering{1.0};
};

Factors factors_for(const ScaledManoeuvre& manoeuvre, const VehicleParameters& vehicle,
                    double max_speed_mps) {
    const double nominal_mps = find_manoeuvre(manoeuvre.drawn.name).initial_speed_mps;
    const double threshold_g = properties(vehicle).threshold_g;
    Factors factors;
    if (manoeuvre.steering == Steering::path) {
        factors.speed = std::sqrt(threshold_g / reference_threshold_g);
    }
    factors.speed =
        std::min(factors.speed, max_speed_mps / (nominal_mps * manoeuvre.drawn.speed_factor.highest));
    const double limit_mps = manoeuvre.limit_speed_factor * factors.speed * nominal_mps;
    if (manoeuvre.steering == Steering::angle || manoeuvre.steering == Steering::acceleration) {
        const double wanted_rad = handwheel_for_rad(vehicle, threshold_g * g_mps2, limit_mps);
        constexpr double fifty_mph_mps = 22.352;
        const double unscaled_rad =
            manoeuvre.steering == Steering::angle
                ? manoeuvre.angle_rad
                : handwheel_for_rad(vehicle, manoeuvre.acceleration_g * g_mps2, fifty_mph_mps);
        const double most_rad = largest_handwheel_rad / manoeuvre.drawn.steering_factor.highest;
        factors.steering = std::clamp(std::min(wanted_rad, most_rad) / unscaled_rad,
                                      vehicle_factor_range.lowest, vehicle_factor_range.highest);
    }
    return factors;
}

std::vector<CampaignManoeuvre> ordinary_manoeuvres() {
    CampaignManoeuvre manoeuvre;
    manoeuvre.name = ordinary_driving_name;
    return {manoeuvre};
}

// Relative, because the folder of the population may move.
std::string beside_settings(const std::filesystem::path& population, const std::filesystem::path& file) {
    return "./" + file.lexically_relative(population).generic_string();
}

// Truck drivers turn less hard than car drivers, and slower.
CampaignVehicle calmed_vehicle(const DrawnVehicle& vehicle, const VehicleParameters& driven) {
    const VehicleClass& from = vehicle_classes()[vehicle.in_class];
    const double nominal_mps = campaign_manoeuvre(ordinary_driving_name).initial_speed_mps;
    CampaignVehicle calmed;
    calmed.in_class = from.name;
    calmed.speed_factors = {std::min(1.0, from.max_speed_kmh / 3.6 / nominal_mps)};
    calmed.steering_factors = {std::min(1.0, properties(driven).threshold_g / reference_threshold_g)};
    return calmed;
}

}  // namespace

const std::vector<CampaignVariant>& campaign_variants() {
    static const std::vector<CampaignVariant> all{
        CampaignVariant::clean,           CampaignVariant::errors,
        CampaignVariant::learnt,          CampaignVariant::without_wheel_loads,
        CampaignVariant::loaded,          CampaignVariant::unloaded,
        CampaignVariant::wrongly_mounted, CampaignVariant::wrong_mass,
        CampaignVariant::tripping,        CampaignVariant::ordinary};
    return all;
}

const char* variant_name(CampaignVariant variant) {
    switch (variant) {
        case CampaignVariant::clean:
            return "clean";
        case CampaignVariant::errors:
            return "errors";
        case CampaignVariant::learnt:
            return "learnt";
        case CampaignVariant::without_wheel_loads:
            return "without_wheel_loads";
        case CampaignVariant::loaded:
            return "loaded";
        case CampaignVariant::unloaded:
            return "unloaded";
        case CampaignVariant::wrongly_mounted:
            return "wrongly_mounted";
        case CampaignVariant::wrong_mass:
            return "wrong_mass";
        case CampaignVariant::tripping:
            return "tripping";
        case CampaignVariant::ordinary:
            return "ordinary";
    }
    return "";
}

std::filesystem::path vehicle_file(const std::filesystem::path& population, const DrawnVehicle& vehicle,
                                   bool loaded) {
    return population / (loaded ? "vehicles_loaded" : "vehicles") / (vehicle.name + ".toml");
}

std::filesystem::path data_file(const std::filesystem::path& population, const DrawnVehicle& vehicle,
                                bool loaded) {
    return population / (loaded ? "data_loaded" : "data") / (vehicle.name + ".toml");
}

std::filesystem::path calibration_file(const std::filesystem::path& population, const DrawnVehicle& vehicle,
                                       CalibrationKind kind) {
    const char* const folder = kind == CalibrationKind::with_loads      ? "calibrations"
                               : kind == CalibrationKind::without_loads ? "calibrations_without_loads"
                                                                        : "calibrations_loaded";
    return population / folder / (vehicle.name + ".toml");
}

const std::vector<CampaignManoeuvre>& population_manoeuvres(ManoeuvreMixture mixture) {
    static const std::vector<CampaignManoeuvre> driving = drawn_manoeuvres(ManoeuvreMixture::driving);
    static const std::vector<CampaignManoeuvre> tripping = drawn_manoeuvres(ManoeuvreMixture::tripping);
    return mixture == ManoeuvreMixture::tripping ? tripping : driving;
}

CampaignVehicle scaled_vehicle(const DrawnVehicle& vehicle, const VehicleParameters& driven,
                               ManoeuvreMixture mixture) {
    const VehicleClass& from = vehicle_classes()[vehicle.in_class];
    CampaignVehicle scaled;
    scaled.in_class = from.name;
    for (const ScaledManoeuvre& manoeuvre : scaled_manoeuvres(mixture)) {
        const Factors factors = factors_for(manoeuvre, driven, from.max_speed_kmh / 3.6);
        scaled.speed_factors.push_back(factors.speed);
        scaled.steering_factors.push_back(factors.steering);
    }
    return scaled;
}

CampaignSettings population_campaign(const std::filesystem::path& population,
                                     const std::vector<DrawnVehicle>& vehicles, CampaignVariant variant,
                                     std::uint64_t seed) {
    const bool driven_loaded = variant == CampaignVariant::loaded;
    const CalibrationKind kind = variant == CampaignVariant::without_wheel_loads
                                     ? CalibrationKind::without_loads
                                 : variant == CampaignVariant::unloaded ? CalibrationKind::of_loaded_vehicle
                                                                        : CalibrationKind::with_loads;
    CampaignSettings settings;
    settings.seed = seed;
    const bool ordinary = variant == CampaignVariant::ordinary;
    const ManoeuvreMixture mixture =
        variant == CampaignVariant::tripping ? ManoeuvreMixture::tripping : ManoeuvreMixture::driving;
    settings.manoeuvres = ordinary ? ordinary_manoeuvres() : population_manoeuvres(mixture);
    settings.spread.friction_factor = {0.7, 1.2};
    const bool wrongly_loaded = driven_loaded || variant == CampaignVariant::unloaded;
    settings.spread.load_is_known = !wrongly_loaded;
    const bool learns =
        wrongly_loaded || variant == CampaignVariant::learnt || variant == CampaignVariant::wrong_mass;
    settings.learning_s = learns ? two_minutes_s : 0.0;
    settings.spread.sensor_noise = variant != CampaignVariant::clean;
    if (variant != CampaignVariant::clean) {
        settings.spread.cg_height_error = 0.05;
        settings.spread.stiffness_error = 0.10;
    }
    if (variant == CampaignVariant::wrongly_mounted) {
        settings.spread.housing_tilt_deg = 2.0;
        settings.spread.lever_arm_error_m = 0.1;
    }
    if (variant == CampaignVariant::wrong_mass) {
        settings.spread.mass_signal_factor = {0.85, 1.3};
    }
    for (const DrawnVehicle& vehicle : vehicles) {
        const std::filesystem::path calibration = calibration_file(population, vehicle, kind);
        if (!std::filesystem::exists(calibration)) {
            continue;  // identification failed, as vehicles.csv says
        }
        const std::filesystem::path file = vehicle_file(population, vehicle, driven_loaded);
        const VehicleParameters driven = load_vehicle(file);
        CampaignVehicle scaled =
            ordinary ? calmed_vehicle(vehicle, driven) : scaled_vehicle(vehicle, driven, mixture);
        scaled.parameters = beside_settings(population, file);
        scaled.calibration = beside_settings(population, calibration);
        scaled.mass_sensor = vehicle_classes()[vehicle.in_class].mass_sensor;
        settings.vehicles.push_back(scaled);
    }
    settings.runs = (ordinary ? ordinary_runs_a_vehicle : runs_a_vehicle) *
                    std::max<std::uint64_t>(1U, settings.vehicles.size());
    return settings;
}

}  // namespace sil
