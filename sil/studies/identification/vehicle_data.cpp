#include "sil/studies/identification/vehicle_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "rsi/parameters.hpp"
#include "sil/files/toml_table.hpp"

namespace sil {
namespace {

// Rules of thumb for what a data sheet rarely says; docs/calibration.md names them.
constexpr double usual_unsprung_share = 0.13;
constexpr double usual_wheel_radius_m = 0.36;

struct Key {
    std::string_view name;
    double lowest;
    double highest;
    std::string_view meaning;
};

constexpr std::array<Key, 18> keys{{
    {"total_mass_kg", 150.0, 60000.0, "mass as driven in the tests"},
    {"sprung_mass_kg", 100.0, 60000.0, "total mass less axles, wheels and brakes"},
    {"unsprung_mass_kg", 0.0, 20000.0, "axles, wheels and brakes"},
    {"cg_height_m", 0.2, 4.0, "height of the whole vehicle's centre of gravity above the road"},
    {"sprung_cg_height_m", 0.2, 4.0, "height of the sprung mass's centre of gravity above the road"},
    {"unsprung_cg_height_m", 0.05, 2.0, "height of the axles' centre of gravity above the road"},
    {"wheel_radius_m", 0.1, 1.5, "loaded radius of the wheels"},
    {"track_width_m", 0.8, 3.0, "between the middles of the tyres, mean of both axles"},
    {"track_width_front_m", 0.8, 3.0, "the same of the front axle"},
    {"track_width_rear_m", 0.8, 3.0, "the same of the rear axle"},
    {"wheelbase_m", 1.0, 15.0, "distance of the axles"},
    {"steering_ratio", 1.0, 60.0, "angle of the steering wheel over that of the front wheels"},
    {"understeer_gradient_s2pm", -0.01, 0.1, "K_us in V^2 delta / (L + K_us V^2)"},
    {"roll_centre_height_m", -0.5, 2.0, "height of the suspension's roll centre at the CG"},
    {"roll_inertia_kgm2", 10.0, 1.0e5, "of the sprung mass about its centre of gravity"},
    {"imu_x_m", -10.0, 10.0, "the IMU forward of the sprung mass's centre of gravity"},
    {"imu_y_m", -2.0, 2.0, "the IMU left of it"},
    {"imu_z_m", -3.0, 3.0, "the IMU above it; negative when below"},
}};

constexpr std::string_view reference_key = "roll_angle_reference";

const Key& key_of(std::string_view name) {
    return *std::find_if(keys.begin(), keys.end(), [name](const Key& key) { return key.name == name; });
}

TomlTable known_table(const std::filesystem::path& file) {
    TomlTable table = file.empty() ? TomlTable::parse("", "vehicle data")
                                   : TomlTable::load(file, "name one such as docs/calibration.md shows");
    table.allow("name");
    table.allow(reference_key);
    for (const Key& key : keys) {
        table.allow(key.name);
    }
    return table;
}

// The values of file and settings under their names, checked one by one.
class Values {
 public:
    Values(const std::filesystem::path& file, const std::vector<std::string>& settings)
        : table_{known_table(file)} {
        for (const std::string& setting : settings) {
            table_.change(setting, "track_width_m=1.6");
        }
        table_.refuse_unknown_keys();
    }

    std::string name() { return table_.has("name") ? table_.text("name") : "vehicle"; }

    bool has(std::string_view name) { return table_.has(name); }

    std::optional<double> optional(std::string_view name) {
        return has(name) ? std::optional<double>{number(name)} : std::nullopt;
    }

    double number(std::string_view name) {
        const Key& key = key_of(name);
        if (!has(name)) {
            fail(name, fmt::format("is missing: {}; add it to the file, or give --set {}=VALUE", key.meaning,
                                   name));
        }
        return table_.number(name, {key.lowest, key.highest}, key.meaning);
    }

    std::optional<RollReference> roll_angle_reference() {
        if (!has(reference_key)) {
            return std::nullopt;
        }
        const auto& choices = rsi::roll_angle_reference_choices;
        const std::size_t chosen = table_.choice(reference_key, {choices.begin(), choices.end()});
        return chosen == RSI_ROLL_AGAINST_HORIZON ? RollReference::horizon : RollReference::road;
    }

    [[noreturn]] void fail(std::string_view name, const std::string& what) const { table_.fail(name, what); }

    const std::string& source() const { return table_.file(); }

 private:
    TomlTable table_;
};

void read_masses(Values& values, VehicleData& data) {
    data.total_mass_kg = values.number("total_mass_kg");
    const auto sprung = values.optional("sprung_mass_kg");
    const auto unsprung = values.optional("unsprung_mass_kg");
    if (sprung) {
        data.unsprung_mass_kg = data.total_mass_kg - *sprung;
    } else if (unsprung) {
        data.unsprung_mass_kg = *unsprung;
    } else {
        data.unsprung_mass_kg = usual_unsprung_share * data.total_mass_kg;
        data.assumptions.push_back(
            fmt::format("neither sprung nor unsprung mass is given: unsprung mass taken as {:.0f} % of the "
                        "total, {:.0f} kg",
                        100.0 * usual_unsprung_share, data.unsprung_mass_kg));
    }
    data.sprung_mass_kg = data.total_mass_kg - data.unsprung_mass_kg;
    if (sprung && unsprung &&
        std::abs(*sprung + *unsprung - data.total_mass_kg) > 0.01 * data.total_mass_kg) {
        values.fail("sprung_mass_kg",
                    fmt::format("and unsprung_mass_kg make {:.0f} kg together, total_mass_kg is {:.0f} kg. "
                                "Correct one of the three, or leave one of the first two out",
                                *sprung + *unsprung, data.total_mass_kg));
    }
    if (data.unsprung_mass_kg < 0.0 || data.unsprung_mass_kg > 0.5 * data.total_mass_kg) {
        values.fail(
            sprung ? "sprung_mass_kg" : "unsprung_mass_kg",
            fmt::format("leaves {:.0f} kg for axles and wheels of a vehicle of {:.0f} kg; 5 to 30 % are "
                        "usual. Correct the masses",
                        data.unsprung_mass_kg, data.total_mass_kg));
    }
}

void read_heights(Values& values, VehicleData& data) {
    if (const auto height = values.optional("unsprung_cg_height_m")) {
        data.unsprung_cg_height_m = *height;
    } else if (const auto radius = values.optional("wheel_radius_m")) {
        data.unsprung_cg_height_m = *radius;
    } else {
        data.unsprung_cg_height_m = usual_wheel_radius_m;
        data.assumptions.push_back(fmt::format(
            "neither wheel_radius_m nor unsprung_cg_height_m is given: {} m taken", usual_wheel_radius_m));
    }
    if (const auto height = values.optional("sprung_cg_height_m")) {
        data.sprung_cg_height_m = *height;
    } else {
        // m h_total = m_s h + m_u h_u
        data.sprung_cg_height_m = (data.total_mass_kg * values.number("cg_height_m") -
                                   data.unsprung_mass_kg * data.unsprung_cg_height_m) /
                                  data.sprung_mass_kg;
    }
    const double ratio = static_stability_factor(data);
    if (ratio < 0.25 || ratio > 3.0) {
        throw InputError(
            fmt::format("{}: half the track width over the centre of gravity's height is {:.2f}; vehicles "
                        "have 0.4 to 1.7. Check cg_height_m and track_width_m (in metres)",
                        values.source(), ratio));
    }
}

void read_track(Values& values, VehicleData& data) {
    if (!values.has("track_width_m") && values.has("track_width_front_m") &&
        values.has("track_width_rear_m")) {
        data.track_width_m =
            0.5 * (values.number("track_width_front_m") + values.number("track_width_rear_m"));
    } else {
        data.track_width_m = values.number("track_width_m");
    }
}

void read_imu(Values& values, VehicleData& data) {
    data.imu_x_m = values.optional("imu_x_m").value_or(0.0);
    data.imu_y_m = values.optional("imu_y_m").value_or(0.0);
    data.imu_z_m = values.optional("imu_z_m").value_or(0.0);
    if (!values.has("imu_z_m")) {
        data.assumptions.push_back(
            "imu_z_m is not given: the IMU is taken to sit at the height of the sprung mass's centre of "
            "gravity");
    }
}

}  // namespace

VehicleData load_vehicle_data(const std::filesystem::path& file, const std::vector<std::string>& settings) {
    Values values{file, settings};
    VehicleData data;
    data.name = values.name();
    read_masses(values, data);
    read_track(values, data);
    read_heights(values, data);
    read_imu(values, data);
    data.wheelbase_m = values.number("wheelbase_m");
    data.steering_ratio = values.optional("steering_ratio");
    data.understeer_gradient_s2pm = values.optional("understeer_gradient_s2pm");
    data.roll_centre_height_m = values.optional("roll_centre_height_m");
    data.roll_inertia_kgm2 = values.optional("roll_inertia_kgm2");
    data.roll_angle_reference = values.roll_angle_reference();
    if (data.roll_centre_height_m && *data.roll_centre_height_m > 0.9 * data.sprung_cg_height_m) {
        values.fail("roll_centre_height_m",
                    "lies not below the sprung mass's centre of gravity. Correct it, or leave it out");
    }
    return data;
}

}  // namespace sil
