#include "tests/sil/campaign/small_campaign.hpp"

namespace testing_campaign {

std::string project_file(const std::string& path) {
    return std::string{RSI_SOURCE_DIR} + "/" + path;
}

sil::CampaignSettings small_campaign(std::uint64_t runs) {
    sil::CampaignSettings settings = sil::default_campaign();
    settings.runs = runs;
    settings.seed = 7U;
    for (sil::CampaignVehicle& vehicle : settings.vehicles) {
        vehicle = {project_file(vehicle.parameters), project_file(vehicle.calibration)};
    }
    settings.manoeuvres = {{"j-turn-110", 2.0, {0.8, 1.1}, {0.8, 1.2}, 3.0},
                           {"j-turn-45", 1.0, {0.7, 1.3}, {0.2, 1.0}, 3.0}};
    return settings;
}

sil::RecordedCampaignRun recorded(const HandMadeRun& run) {
    sil::RecordedCampaignRun result;
    result.vehicle = run.vehicle;
    result.manoeuvre = run.manoeuvre;
    result.two_wheel_lift_time_s = run.lift_time_s;
    result.largest_ltr = run.lift_time_s ? 1.0 : run.largest_ltr;
    result.lead_s = run.lead_s;
    result.warnings = run.warnings;
    result.indices = {{run.threshold, run.threshold_100ms, run.threshold_200ms, run.index_lead_s}};
    return result;
}

}  // namespace testing_campaign
