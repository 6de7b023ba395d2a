// Identification: from test drives and a data sheet to the parameters that the firmware needs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sil/studies/identification/load_fit.hpp"
#include "sil/studies/identification/prepared_drive.hpp"
#include "sil/studies/identification/response_fit.hpp"
#include "sil/studies/identification/roll_fit.hpp"
#include "sil/studies/identification/sensor_quality.hpp"
#include "sil/studies/identification/steering_fit.hpp"
#include "sil/studies/identification/tyre_limit.hpp"
#include "sil/studies/identification/vehicle_data.hpp"

namespace sil {

// One value of the calibration and where it comes from.
struct IdentifiedValue {
    std::string key;  // of rsi_parameters
    double value;     // of a selection its place among the choices
    std::string origin;
    std::optional<double> refused{};  // the better one, which a later correction would push out of its range
};

struct Identification {
    VehicleData vehicle;  // its CG height may have been matched to the wheel loads
    double given_cg_height_m{};
    std::string cg_height_origin;
    std::vector<PreparedDrive> ramps;
    std::vector<PreparedDrive> dynamics;
    RollFit roll;
    std::optional<LoadFit> loads;
    std::vector<DriveResidual> load_transfer;  // with the values of the calibration; drives with wheel loads
    std::optional<SteeringFit> steering;
    std::optional<ResponseFit> response;
    SensorQuality sensors;
    double roll_centre_height_m{};
    std::string roll_centre_origin;
    TyreLimit tyres;
    std::vector<IdentifiedValue> values;  // all that depend on the vehicle
    std::vector<std::string> warnings;    // notes to the user, in plain words

    // Demand of the steering: from the ramps, or because the vehicle data say ratio and gradient.
    bool steering_is_known() const;

    // The one of `values` with this key, which must be there.
    double value(std::string_view key) const;
};

struct IdentificationOptions {
    PreparationOptions preparation{};
    bool keep_cg_height{false};  // also where wheel loads speak for another
};

// Throws IdentificationError when a drive is of no use, and says what to do.
Identification identify(const VehicleData& vehicle, const std::vector<Drive>& ramps,
                        const std::vector<Drive>& dynamics, const IdentificationOptions& options = {});

}  // namespace sil
