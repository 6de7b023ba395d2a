// Run trace: one run of a campaign in time, for studies that want more of it than its row. Short, for there
// are thousands.
#pragma once

#include <filesystem>
#include <string>

#include "sil/studies/campaign/campaign_run.hpp"

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

}  // namespace sil
