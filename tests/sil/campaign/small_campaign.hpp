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

// A run whose only index, with threshold 1, came as high as `peak`, and as high as `peak_100ms_before` up to
// 0.1 s before two-wheel lift-off.
struct HandMadeRun {
    std::optional<double> lift_time_s{};
    double largest_ltr{0.5};
    std::optional<double> warning_time_s{};
    double peak{0.0};
    double peak_100ms_before{0.0};
    std::optional<double> index_time_s{};
    std::string vehicle{"car"};
    std::string manoeuvre{"turn"};
};

sil::RecordedCampaignRun recorded(const HandMadeRun& run);

}  // namespace testing_campaign
