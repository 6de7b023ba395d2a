// Campaign run: the true vehicle and what the firmware believes of it, driven once.
#include "sil/campaign/campaign_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "sil/calibration/calibration_file.hpp"
#include "sil/campaign/indices.hpp"
#include "sil/manoeuvres/catalogue.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/units.hpp"
#include "sil/vehicle/load.hpp"
#include "sil/vehicle/parameter_file.hpp"

namespace sil {
namespace {

constexpr double early_s = 0.1;
constexpr double rounding_s = 1.0e-6;

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
        const double end_s = outcome().two_wheel_lift_time_s.value_or(1.0e9);
        const double early_end_s = outcome().two_wheel_lift_time_s ? end_s - early_s : end_s;
        const auto cycles = std::max(1, static_cast<int>(parameters_.warning_confirmation_s / 0.01F + 0.5F));
        std::vector<IndexPeaks> all;
        for (const std::vector<double>& levels : levels_) {
            all.push_back(peaks_of(levels, static_cast<std::size_t>(cycles), end_s, early_end_s));
        }
        return all;
    }

 private:
    IndexPeaks peaks_of(const std::vector<double>& levels, std::size_t cycles, double end_s,
                        double early_end_s) const {
        IndexPeaks peaks;
        for (std::size_t k = cycles - 1U; k < levels.size() && times_s_[k] <= end_s + rounding_s; ++k) {
            const double level = lasting_level(levels, k, cycles);
            peaks.whole = std::max(peaks.whole, level);
            if (times_s_[k] <= early_end_s + rounding_s) {
                peaks.before_100ms = std::max(peaks.before_100ms, level);
            }
            if (level >= 1.0 && !peaks.first_time_s) {
                peaks.first_time_s = times_s_[k];
            }
        }
        return peaks;
    }

    // The level that all of the last `cycles` reached; 0 when one of them had none.
    static double lasting_level(const std::vector<double>& levels, std::size_t last, std::size_t cycles) {
        double level = levels[last];
        for (std::size_t back = 0U; back < cycles; ++back) {
            const double other = levels[last - back];
            if (!std::isfinite(other)) {
                return 0.0;
            }
            level = std::min(level, other);
        }
        return level;
    }

    const rsi::Outputs& outputs_;
    const rsi::Parameters& parameters_;
    OutcomeObserver outcome_{};
    std::vector<double> times_s_{};
    std::vector<std::vector<double>> levels_{};
};

float with_error(double truth, double error) {
    return static_cast<float>(truth * (1.0 + error));
}

// The calibration was made for the vehicle without load; its values for mass and CG height are wrong by the
// drawn shares of what they are in this run, load included, so the load is a part of the error and not on
// top.
rsi::Parameters mistaken(rsi::Parameters calibration, const VehicleParameters& truth, const RunDraw& draw) {
    const auto stiffness = static_cast<double>(calibration.roll_stiffness_nmprad);
    calibration.sprung_mass_kg = with_error(truth.mass.sprung_kg, draw.mass_error);
    calibration.sprung_cg_height_m = with_error(truth.geometry.cg_height_m, draw.cg_height_error);
    calibration.roll_stiffness_nmprad = with_error(stiffness, draw.stiffness_error);
    return calibration;
}

SensorOptions drawn_sensors(const VehicleParameters& vehicle, const CampaignSpread& spread,
                            const RunDraw& draw) {
    SensorFlaws flaws;
    flaws.noise = spread.sensor_noise;
    flaws.seed = draw.sensor_seed;
    SensorOptions sensors = mounted_sensors(vehicle, flaws);
    sensors.imu.lateral_acceleration_mps2.bias = draw.lateral_bias_g * g_mps2;
    sensors.imu.vertical_acceleration_mps2.bias = draw.vertical_bias_g * g_mps2;
    return sensors;
}

VehicleParameters drawn_vehicle(VehicleParameters vehicle, Manoeuvre& manoeuvre, const RunDraw& draw) {
    // What the manoeuvre changes in the vehicle belongs to the truth that the errors are counted from.
    if (manoeuvre.adapt_vehicle) {
        vehicle = manoeuvre.adapt_vehicle(vehicle);
        manoeuvre.adapt_vehicle = {};
    }
    vehicle = with_load(vehicle, draw.load_share * vehicle.mass.sprung_kg,
                        draw.load_height_factor * vehicle.geometry.cg_height_m);
    return with_friction(vehicle, draw.friction_factor);
}

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
    const RunDraw draw = draw_run(settings_, number);
    const KnownVehicle& known = vehicles_[draw.vehicle];
    Manoeuvre manoeuvre = manoeuvres_[draw.manoeuvre];
    const VehicleParameters vehicle = drawn_vehicle(known.parameters, manoeuvre, draw);
    const rsi::Parameters calibration = mistaken(known.calibration, vehicle, draw);

    RunOptions options;
    options.mirrored = draw.mirrored;
    options.speed_factor = draw.speed_factor;
    options.steering_factor = draw.steering_factor;
    options.duration_s = settings_.manoeuvres[draw.manoeuvre].duration_s;
    InProcessRun run{vehicle, manoeuvre, options, drawn_sensors(vehicle, settings_.spread, draw),
                     calibration};
    LevelRecorder recorder{run.outputs(), calibration};
    run.run(recorder);

    CampaignRow row;
    row.draw = draw;
    row.vehicle = known.name;
    row.manoeuvre = manoeuvre.name;
    row.speed_kmh = manoeuvre.initial_speed_mps * draw.speed_factor * 3.6;
    row.outcome = recorder.outcome();
    if (run.events().warning) {
        row.warning_time_s = run.events().warning->time_s;
    }
    row.indices = recorder.peaks();
    return row;
}

}  // namespace sil
