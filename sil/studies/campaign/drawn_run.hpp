// Drawn run: the true vehicle of one run, the firmware's calibration, and the drive.
#pragma once

#include "rsi/types.hpp"
#include "sil/studies/campaign/draw.hpp"
#include "sil/studies/campaign/settings.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct DrawnRun {
    RunDraw draw{};
    VehicleParameters vehicle{};    // the truth, with load
    rsi::Parameters calibration{};  // the firmware's, with errors
    Manoeuvre manoeuvre{};
    RunOptions options{};
    SensorOptions sensors{};
};

// From the vehicle as built, the calibration made for it, and the manoeuvre of the catalogue.
DrawnRun drawn_run(const CampaignSettings& settings, const RunDraw& draw, const VehicleParameters& vehicle,
                   const rsi::Parameters& calibration, const Manoeuvre& manoeuvre);

// The sensors that the settings give the drawn vehicle, with the draw's noise and errors.
SensorOptions drawn_sensors(const CampaignSettings& settings, const RunDraw& draw,
                            const VehicleParameters& vehicle);

}  // namespace sil
