// Tyre limit: the largest lateral acceleration that the tyres will give, as far as the ramps show it.
#pragma once

#include <string>
#include <vector>

#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/steering_fit.hpp"
#include "sil/studies/identification/vehicle_data.hpp"

namespace sil {

struct TyreLimit {
    double largest_mps2{};
    std::string origin;  // in words
};

// A ramp that a wheel's lift ended leaves open what the tyres would still have given; in one whose steering
// asked for far more than came, they gave all. Any other ramp says nothing: a dry road is assumed.
TyreLimit tyre_limit(const VehicleData& vehicle, const SteeringFit* steering,
                     const std::vector<PreparedDrive>& ramps, const std::vector<PreparedDrive>& dynamics);

}  // namespace sil
