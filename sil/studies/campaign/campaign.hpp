// Campaign: all runs of the settings, on as many threads as wanted, into one file of rows.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>

#include "sil/studies/campaign/campaign_run.hpp"

namespace sil {

struct CampaignProgress {
    std::uint64_t finished{0U};  // runs in the file, those of earlier calls included
    std::uint64_t total{0U};
    std::uint64_t begun_with{0U};  // runs that were in the file already
    double elapsed_s{0.0};         // of this call
    double simulated_s{0.0};       // in this call
    unsigned jobs{1U};
};

// Called after each finished run, by one thread at a time.
using CampaignListener = std::function<void(const CampaignProgress&)>;

// Takes the folder up where an earlier call with the same settings left it, or begins it, and does the runs
// that are missing. Leaves campaign.toml and runs.csv there, the latter sorted by run number when all are
// done; its bytes depend on the settings alone. Returns early, with every finished run kept, once `stop` is
// true. Throws InputError when the folder holds another campaign, is in use, or cannot be written, and
// std::runtime_error with the run's number when a run fails.
CampaignProgress run_campaign(const CampaignWorld& world, const std::filesystem::path& output, unsigned jobs,
                              const std::atomic<bool>& stop, const CampaignListener& listener = {});

}  // namespace sil
