// Campaign run: driven once, with every index watched.
#include "sil/studies/campaign/campaign_run.hpp"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "sil/files/calibration_file.hpp"
#include "sil/studies/campaign/indices.hpp"
#include "sil/studies/campaign/peaks.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/simulation/in_process_run.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {
namespace {

// Keeps every level of every cycle: which of them count is known only when two-wheel lift-off is.
class LevelRecorder final : public RunObserver {
 public:
    LevelRecorder(const rsi::Outputs& outputs, const rsi::Parameters& parameters)
        : outputs_{outputs}, parameters_{parameters} {
        levels_.resize(campaign_indices().size());
    }

    void cycle(const Truth& truth, const SensorSample&, const EcuFrames&, const RunEvents&) override {
        const IndexSample sample{outputs_, truth, parameters_};
        times_s_.push_back(truth.time_s);
        for (std::size_t i = 0U; i < levels_.size(); ++i) {
            levels_[i].push_back(campaign_indices()[i].level(sample));
        }
    }

    void step(const Truth& truth) override {
        if (!std::isfinite(truth.roll_angle_rad)) {
            throw std::runtime_error("the simulated vehicle's motion is no longer a number");
        }
        outcome_.observe(truth);
    }
    bool settled() const override { return outcome_.settled(); }

    Outcome outcome() const { return outcome_.outcome(); }

    std::vector<IndexPeaks> peaks() const {
        const auto cycles = static_cast<std::size_t>(
            std::lround(static_cast<double>(parameters_.warning_confirmation_s) / cycle_time_s));
        std::vector<IndexPeaks> all;
        for (const std::vector<double>& levels : levels_) {
            all.push_back(peaks_of(times_s_, levels, cycles, outcome().two_wheel_lift_time_s));
        }
        return all;
    }

 private:
    const rsi::Outputs& outputs_;
    const rsi::Parameters& parameters_;
    OutcomeObserver outcome_{};
    std::vector<double> times_s_{};
    std::vector<std::vector<double>> levels_{};
};

}  // namespace

CampaignWorld::CampaignWorld(const CampaignSettings& settings) : settings_{settings} {
    for (const CampaignVehicle& vehicle : settings.vehicles) {
        vehicles_.push_back({std::filesystem::path{vehicle.parameters}.stem().string(),
                             load_vehicle(vehicle.parameters), load_calibration(vehicle.calibration)});
    }
    for (const CampaignManoeuvre& manoeuvre : settings.manoeuvres) {
        manoeuvres_.push_back(find_manoeuvre(manoeuvre.name));
    }
}

CampaignRow CampaignWorld::run(std::uint64_t number) const {
    const DrawnRun drawn = prepare(number);
    InProcessRun run{drawn.vehicle, drawn.manoeuvre, drawn.options, drawn.sensors, drawn.calibration};
    LevelRecorder recorder{run.outputs(), drawn.calibration};
    run.run(recorder);

    CampaignRow row;
    row.draw = drawn.draw;
    row.vehicle = vehicles_[drawn.draw.vehicle].name;
    row.in_class = settings_.vehicles[drawn.draw.vehicle].in_class;
    row.manoeuvre = drawn.manoeuvre.name;
    row.speed_kmh = drawn.manoeuvre.initial_speed_mps * drawn.draw.speed_factor * 3.6;
    row.outcome = recorder.outcome();
    if (run.events().warning) {
        row.warning_time_s = run.events().warning->time_s;
    }
    row.indices = recorder.peaks();
    return row;
}

DrawnRun CampaignWorld::prepare(std::uint64_t number) const {
    const RunDraw draw = draw_run(settings_, number);
    const KnownVehicle& known = vehicles_[draw.vehicle];
    return drawn_run(settings_, draw, known.parameters, known.calibration, manoeuvres_[draw.manoeuvre]);
}

}  // namespace sil
