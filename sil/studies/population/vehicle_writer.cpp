#include "sil/studies/population/vehicle_writer.hpp"

#include <fmt/format.h>

#include <utility>

#include "sil/files/toml_text.hpp"
#include "sil/world/vehicle/parameter_table.hpp"

namespace sil {
namespace {

class Toml {
 public:
    explicit Toml(std::string head) : text_{std::move(head)} {}

    Toml& table(std::string_view name) {
        text_ += fmt::format("\n[{}]\n", name);
        return *this;
    }
    Toml& number(std::string_view key, double value) {
        text_ += fmt::format("{} = {}\n", key, toml_number(value));
        return *this;
    }
    const std::string& text() const { return text_; }

 private:
    std::string text_;
};

}  // namespace

std::string vehicle_toml(const VehicleParameters& vehicle, std::string_view remark) {
    Toml toml{fmt::format("# {}\n\nname = {}\n", remark, toml_string(vehicle.name))};
    VehicleParameters copy = vehicle;  // the table's places are for writing too
    std::string_view table;
    for (const VehicleField& field : vehicle_fields) {
        if (table != field.table) {
            table = field.table;
            toml.table(table);
        }
        toml.number(field.key, field.of(copy));
    }
    return toml.text();
}

std::string vehicle_data_toml(const VehicleParameters& vehicle) {
    const GeometryParameters& geometry = vehicle.geometry;
    const double total = total_mass_kg(vehicle);
    Toml toml{fmt::format(
        "# What a data sheet and a workshop say of a drawn vehicle, for rsi-sil identify. SI units.\n\n"
        "name = {}\n",
        toml_string(vehicle.name))};
    toml.number("total_mass_kg", total)
        .number("unsprung_mass_kg", total - vehicle.mass.sprung_kg)
        .number("sprung_cg_height_m", geometry.cg_height_m)
        .number("wheel_radius_m", geometry.wheel_radius_m)
        .number("track_width_m", geometry.track_width_m)
        .number("wheelbase_m", wheelbase_m(geometry))
        .number("steering_ratio", vehicle.steering.ratio)
        .number("imu_x_m", vehicle.imu_mount.x_m)
        .number("imu_y_m", vehicle.imu_mount.y_m)
        .number("imu_z_m", vehicle.imu_mount.z_m);
    return toml.text();
}

}  // namespace sil
