// Campaign run: from the number of a run to its row.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/studies/campaign/drawn_run.hpp"
#include "sil/studies/campaign/row.hpp"
#include "sil/studies/campaign/settings.hpp"
#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

// Sees a run of a campaign beside what makes its row; it cannot end it.
class RunWatch : public RunObserver {
 public:
    // Before the first cycle; both are there until the last one.
    virtual void begin(const InProcessRun& run, const DrawnRun& drawn) = 0;
};

// The files that the settings name, read once. Throws what load_vehicle, load_calibration and find_manoeuvre
// throw.
class CampaignWorld {
 public:
    explicit CampaignWorld(const CampaignSettings& settings);

    // Safe to call from several threads at once. Throws std::exception when the run fails.
    CampaignRow run(std::uint64_t number, RunWatch* watch = nullptr) const;

    // Runs that are driven together, which takes half the time; each row is the one of run().
    // `next` gives the number of one more run, or nothing when there are no more; `take` gets each row as its
    // run ends, and returns false to end the others at once. Safe to call from several threads at once.
    // Throws std::runtime_error with its number when a run fails.
    using NextRun = std::function<std::optional<std::uint64_t>()>;
    using TakeRow = std::function<bool(const CampaignRow& row)>;
    void run_together(const NextRun& next, const TakeRow& take) const;

    // The simulation that run() drives.
    DrawnRun prepare(std::uint64_t number) const;

    const CampaignSettings& settings() const { return settings_; }

 private:
    class IndexRecorder;
    class Drive;
    class Lanes;

    // Index of the vehicle as a manoeuvre has it. Driven when the first run needs it, by whichever thread
    // comes first.
    struct LearningDrive {
        std::once_flag driven{};
        std::vector<rsi::Inputs> inputs{};
    };
    struct KnownVehicle {
        std::string name;
        VehicleParameters parameters;
        rsi::Parameters calibration;
        std::vector<std::unique_ptr<LearningDrive>>
            learning;  // one for each manoeuvre; many are never driven
    };

    LearningDrive& learning_drive_before(const RunDraw& draw) const;
    // The load that the firmware of this run has learnt before it; nothing without a learning drive.
    std::optional<rsi::LearntLoad> learnt_before(const DrawnRun& drawn) const;

    CampaignSettings settings_;
    std::vector<KnownVehicle> vehicles_;
    std::vector<Manoeuvre> manoeuvres_;
};

}  // namespace sil
