// A simulated vehicle from any bytes: parameters that are all finite, or an error with the place.
#include <cmath>
#include <cstdint>

#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/quality/fuzz/support/message.hpp"
#include "tests/quality/fuzz/support/require.hpp"
#include "tests/quality/fuzz/support/toml_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::set_toml_text({reinterpret_cast<const char*>(data), size});
    try {
        const sil::VehicleParameters vehicle = sil::load_vehicle(fuzz::toml_path());
        for (const double positive :
             {vehicle.mass.sprung_kg, vehicle.mass.front_unsprung_kg, vehicle.mass.rear_axle_kg,
              vehicle.inertia.sprung_roll_kgm2, vehicle.inertia.wheel_spin_kgm2,
              vehicle.geometry.track_width_m, vehicle.geometry.cg_height_m, vehicle.geometry.wheel_radius_m,
              vehicle.front_suspension.spring_damper.spring_npm,
              vehicle.rear_suspension.spring_damper.spring_npm, vehicle.tyre.vertical_stiffness_npm,
              vehicle.tyre.friction, vehicle.steering.ratio}) {
            fuzz::require(positive > 0.0 && std::isfinite(positive),
                          "what a vehicle divides by is above zero");
        }
    } catch (const sil::InputError& error) {
        fuzz::require_place(error.what(), fuzz::toml_path());
    }
    return 0;
}
