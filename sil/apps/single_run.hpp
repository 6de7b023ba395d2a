// Single run: one run of a campaign once more, with everything that a run leaves.
#pragma once

#include <cstdint>
#include <filesystem>

#include "sil/studies/campaign/campaign_run.hpp"

namespace sil {

// Prints what was drawn and the account, and writes what `rsi-sil run --in-process` does, without its log,
// and the run's calibration, with its errors, as calibration.toml. Returns the run's row, the same as that of
// the campaign. Throws std::exception with a message for the user.
CampaignRow drive_single_run(const CampaignWorld& world, std::uint64_t number,
                             const std::filesystem::path& output);

}  // namespace sil
