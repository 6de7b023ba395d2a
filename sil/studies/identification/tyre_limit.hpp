// Tyre limit: the largest lateral acceleration that the tyres will give, as far as the ramps show it.
#pragma once

#include <string>
#include <vector>

#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/vehicle_data.hpp"

namespace sil {

struct TyreLimit {
    double largest_mps2{};
    bool is_shown{false};  // by a ramp; otherwise it is left open, far beyond what was seen
    std::string origin;    // in words
};

// Only a ramp whose lateral force stopped growing while the steering grew on, by itself and times the speed
// squared, shows what the tyres give: in an understeering vehicle a rising speed asks for more than it gives,
// and one that is lost hides what the steering asked for. One
// that its driver, or a wheel's lift, ended before says nothing, however much more its steering asked for
// than came: tyres that understeer more and more do that as well. Then the limit stays open, beyond what was
// seen and beyond what lifts the wheels, or no lift-off could be foretold; likewise if no ramp has steering,
// yaw rate and speed. `ramps` must not be empty.
TyreLimit tyre_limit(const VehicleData& vehicle, const std::vector<PreparedDrive>& ramps,
                     const std::vector<PreparedDrive>& dynamics);

}  // namespace sil
