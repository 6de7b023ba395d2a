// Campaign: all runs of the settings, on as many threads as wanted, into one file of rows.
#pragma once

#include <atomic>
#include <filesystem>

#include "sil/studies/campaign/campaign_run.hpp"
#include "sil/studies/campaign/row_workers.hpp"

namespace sil {

// That many rows, or the lines of a part of them: runs that are driven together. A failure says the run's
// number.
RowWork campaign_work(const CampaignWorld& world, std::uint64_t count, unsigned jobs);

// Takes the folder up where an earlier call with the same settings left it, or begins it, and does the runs
// that are missing. Leaves campaign.toml and runs.csv there, the latter sorted by run number when all are
// done; its bytes depend on the settings alone. Returns early, with every finished run kept, once `stop` is
// true. Throws InputError when the folder holds another campaign, is in use, or cannot be written, and
// std::runtime_error with the run's number when a run fails. `with_traces`: every run also leaves its trace
// (run_trace.hpp) in the folder `traces`; a folder that has rows without traces is then refused.
RowProgress run_campaign(const CampaignWorld& world, const std::filesystem::path& output, unsigned jobs,
                         const std::atomic<bool>& stop, const RowListener& listener = {},
                         bool with_traces = false);

}  // namespace sil
