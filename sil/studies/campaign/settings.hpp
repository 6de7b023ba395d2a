// Campaign settings: which vehicles, manoeuvres and spreads the runs of a Monte Carlo campaign are drawn
// from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sil/input_error.hpp"
#include "sil/world/manoeuvres/intervention.hpp"
#include "sil/world/manoeuvres/manoeuvre.hpp"

namespace sil {

// Both ends belong to it.
struct Interval {
    double lowest{0.0};
    double highest{0.0};
};

// Range of a vehicle's own factors of speed and steering.
inline constexpr Interval vehicle_factor_range{0.05, 20.0};

// A factor that changes nothing.
inline bool is_one(const Interval& factor) {
    return factor.lowest == 1.0 && factor.highest == 1.0;
}

// A simulated vehicle and the firmware's calibration for it; relative paths start from the current folder. In
// a settings file a path that begins with "./" or "../" starts from the folder of that file.
struct CampaignVehicle {
    std::string parameters;
    std::string calibration;
    std::string in_class{};   // a group of the report; may be empty
    bool mass_sensor{false};  // true: the vehicle's mass is on the bus
    // One for each manoeuvre, in their order: what is right for one vehicle is calm or wild for another.
    // Times the drawn factors; empty: 1.
    std::vector<double> speed_factors{};
    std::vector<double> steering_factors{};
};

// One manoeuvre of the catalogue, or `ordinary-driving`, and how it is varied.
struct CampaignManoeuvre {
    std::string name;
    double weight{1.0};                  // its share of the runs, over the sum of all weights
    Interval speed_factor{1.0, 1.0};     // times the manoeuvre's speed
    Interval steering_factor{1.0, 1.0};  // times its handwheel angle
    double duration_s{0.0};              // 0: its own
    Interval handwheel_rate_degps{};     // of its steering ramps, whatever the angle; 0: its own

    bool has_handwheel_rate() const {
        return handwheel_rate_degps.lowest != 0.0 || handwheel_rate_degps.highest != 0.0;
    }
};

// How far the drawn quantities spread; docs/drives.md says how they are distributed. Here: not at all.
struct CampaignSpread {
    Interval friction_factor{1.0, 1.0};     // of the tyres
    Interval load_share{};                  // of the sprung mass, added as a point load
    Interval load_height_factor{1.0, 1.0};  // height of the load over the height of the sprung CG
    // Base of the errors of mass and CG height: true values, load included, or those of the
    // calibration, so that what the load changes comes on top.
    bool load_is_known{true};
    double cg_height_error{0.0};  // share by which the calibration's value may be wrong, either way
    double stiffness_error{0.0};
    double mass_error{0.0};
    double accelerometer_bias_g{0.0};
    double housing_tilt_deg{0.0};           // of the inertial sensors, about each axis, either way
    double lever_arm_error_m{0.0};          // of their place, along each axis, either way
    Interval mass_signal_factor{1.0, 1.0};  // reported over true mass, where it is on the bus, beside noise
    bool sensor_noise{false};
    bool steering_sensor{true};   // false: the steering wheel angle is never available
    bool roll_sensor{true};       // false: neither is the roll angle
    bool attitude_sensor{false};  // true: the roll angle is one against the horizon
};

// An intervention in every run, while the firmware or an index warns.
struct CampaignIntervention {
    static constexpr const char* firmware = "warning";

    std::string index{firmware};  // that: the warning that the ECU sends; else one of campaign_indices()
    double level{1.0};            // threshold at which the index warns (IndexWarning), 0.001 to 100
    Intervention action{};

    bool by_firmware() const { return index == firmware; }
};

struct CampaignSettings {
    std::uint64_t runs{1U};
    std::uint64_t seed{1U};
    double learning_s{0.0};  // of ordinary driving from which every run knows the load of its vehicle
    std::vector<CampaignVehicle> vehicles{};
    std::vector<std::string> changes{};  // "KEY=VALUE" in place of what every calibration says
    std::vector<CampaignManoeuvre> manoeuvres{};
    CampaignSpread spread{};
    std::optional<CampaignIntervention> intervention{};  // none: warnings are without effect
};

// The settings that are built in, those of sil/studies/campaign/default.toml.
CampaignSettings default_campaign();

// Reads settings; what a file leaves out is as in default_campaign(). Throws InputError with file, line
// and key for anything that cannot be read, is unknown or out of range.
CampaignSettings load_campaign(const std::filesystem::path& path);

// Refuses what load_campaign would, in settings that have been put together otherwise. Throws InputError.
void check_campaign(const CampaignSettings& settings);

// One of the catalogue, or ordinary driving. Throws UnknownManoeuvre.
Manoeuvre campaign_manoeuvre(const std::string& name);

// "FILE:CALIBRATION". Throws InputError.
CampaignVehicle parse_campaign_vehicle(const std::string& text);

// As TOML that load_campaign reads back, one key a line, the same text for the same settings.
std::string to_toml(const CampaignSettings& settings);

}  // namespace sil
