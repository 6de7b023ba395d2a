#include "sil/world/vehicle/parameter_file.hpp"

#include <optional>
#include <string>

#include "sil/files/toml_table.hpp"
#include "sil/world/vehicle/parameter_table.hpp"

namespace sil {

VehicleParameters load_vehicle(const std::filesystem::path& path) {
    TomlTable top = TomlTable::load(path);
    VehicleParameters vehicle;
    vehicle.name = top.text("name");
    std::optional<TomlTable> table;
    std::string name;
    for (const VehicleField& field : vehicle_fields) {
        if (field.table != name) {
            if (table) {
                table->refuse_unknown_keys();
            }
            name = field.table;
            table = top.table(name);
        }
        if (!field.may_be_left_out || table->has(field.key)) {
            field.of(vehicle) = table->number(field.key, {field.lowest, field.highest});
        }
    }
    table->refuse_unknown_keys();
    top.refuse_unknown_keys();
    return vehicle;
}

}  // namespace sil
