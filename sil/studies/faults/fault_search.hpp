// Fault search: random faults in random states of random drives, each of them drawn by its number.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "sil/studies/campaign/campaign_run.hpp"
#include "sil/studies/campaign/row_workers.hpp"
#include "sil/studies/faults/finding.hpp"
#include "sil/studies/faults/search_drive.hpp"

namespace sil {

struct SearchScenario {
    Fault fault{};
    std::size_t begin{0U};  // cycle of the drive as the ECU has it
    std::size_t end{0U};
    std::size_t period{0U};  // of an intermittent fault; 0: it is there all the time
    std::size_t burst{0U};
};

struct SearchOutcome {
    std::uint64_t number{0U};
    FaultKind fault{};
    FaultPlace place{};
    bool visible{false};
    bool due{false};                      // a warning, without the fault
    bool told{false};                     // by a code, or by "unavailable"
    std::vector<FindingKind> findings{};  // silent_findings()
};

class FaultSearch {
 public:
    // Drives as the settings say; `runs` of them is the number of scenarios. Throws what CampaignWorld
    // throws.
    explicit FaultSearch(const CampaignSettings& settings) : world_{settings} {}

    // Safe to call from several threads at once, and quick for neighbours: so many scenarios share a drive.
    static constexpr std::uint64_t scenarios_a_drive = 20U;
    SearchOutcome run(std::uint64_t number) const;

    // Scenario and reaction in some lines.
    std::string explain(std::uint64_t number) const;

    const CampaignSettings& settings() const { return world_.settings(); }

 private:
    struct Slot {
        std::once_flag recorded{};
        std::unique_ptr<const SearchDrive> drive{};
    };
    // A scenario as it is driven.
    struct Injection;
    std::shared_ptr<const Slot> drive_of(std::uint64_t number) const;
    SearchScenario draw(std::uint64_t number, const SearchDrive& drive) const;
    Injection inject(std::uint64_t number) const;

    CampaignWorld world_;
    mutable std::mutex mutex_{};
    mutable std::map<std::uint64_t, std::shared_ptr<Slot>> drives_{};  // the latest
};

// All scenarios of the settings, each a row of OUTPUT/runs.csv; goes on where it was left. See make_rows().
RowProgress run_fault_search(const FaultSearch& search, const std::filesystem::path& output, unsigned jobs,
                             const std::atomic<bool>& stop, const RowListener& listener);

// Those that are in the folder, by number.
std::vector<SearchOutcome> load_search(const std::filesystem::path& output);

}  // namespace sil
