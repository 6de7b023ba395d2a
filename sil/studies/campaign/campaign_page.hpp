// Campaign page: the report of a campaign as a page to look into.
#pragma once

#include <filesystem>
#include <string>

#include "sil/studies/campaign/report.hpp"

namespace sil {

// Paths in the commands that drive a run again: they work from any folder of this machine.
struct CampaignCall {
    std::filesystem::path program;         // absolute, or one that the shell finds
    std::filesystem::path working_folder;  // absolute: relative paths in the settings start from it
    std::filesystem::path output;  // the campaign's folder; a relative path starts from working_folder
};

// report.html.
std::string campaign_page(const CampaignReport& report, const RowTable& table, const CampaignCall& call);

}  // namespace sil
