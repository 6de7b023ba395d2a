// Population campaigns: which runs a half of the population is judged by, as settings of `rsi-sil campaign`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sil/studies/campaign/settings.hpp"
#include "sil/studies/population/vehicle_draw.hpp"

namespace sil {

// Knowledge of the firmware in a campaign.
enum class CampaignVariant {
    clean,   // calibrated with wheel loads, no errors
    errors,  // the same with noise, CG height and roll stiffness wrong
    learnt,  // with those errors, after two minutes of ordinary driving with the load of the calibration
    without_wheel_loads,  // calibrated without, and those errors
    loaded,    // noise; calibrated empty, driven with the class's load, of which two minutes of driving tell
    unloaded,  // noise; calibrated with that load, driven without, the same
    wrongly_mounted,  // noise and errors, and the inertial sensors' housing turned and out of place
    wrong_mass,       // noise and errors, and the mass on the bus wrong or a trailer's too; learnt as a load
    tripping,         // noise and errors, slides against kerbs and into soft ground
    ordinary,         // noise and errors, ordinary driving by the hour
};

const std::vector<CampaignVariant>& campaign_variants();
const char* variant_name(CampaignVariant variant);

// Folders of a population, below its own.
std::filesystem::path vehicle_file(const std::filesystem::path& population, const DrawnVehicle& vehicle,
                                   bool loaded);
std::filesystem::path data_file(const std::filesystem::path& population, const DrawnVehicle& vehicle,
                                bool loaded);
enum class CalibrationKind { with_loads, without_loads, of_loaded_vehicle };
std::filesystem::path calibration_file(const std::filesystem::path& population, const DrawnVehicle& vehicle,
                                       CalibrationKind kind);

// Settings with those of `vehicles` whose calibration is there; 100 runs a vehicle, of ordinary driving half
// an hour. Paths are as a settings file in the folder `population` has them.
CampaignSettings population_campaign(const std::filesystem::path& population,
                                     const std::vector<DrawnVehicle>& vehicles, CampaignVariant variant,
                                     std::uint64_t seed);

// Manoeuvres of a campaign, made for a vehicle that lifts its inner wheels at `reference_threshold_g`.
enum class ManoeuvreMixture {
    driving,   // of all but the two below
    tripping,  // by a kerb and by soft ground
};
const std::vector<CampaignManoeuvre>& population_manoeuvres(
    ManoeuvreMixture mixture = ManoeuvreMixture::driving);

// The vehicle with its class and with factors that make each manoeuvre of the mixture as severe for it as it
// is for any other, at speeds that its class reaches.
CampaignVehicle scaled_vehicle(const DrawnVehicle& vehicle, const VehicleParameters& driven,
                               ManoeuvreMixture mixture = ManoeuvreMixture::driving);

}  // namespace sil
