// A vehicle's data sheet from any bytes: numbers that make a vehicle, or an error with the place.
#include <cmath>
#include <cstdint>
#include <string_view>

#include "sil/studies/identification/vehicle_data.hpp"
#include "tests/quality/fuzz/support/require.hpp"
#include "tests/quality/fuzz/support/toml_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::set_toml_text({reinterpret_cast<const char*>(data), size});
    try {
        const sil::VehicleData vehicle = sil::load_vehicle_data(fuzz::toml_path());
        for (const double positive :
             {vehicle.total_mass_kg, vehicle.sprung_mass_kg, vehicle.sprung_cg_height_m,
              vehicle.unsprung_cg_height_m, vehicle.track_width_m, vehicle.wheelbase_m}) {
            fuzz::require(positive > 0.0 && std::isfinite(positive),
                          "a vehicle has masses and lengths above zero");
        }
        fuzz::require(vehicle.unsprung_mass_kg >= 0.0, "no mass is negative");
        fuzz::require(std::fabs(vehicle.sprung_mass_kg + vehicle.unsprung_mass_kg - vehicle.total_mass_kg) <=
                          1.0e-9 * vehicle.total_mass_kg,
                      "the masses add up");
        for (const auto& optional : {vehicle.steering_ratio, vehicle.understeer_gradient_s2pm,
                                     vehicle.roll_centre_height_m, vehicle.roll_inertia_kgm2}) {
            fuzz::require(!optional || std::isfinite(*optional), "what is given is finite");
        }
    } catch (const sil::InputError& error) {
        // Which file, or, where a value came from elsewhere, which key.
        fuzz::require(
            std::string_view{error.what()}.substr(0U, fuzz::toml_path().size()) == fuzz::toml_path(),
            "an error names the file");
    }
    return 0;
}
