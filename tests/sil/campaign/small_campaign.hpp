// Small campaign: settings that a test can afford, and rows made by hand.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sil/studies/campaign/row_table.hpp"
#include "sil/studies/campaign/settings.hpp"

namespace testing_campaign {

// The path of a file of the project.
std::string project_file(const std::string& path);

// Both vehicles; hard and soft J-turns of three seconds.
sil::CampaignSettings small_campaign(std::uint64_t runs);

// A run whose only index warns with these thresholds and below (sil/judge/index_score.hpp).
struct HandMadeRun {
    std::optional<double> lift_time_s{};
    double largest_ltr{0.5};
    std::optional<double> lead_s{};  // of the firmware's warning
    unsigned warnings{0U};
    double threshold{0.0};
    double threshold_100ms{0.0};
    double threshold_200ms{0.0};
    std::optional<double> index_lead_s{};
    std::string vehicle{"car"};
    std::string manoeuvre{"turn"};
};

sil::RecordedCampaignRun recorded(const HandMadeRun& run);

}  // namespace testing_campaign
