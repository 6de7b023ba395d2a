// Campaign settings: checks, and their canonical text.
#include "sil/studies/campaign/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/files/toml_text.hpp"
#include "sil/studies/campaign/indices.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/mixed_driving.hpp"

namespace sil {
namespace {

void check(bool good, const std::string& key, const std::string& wanted) {
    if (!good) {
        throw InputError(fmt::format("\"{}\" must be {}", key, wanted));
    }
}

void check_within(const Interval& interval, double lowest, double highest, const std::string& key) {
    check(lowest <= interval.lowest && interval.lowest <= interval.highest && interval.highest <= highest,
          key, fmt::format("two numbers from {} to {}, the lower one first", lowest, highest));
}

void check_error(double share, const std::string& key) {
    check(share >= 0.0 && share <= 0.5, key, "a share from 0 to 0.5");
}

void check_manoeuvre(const CampaignManoeuvre& manoeuvre) {
    Manoeuvre known;
    try {
        known = campaign_manoeuvre(manoeuvre.name);
    } catch (const UnknownManoeuvre& unknown) {
        throw InputError(unknown.what());
    }
    const std::string where = "manoeuvre " + manoeuvre.name + ": ";
    check(manoeuvre.weight > 0.0 && manoeuvre.weight <= 1000.0, where + "weight", "above 0 and at most 1000");
    check_within(manoeuvre.speed_factor, 0.05, 5.0, where + "speed_factor");
    check_within(manoeuvre.steering_factor, 0.0, 10.0, where + "steering_factor");
    if (manoeuvre.has_handwheel_rate()) {
        check_within(manoeuvre.handwheel_rate_degps, 10.0, 2000.0, where + "handwheel_rate_degps");
        check(static_cast<bool>(known.make_driver_at_rate), where + "handwheel_rate_degps",
              "left out: its steering has no ramp of one rate");
    }
    check(manoeuvre.duration_s >= 0.0 && manoeuvre.duration_s <= 600.0, where + "duration_s",
          "seconds from 0 to 600 (0: the manoeuvre's own)");
}

void check_vehicle(const CampaignVehicle& vehicle, std::size_t manoeuvres) {
    const std::string where = "vehicle " + vehicle.parameters + ": ";
    check(vehicle.in_class.find_first_of(",\"\r\n") == std::string::npos, where + "class",
          "a text without comma, quotation mark and end of line");
    const auto check_factors = [&](const std::vector<double>& factors, const std::string& key) {
        const bool good = std::all_of(factors.begin(), factors.end(), [](double factor) {
            return factor >= vehicle_factor_range.lowest && factor <= vehicle_factor_range.highest;
        });
        check(good && (factors.empty() || factors.size() == manoeuvres), where + key,
              fmt::format("one number from {} to {} for each manoeuvre, in their order",
                          vehicle_factor_range.lowest, vehicle_factor_range.highest));
    };
    check_factors(vehicle.speed_factors, "speed_factors");
    check_factors(vehicle.steering_factors, "steering_factors");
}

void check_spread(const CampaignSpread& spread) {
    check_within(spread.friction_factor, 0.05, 3.0, "friction_factor");
    check_within(spread.load_share, 0.0, 1.0, "load_share");
    check_within(spread.load_height_factor, 0.0, 5.0, "load_height_factor");
    check_error(spread.cg_height_error, "cg_height_error");
    check_error(spread.stiffness_error, "stiffness_error");
    check_error(spread.mass_error, "mass_error");
    check(spread.accelerometer_bias_g >= 0.0 && spread.accelerometer_bias_g <= 1.0, "accelerometer_bias_g",
          "from 0 to 1");
    check(spread.housing_tilt_deg >= 0.0 && spread.housing_tilt_deg <= 20.0, "housing_tilt_deg",
          "from 0 to 20");
    check(spread.lever_arm_error_m >= 0.0 && spread.lever_arm_error_m <= 1.0, "lever_arm_error_m",
          "from 0 to 1");
    check_within(spread.mass_signal_factor, 0.5, 2.0, "mass_signal_factor");
}

void check_intervention(const CampaignIntervention& intervention) {
    std::string names = CampaignIntervention::firmware;
    for (const Index& index : campaign_indices()) {
        names += ", " + index.name;
    }
    const auto check_key = [](bool good, const std::string& key, const std::string& wanted) {
        check(good, "intervention." + key, wanted);
    };
    check_key(intervention.by_firmware() || index_place(intervention.index).has_value(), "index",
              "one of " + names);
    check_key(intervention.level >= 0.001 && intervention.level <= 100.0, "level", "from 0.001 to 100");
    const Intervention& action = intervention.action;
    check_key(action.delay_s >= 0.0 && action.delay_s <= 5.0, "delay_s", "seconds from 0 to 5");
    check_key(action.ramp_s >= 0.0 && action.ramp_s <= 5.0, "ramp_s", "seconds from 0 to 5");
    if (action.kind == InterventionKind::brake) {
        check_key(action.deceleration_mps2 >= 0.1 && action.deceleration_mps2 <= 12.0, "deceleration_mps2",
                  "from 0.1 to 12");
    } else {
        check_key(action.steer_back_share >= 0.0 && action.steer_back_share <= 1.0, "steer_back_share",
                  "a share from 0 to 1");
    }
}

std::string to_toml(const CampaignIntervention& intervention) {
    const Intervention& action = intervention.action;
    const bool brake = action.kind == InterventionKind::brake;
    const std::string level =
        intervention.by_firmware() ? "" : "level = " + toml_number(intervention.level) + "\n";
    return fmt::format("\n[intervention]\nindex = {}\n{}kind = \"{}\"\ndelay_s = {}\nramp_s = {}\n{} = {}\n",
                       toml_string(intervention.index), level, brake ? "brake" : "driver",
                       toml_number(action.delay_s), toml_number(action.ramp_s),
                       brake ? "deceleration_mps2" : "steer_back_share",
                       toml_number(brake ? action.deceleration_mps2 : action.steer_back_share));
}

std::string pair(const Interval& interval) {
    return fmt::format("[{}, {}]", toml_number(interval.lowest), toml_number(interval.highest));
}

std::string list(const std::string& key, const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers) {
        text += (text.empty() ? "" : ", ") + toml_number(number);
    }
    return numbers.empty() ? text : key + " = [" + text + "]\n";
}

}  // namespace

Manoeuvre campaign_manoeuvre(const std::string& name) {
    return name == ordinary_driving_name ? ordinary_driving(1U) : find_manoeuvre(name);
}

void check_campaign(const CampaignSettings& settings) {
    check(settings.runs >= 1U && settings.runs <= 100'000'000U, "runs", "from 1 to 100000000");
    check(settings.seed <= 0x7FFFFFFFFFFFFFFFU, "seed", "from 0 to 9223372036854775807");
    check(settings.learning_s >= 0.0 && settings.learning_s <= 600.0, "learning_s", "seconds from 0 to 600");
    // Each vehicle is driven once.
    check(settings.learning_s == 0.0 || settings.spread.load_share.highest == 0.0, "load_share",
          "[0, 0] where a learning drive is to show the load: give loaded vehicles");
    check(!settings.vehicles.empty(), "vehicle", "given at least once (--vehicle FILE:CALIBRATION)");
    check(!settings.manoeuvres.empty(), "manoeuvre", "given at least once");
    for (const CampaignManoeuvre& manoeuvre : settings.manoeuvres) {
        check_manoeuvre(manoeuvre);
    }
    for (const CampaignVehicle& vehicle : settings.vehicles) {
        check_vehicle(vehicle, settings.manoeuvres.size());
    }
    check_spread(settings.spread);
    if (settings.intervention) {
        check_intervention(*settings.intervention);
    }
}

CampaignVehicle parse_campaign_vehicle(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos || colon == 0U || colon + 1U == text.size()) {
        throw InputError(fmt::format(
            "--vehicle wants VEHICLE_FILE:CALIBRATION_FILE, two paths with a colon between, not {}", text));
    }
    CampaignVehicle vehicle;
    vehicle.parameters = text.substr(0U, colon);
    vehicle.calibration = text.substr(colon + 1U);
    return vehicle;
}

std::string to_toml(const CampaignSettings& settings) {
    const CampaignSpread& spread = settings.spread;
    std::string text = fmt::format("runs = {}\nseed = {}\n", settings.runs, settings.seed);
    text += settings.learning_s > 0.0 ? "learning_s = " + toml_number(settings.learning_s) + "\n" : "";
    std::string changes;
    for (const std::string& change : settings.changes) {
        changes += (changes.empty() ? "" : ", ") + toml_string(change);
    }
    text += changes.empty() ? "" : "changes = [" + changes + "]\n";
    text += "\n[spread]\n";
    text += "friction_factor = " + pair(spread.friction_factor) + "\n";
    text += "load_share = " + pair(spread.load_share) + "\n";
    text += "load_height_factor = " + pair(spread.load_height_factor) + "\n";
    // Like all that is left out below: only where it says something.
    text += spread.load_is_known ? "" : "load_is_known = false\n";
    text += "cg_height_error = " + toml_number(spread.cg_height_error) + "\n";
    text += "stiffness_error = " + toml_number(spread.stiffness_error) + "\n";
    text += "mass_error = " + toml_number(spread.mass_error) + "\n";
    text += "accelerometer_bias_g = " + toml_number(spread.accelerometer_bias_g) + "\n";
    text += spread.housing_tilt_deg > 0.0
                ? "housing_tilt_deg = " + toml_number(spread.housing_tilt_deg) + "\n"
                : "";
    text += spread.lever_arm_error_m > 0.0
                ? "lever_arm_error_m = " + toml_number(spread.lever_arm_error_m) + "\n"
                : "";
    text += is_one(spread.mass_signal_factor)
                ? ""
                : "mass_signal_factor = " + pair(spread.mass_signal_factor) + "\n";
    text += fmt::format("sensor_noise = {}\n", spread.sensor_noise);
    text += fmt::format("steering_sensor = {}\n", spread.steering_sensor);
    text += fmt::format("roll_sensor = {}\n", spread.roll_sensor);
    text += spread.attitude_sensor ? "attitude_sensor = true\n" : "";
    text += settings.intervention ? to_toml(*settings.intervention) : "";
    for (const CampaignVehicle& vehicle : settings.vehicles) {
        text += fmt::format("\n[[vehicle]]\nparameters = {}\ncalibration = {}\n",
                            toml_string(vehicle.parameters), toml_string(vehicle.calibration));
        text += vehicle.in_class.empty() ? "" : "class = " + toml_string(vehicle.in_class) + "\n";
        text += vehicle.mass_sensor ? "mass_sensor = true\n" : "";
        text +=
            list("speed_factors", vehicle.speed_factors) + list("steering_factors", vehicle.steering_factors);
    }
    for (const CampaignManoeuvre& manoeuvre : settings.manoeuvres) {
        text +=
            fmt::format("\n[[manoeuvre]]\nname = {}\nweight = {}\nspeed_factor = {}\nsteering_factor = {}\n",
                        toml_string(manoeuvre.name), toml_number(manoeuvre.weight),
                        pair(manoeuvre.speed_factor), pair(manoeuvre.steering_factor));
        text += manoeuvre.has_handwheel_rate()
                    ? "handwheel_rate_degps = " + pair(manoeuvre.handwheel_rate_degps) + "\n"
                    : "";
        text += "duration_s = " + toml_number(manoeuvre.duration_s) + "\n";
    }
    return text;
}

}  // namespace sil
