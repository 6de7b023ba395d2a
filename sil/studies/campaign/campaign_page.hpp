// Campaign page: the report of a campaign as a page to look into.
#pragma once

#include <filesystem>
#include <string>

#include "sil/studies/campaign/report.hpp"

namespace sil {

// report.html. `folder` is the campaign's, as the commands that drive a run again name it.
std::string campaign_page(const CampaignReport& report, const RowTable& table,
                          const std::filesystem::path& folder);

}  // namespace sil
