#include "sil/studies/drives/drive_columns.hpp"

#include <algorithm>
#include <cctype>

#include "sil/units.hpp"

namespace sil {
namespace {

std::vector<DriveUnit> angle_units() {
    return {{"deg", 1.0 / degrees_per_radian}, {"rad", 1.0}};
}
std::vector<DriveUnit> rate_units() {
    return {{"degps", 1.0 / degrees_per_radian}, {"radps", 1.0}};
}
std::vector<DriveUnit> acceleration_units() {
    return {{"mps2", 1.0}, {"g", g_mps2}};
}
std::vector<DriveUnit> speed_units() {
    return {{"mps", 1.0}, {"kmh", 1.0 / 3.6}, {"mph", 0.44704}};
}
std::vector<DriveUnit> force_units() {
    return {{"n", 1.0}, {"kn", 1000.0}};
}

std::vector<DriveUnit> mass_units() {
    return {{"kg", 1.0}, {"t", 1000.0}};
}

bool starts_with(std::string_view text, std::string_view beginning) {
    return text.substr(0U, beginning.size()) == beginning;
}

std::string in_lower_case(std::string_view text) {
    std::string result{text};
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char character) { return static_cast<char>(std::tolower(character)); });
    return result;
}

// Text behind the quantity's name: nothing or a single word after '_' is meant as a unit, several words make
// another quantity ("roll_angle_to_horizon_deg"), and so does a letter ("timer").
DriveColumn::Kind kind_of_rest(std::string_view rest, const DriveQuantity& quantity, double& factor) {
    if (rest.empty()) {
        return DriveColumn::Kind::wrong_unit;
    }
    if (rest.front() != '_') {
        const bool is_letter = std::isalnum(static_cast<unsigned char>(rest.front())) != 0;
        return is_letter ? DriveColumn::Kind::unknown : DriveColumn::Kind::wrong_unit;
    }
    const std::string_view suffix = rest.substr(1U);
    for (const DriveUnit& unit : quantity.units) {
        if (suffix == unit.suffix) {
            factor = unit.factor;
            return DriveColumn::Kind::known;
        }
    }
    return suffix.find('_') == std::string_view::npos ? DriveColumn::Kind::wrong_unit
                                                      : DriveColumn::Kind::unknown;
}

}  // namespace

// clang-format off
const std::vector<DriveQuantity>& drive_quantities() {
    static const std::vector<DriveQuantity> quantities{
        {"time", "", DriveNeed::always, {{"s", 1.0}, {"ms", 1.0e-3}},
         [](DriveSample& sample) -> double& { return sample.time_s; }},
        {"lateral_acceleration", "sensor_", DriveNeed::always, acceleration_units(),
         [](DriveSample& sample) -> double& { return sample.lateral_acceleration_mps2; }},
        {"roll_rate", "sensor_", DriveNeed::always, rate_units(),
         [](DriveSample& sample) -> double& { return sample.roll_rate_radps; }},
        {"roll_angle", "sensor_", DriveNeed::roll_angle, angle_units(),
         [](DriveSample& sample) -> double& { return sample.roll_angle_rad; }},
        {"speed", "sensor_", DriveNeed::roll_observation, speed_units(),
         [](DriveSample& sample) -> double& { return sample.speed_mps; }},
        {"yaw_rate", "sensor_", DriveNeed::roll_observation, rate_units(),
         [](DriveSample& sample) -> double& { return sample.yaw_rate_radps; }},
        {"vertical_acceleration", "sensor_", DriveNeed::optional, acceleration_units(),
         [](DriveSample& sample) -> double& { return sample.vertical_acceleration_mps2; }},
        {"steering_wheel_angle", "sensor_", DriveNeed::optional, angle_units(),
         [](DriveSample& sample) -> double& { return sample.steering_wheel_angle_rad; }},
        {"bank_angle", "sensor_", DriveNeed::optional, angle_units(),
         [](DriveSample& sample) -> double& { return sample.bank_angle_rad; }},
        {"vehicle_mass", "sensor_", DriveNeed::optional, mass_units(),
         [](DriveSample& sample) -> double& { return sample.vehicle_mass_kg; }},
        {"wheel_load_front_left", "true_", DriveNeed::optional, force_units(),
         [](DriveSample& sample) -> double& { return sample.wheel_load_n[front_left]; }},
        {"wheel_load_front_right", "true_", DriveNeed::optional, force_units(),
         [](DriveSample& sample) -> double& { return sample.wheel_load_n[front_right]; }},
        {"wheel_load_rear_left", "true_", DriveNeed::optional, force_units(),
         [](DriveSample& sample) -> double& { return sample.wheel_load_n[rear_left]; }},
        {"wheel_load_rear_right", "true_", DriveNeed::optional, force_units(),
         [](DriveSample& sample) -> double& { return sample.wheel_load_n[rear_right]; }},
    };
    return quantities;
}
// clang-format on

DriveColumn read_column_name(std::string_view name) {
    const std::string lower_case = in_lower_case(name);
    for (const DriveQuantity& quantity : drive_quantities()) {
        std::string_view rest = lower_case;
        if (starts_with(rest, quantity.origin)) {
            rest.remove_prefix(std::string_view{quantity.origin}.size());
        }
        if (!starts_with(rest, quantity.name)) {
            continue;
        }
        rest.remove_prefix(std::string_view{quantity.name}.size());
        DriveColumn column;
        column.kind = kind_of_rest(rest, quantity, column.factor);
        if (column.kind != DriveColumn::Kind::unknown) {
            column.quantity = &quantity;
            return column;
        }
    }
    return {};
}

std::string admitted_names(const DriveQuantity& quantity) {
    std::string names;
    for (std::size_t index = 0U; index < quantity.units.size(); ++index) {
        if (index > 0U) {
            names += index + 1U < quantity.units.size() ? ", " : " or ";
        }
        names += std::string{quantity.name} + "_" + quantity.units[index].suffix;
    }
    return names;
}

}  // namespace sil
