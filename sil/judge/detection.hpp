// Detection: how well a warning tells runs that lift two wheels from runs that do not.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "sil/judge/statistics.hpp"
#include "sil/judge/warning_judgement.hpp"

namespace sil {

inline constexpr std::size_t band_count = sizeof(load_bands) / sizeof(load_bands[0]);

// A run is calm when two wheels do not lift and its largest |LTR| stays below 0.9.
constexpr bool is_calm(bool lifted, LoadBand band) {
    return !lifted && band != LoadBand::from_0_9;
}

// True outcome of a run.
struct RunKind {
    std::size_t vehicle{0U};  // numbered from 0
    bool lifted{false};       // two wheels of a side
    LoadBand band{LoadBand::below_0_7};
};

// Behaviour of one warning in one run.
struct WarningInRun {
    bool warned{false};
    bool warned_100ms{false};
    bool warned_200ms{false};
    bool alarm{false};
};
WarningInRun warning_in_run(const std::optional<double>& lead_s, bool alarm);

// Results of one warning over many runs.
struct Detection {
    Share warned{};                          // of two-wheel lift-offs: is_warned(lead)
    Share warned_100ms{};                    // with a lead of at least early_s
    Share warned_200ms{};                    // very_early_s
    Share false_alarms{};                    // of calm runs
    std::array<Share, band_count> alarms{};  // of the runs of each LoadBand
    // Leads of all two-wheel lift-offs, 0 for those without a warning.
    std::vector<double> lead_times_s{};
    std::optional<double> median_lead_s{};  // of these
    std::optional<double> tenth_lead_s{};   // their 10th percentile
};

class DetectionCounts {
 public:
    // One run; by its lead, or where leads are not known by what is said of it.
    void add(const RunKind& run, const std::optional<double>& lead_s, bool alarm);
    void add(const RunKind& run, const WarningInRun& warning);

    Detection detection() const;

 private:
    ShareByVehicle warned_{};
    ShareByVehicle warned_100ms_{};
    ShareByVehicle warned_200ms_{};
    ShareByVehicle false_alarms_{};
    std::array<ShareByVehicle, band_count> alarms_{};
    std::vector<double> lead_times_s_{};
};

}  // namespace sil
