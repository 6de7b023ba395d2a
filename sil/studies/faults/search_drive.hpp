// Search drive: one of those that the random search injects its faults into.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sil/studies/campaign/campaign_run.hpp"
#include "sil/studies/faults/faulty_run.hpp"

namespace sil {

struct SearchDrive {
    std::string vehicle{};
    std::string name{};           // of what is driven
    double ecu_starts_at_s{0.0};  // after the drive's beginning: a reset
    rsi::Parameters calibration{};
    FaultedDrive drive{};  // as the ECU has it, up to two-wheel lift-off
    RightRuns right;
    std::optional<std::size_t> due{};  // first cycle of a warning without a fault
};

// Drawn from the settings' seed and the drive's number alone: a run of the campaign after some seconds
// straight ahead or of gentle turns, or a vehicle at rest or at a crawl; the ECU starts with it or in the
// middle of it.
SearchDrive record_search_drive(const CampaignWorld& world, std::uint64_t number);

}  // namespace sil
