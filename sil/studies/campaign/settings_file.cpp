// Campaign settings from TOML: a file's own, and the built-in ones.
#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "default_campaign.hpp"
#include "sil/files/toml_table.hpp"
#include "sil/studies/campaign/settings.hpp"

namespace sil {
namespace {

// Values that the file does not give stay as they are.
void read(TomlTable& table, std::string_view key, double& value) {
    value = table.has(key) ? table.number(key) : value;
}

void read(TomlTable& table, std::string_view key, std::uint64_t& value) {
    value = table.has(key) ? table.whole_number(key) : value;
}

void read(TomlTable& table, std::string_view key, bool& value) {
    value = table.has(key) ? table.boolean(key) : value;
}

void read(TomlTable& table, std::string_view key, Interval& value) {
    if (table.has(key)) {
        const std::vector<double> ends = table.numbers(key);
        if (ends.size() != 2U) {
            table.fail(key, "must be two numbers, [lowest, highest]");
        }
        value = {ends[0], ends[1]};
    }
}

void read(TomlTable& table, std::string_view key, std::vector<double>& value) {
    value = table.has(key) ? table.numbers(key) : value;
}

CampaignManoeuvre read_manoeuvre(TomlTable table) {
    CampaignManoeuvre manoeuvre;
    manoeuvre.name = table.text("name");
    read(table, "weight", manoeuvre.weight);
    read(table, "speed_factor", manoeuvre.speed_factor);
    read(table, "steering_factor", manoeuvre.steering_factor);
    read(table, "handwheel_rate_degps", manoeuvre.handwheel_rate_degps);
    read(table, "duration_s", manoeuvre.duration_s);
    table.refuse_unknown_keys();
    return manoeuvre;
}

// A population's settings name the files beside them, wherever its folder lies; those of the project name
// files from its root, where commands are given.
std::string found_from(const std::filesystem::path& folder, const std::string& path) {
    const bool beside = path.rfind("./", 0U) == 0U || path.rfind("../", 0U) == 0U;
    return beside ? (folder / path).lexically_normal().string() : path;
}

CampaignVehicle read_vehicle(TomlTable table, const std::filesystem::path& folder) {
    CampaignVehicle vehicle{found_from(folder, table.text("parameters")),
                            found_from(folder, table.text("calibration"))};
    vehicle.in_class = table.has("class") ? table.text("class") : std::string{};
    read(table, "mass_sensor", vehicle.mass_sensor);
    read(table, "speed_factors", vehicle.speed_factors);
    read(table, "steering_factors", vehicle.steering_factors);
    table.refuse_unknown_keys();
    return vehicle;
}

void read_spread(TomlTable table, CampaignSpread& spread) {
    read(table, "friction_factor", spread.friction_factor);
    read(table, "load_share", spread.load_share);
    read(table, "load_height_factor", spread.load_height_factor);
    read(table, "load_is_known", spread.load_is_known);
    read(table, "cg_height_error", spread.cg_height_error);
    read(table, "stiffness_error", spread.stiffness_error);
    read(table, "mass_error", spread.mass_error);
    read(table, "accelerometer_bias_g", spread.accelerometer_bias_g);
    read(table, "housing_tilt_deg", spread.housing_tilt_deg);
    read(table, "lever_arm_error_m", spread.lever_arm_error_m);
    read(table, "mass_signal_factor", spread.mass_signal_factor);
    read(table, "sensor_noise", spread.sensor_noise);
    read(table, "steering_sensor", spread.steering_sensor);
    read(table, "roll_sensor", spread.roll_sensor);
    read(table, "attitude_sensor", spread.attitude_sensor);
    table.refuse_unknown_keys();
}

// All of it is to be said: there is no usual reaction to a warning.
CampaignIntervention read_intervention(TomlTable table) {
    CampaignIntervention intervention;
    intervention.index = table.text("index");
    if (!intervention.by_firmware()) {
        intervention.level = table.number("level");
    }
    intervention.action.delay_s = table.number("delay_s");
    intervention.action.ramp_s = table.number("ramp_s");
    if (table.choice("kind", {"brake", "driver"}) == 0U) {
        intervention.action.deceleration_mps2 = table.number("deceleration_mps2");
    } else {
        intervention.action.kind = InterventionKind::driver;
        intervention.action.steer_back_share = table.number("steer_back_share");
    }
    table.refuse_unknown_keys();
    return intervention;
}

// Puts what the file says over `settings`.
CampaignSettings read_settings(TomlTable top, CampaignSettings settings) {
    top.allow("made_with");
    read(top, "runs", settings.runs);
    read(top, "seed", settings.seed);
    read(top, "learning_s", settings.learning_s);
    settings.changes = top.has("changes") ? top.texts("changes") : settings.changes;
    if (top.has("spread")) {
        read_spread(top.table("spread"), settings.spread);
    }
    if (top.has("intervention")) {
        settings.intervention = read_intervention(top.table("intervention"));
    }
    if (top.has("vehicle")) {
        settings.vehicles.clear();
        for (const TomlTable& table : top.tables("vehicle")) {
            settings.vehicles.push_back(read_vehicle(table, std::filesystem::path{top.file()}.parent_path()));
        }
    }
    if (top.has("manoeuvre")) {
        settings.manoeuvres.clear();
        for (const TomlTable& table : top.tables("manoeuvre")) {
            settings.manoeuvres.push_back(read_manoeuvre(table));
        }
    }
    top.refuse_unknown_keys();
    try {
        check_campaign(settings);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", top.file(), error.what()));
    }
    return settings;
}

}  // namespace

CampaignSettings default_campaign() {
    return read_settings(TomlTable::parse(default_campaign_text, "built-in settings"), {});
}

CampaignSettings load_campaign(const std::filesystem::path& path) {
    static const CampaignSettings defaults = default_campaign();
    const TomlTable top = TomlTable::load(path);
    if (top.is_empty()) {
        throw InputError(fmt::format(
            "{}:1: there is nothing in it; was the copy finished? Without --settings those built in are used",
            path.string()));
    }
    return read_settings(top, defaults);
}

}  // namespace sil
