// Campaign part: some runs of a campaign as one file, the unit of work that many machines share.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sil/studies/campaign/campaign_run.hpp"
#include "sil/studies/campaign/row_workers.hpp"

namespace sil {

// The first line of a part; the rows follow as runs.csv has them, header and all.
struct PartHead {
    std::uint64_t first{0U};  // number of its first run
    std::uint64_t count{0U};  // of runs, at least one
    std::string fingerprint{};

    // Without its end.
    std::string line() const;
};

// Empty when the line is no head of a part.
std::optional<PartHead> part_head(std::string_view line);

// The parts in a folder, by the number of their first run: each file NAME.csv that begins with a head. None
// where there is no folder. Throws InputError for a file that cannot be read.
struct FoundPart {
    std::filesystem::path path{};
    PartHead head{};
};
std::vector<FoundPart> parts_of(const std::filesystem::path& folder);

// Makes the runs from `first` on, `count` of them, and writes them into `part`, which is there whole or not
// at all. Its bytes depend on the settings, the range and the program alone, so parts of any partition hold
// the same rows, and several programs may make the same part. The folder of the part is that of the campaign:
// its campaign.toml is begun or compared. A part that is there with the same head is kept as it is.
//
// Returns without a file once `stop` is true. Throws InputError when the range goes beyond the settings'
// runs, the folder holds another campaign or runs.csv, or `part` is another part or no part;
// std::runtime_error with the run's number when a run fails, or with path and reason when the system refuses.
RowProgress make_part(const CampaignWorld& world, std::uint64_t first, std::uint64_t count,
                      const std::filesystem::path& part, unsigned jobs, const std::atomic<bool>& stop,
                      const RowListener& listener = {});

}  // namespace sil
