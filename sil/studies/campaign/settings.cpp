// Campaign settings: checks, and their canonical text.
#include "sil/studies/campaign/settings.hpp"

#include <fmt/format.h>

#include <cmath>

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
    try {
        campaign_manoeuvre(manoeuvre.name);
    } catch (const UnknownManoeuvre& unknown) {
        throw InputError(unknown.what());
    }
    const std::string where = "manoeuvre " + manoeuvre.name + ": ";
    check(manoeuvre.weight > 0.0 && manoeuvre.weight <= 1000.0, where + "weight", "above 0 and at most 1000");
    check_within(manoeuvre.speed_factor, 0.05, 5.0, where + "speed_factor");
    check_within(manoeuvre.steering_factor, 0.0, 10.0, where + "steering_factor");
    check(manoeuvre.duration_s >= 0.0 && manoeuvre.duration_s <= 600.0, where + "duration_s",
          "seconds from 0 to 600 (0: the manoeuvre's own)");
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
}

// A TOML string; a path may hold a backslash, a quotation mark, even a line feed.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            result += '\\';
            result += letter;
        } else if (code < 0x20U || code == 0x7FU) {
            result += fmt::format("\\u{:04X}", code);
        } else {
            result += letter;
        }
    }
    return result + "\"";
}

// As TOML wants a float: never without a point or an exponent.
std::string number_text(double value) {
    const std::string text = fmt::format("{}", value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string pair(const Interval& interval) {
    return fmt::format("[{}, {}]", number_text(interval.lowest), number_text(interval.highest));
}

}  // namespace

Manoeuvre campaign_manoeuvre(const std::string& name) {
    return name == ordinary_driving_name ? ordinary_driving(1U) : find_manoeuvre(name);
}

void check_campaign(const CampaignSettings& settings) {
    check(settings.runs >= 1U && settings.runs <= 100'000'000U, "runs", "from 1 to 100000000");
    check(settings.seed <= 0x7FFFFFFFFFFFFFFFU, "seed", "from 0 to 9223372036854775807");
    check(!settings.vehicles.empty(), "vehicle", "given at least once (--vehicle FILE:CALIBRATION)");
    check(!settings.manoeuvres.empty(), "manoeuvre", "given at least once");
    for (const CampaignManoeuvre& manoeuvre : settings.manoeuvres) {
        check_manoeuvre(manoeuvre);
    }
    check_spread(settings.spread);
}

CampaignVehicle parse_campaign_vehicle(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos || colon == 0U || colon + 1U == text.size()) {
        throw InputError(fmt::format(
            "--vehicle wants VEHICLE_FILE:CALIBRATION_FILE, two paths with a colon between, not {}", text));
    }
    return {text.substr(0U, colon), text.substr(colon + 1U)};
}

std::string to_toml(const CampaignSettings& settings) {
    const CampaignSpread& spread = settings.spread;
    std::string text = fmt::format("runs = {}\nseed = {}\n\n[spread]\n", settings.runs, settings.seed);
    text += "friction_factor = " + pair(spread.friction_factor) + "\n";
    text += "load_share = " + pair(spread.load_share) + "\n";
    text += "load_height_factor = " + pair(spread.load_height_factor) + "\n";
    text += "cg_height_error = " + number_text(spread.cg_height_error) + "\n";
    text += "stiffness_error = " + number_text(spread.stiffness_error) + "\n";
    text += "mass_error = " + number_text(spread.mass_error) + "\n";
    text += "accelerometer_bias_g = " + number_text(spread.accelerometer_bias_g) + "\n";
    text += fmt::format("sensor_noise = {}\n", spread.sensor_noise);
    text += fmt::format("steering_sensor = {}\n", spread.steering_sensor);
    text += fmt::format("roll_sensor = {}\n", spread.roll_sensor);
    for (const CampaignVehicle& vehicle : settings.vehicles) {
        text += fmt::format("\n[[vehicle]]\nparameters = {}\ncalibration = {}\n", quoted(vehicle.parameters),
                            quoted(vehicle.calibration));
    }
    for (const CampaignManoeuvre& manoeuvre : settings.manoeuvres) {
        text +=
            fmt::format("\n[[manoeuvre]]\nname = {}\nweight = {}\nspeed_factor = {}\nsteering_factor = {}\n",
                        quoted(manoeuvre.name), number_text(manoeuvre.weight), pair(manoeuvre.speed_factor),
                        pair(manoeuvre.steering_factor));
        text += "duration_s = " + number_text(manoeuvre.duration_s) + "\n";
    }
    return text;
}

}  // namespace sil
