// Campaign: all runs of the settings, on as many threads as wanted, into one file of rows.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "sil/studies/campaign/campaign_run.hpp"
#include "sil/studies/campaign/row_workers.hpp"

namespace sil {

// TRACES/NUMBER.csv; the calibration of the run, with its errors, is beside it as NUMBER.toml.
std::filesystem::path trace_file(const std::filesystem::path& traces, std::uint64_t number);

class RunTrace final : public RunWatch {
 public:
    void begin(const InProcessRun& run, const DrawnRun& drawn) override;
    void cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
               const RunEvents& events) override;

    // Remarks on lift-off, and a line for each cycle: the inputs that the firmware used, as columns of a
    // drive (docs/drives.md), so that a trace can be replayed; what it made of them; what was true. Throws
    // std::exception when it cannot be written.
    void write(const std::filesystem::path& traces, const CampaignRow& row) const;

 private:
    const InProcessRun* run_{nullptr};
    std::string lines_{};
    std::string calibration_{};
};

// That many rows, or the lines of a part of them: runs that are driven together. A failure says the run's
// number.
RowWork campaign_work(const CampaignWorld& world, std::uint64_t count, unsigned jobs);

// Takes the folder up where an earlier call with the same settings left it, or begins it, and does the runs
// that are missing. Leaves campaign.toml and runs.csv there, the latter sorted by run number when all are
// done; its bytes depend on the settings alone. Returns early, with every finished run kept, once `stop` is
// true. Throws InputError when the folder holds another campaign, is in use, or cannot be written, and
// std::runtime_error with the run's number when a run fails. `with_traces`: every run also leaves its trace
// in the folder `traces`; a folder that has rows without traces is then refused.
RowProgress run_campaign(const CampaignWorld& world, const std::filesystem::path& output, unsigned jobs,
                         const std::atomic<bool>& stop, const RowListener& listener = {},
                         bool with_traces = false);

}  // namespace sil
