// Campaign run: driven once, with every index watched.
#include "sil/studies/campaign/campaign_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <filesystem>
#include <stdexcept>

#include "sil/files/calibration_file.hpp"
#include "sil/judge/index_score.hpp"
#include "sil/simulation/run_batch.hpp"
#include "sil/studies/campaign/indices.hpp"
#include "sil/studies/campaign/learning_drive.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace sil {

// Keeps what every index says in every cycle: which of them count is known only when two-wheel lift-off is.
class CampaignWorld::IndexRecorder final : public RunObserver {
 public:
    // With `intervention`, the run has it from now on, and the warning of its index demands it.
    IndexRecorder(InProcessRun& run, const rsi::Parameters& parameters,
                  const std::optional<CampaignIntervention>& intervention, RunObserver& also)
        : run_{run}, parameters_{parameters}, readers_{parameters}, also_{also} {
        courses_.resize(campaign_indices().size());
        if (intervention) {
            run_.plant().add_intervention(intervention->action);
            if (!intervention->by_firmware()) {
                demand_.emplace(Demand{index_place(intervention->index).value(),
                                       IndexWarning{parameters, intervention->level}});
            }
        }
    }

    void cycle(const Truth& truth, const SensorSample& sensors, const EcuFrames& ecu,
               const RunEvents& events) override {
        also_.cycle(truth, sensors, ecu, events);
        const rsi::can_dbc::RolloverDiagnosis& diagnosis = ecu.diagnosis();
        if (diagnosis.code_status == rsi::can_dbc::RolloverDiagnosis::CodeStatus::confirmed) {
            codes_ |= std::uint64_t{1U} << static_cast<unsigned>(diagnosis.code);
        }
        const rsi::Outputs& outputs = run_.outputs();
        const IndexSample sample{outputs, truth, roll_angle_in_use(run_.inputs(), outputs)};
        for (std::size_t i = 0U; i < courses_.size(); ++i) {
            courses_[i].times_s.push_back(truth.time_s);
            courses_[i].risks.push_back(readers_.risk(i, sample));
        }
        run_.plant().demand_intervention(warning_state(ecu) == WarningState::warning);
    }

    void step(const Truth& truth) override {
        if (!std::isfinite(truth.roll_angle_rad)) {
            throw std::runtime_error("the simulated vehicle's motion is no longer a number");
        }
        outcome_.observe(truth);
        also_.step(truth);
    }
    bool settled() const override { return outcome_.settled(); }

    const Outcome& outcome() const { return outcome_.outcome(); }
    std::uint64_t codes() const { return codes_; }

    std::vector<IndexScore> scores() const {
        std::vector<IndexScore> all;
        for (const IndexCourse& course : courses_) {
            all.push_back(score_of(course, parameters_, outcome_.lift_off()));
        }
        return all;
    }

 private:
    struct Demand {
        std::size_t index;
        IndexWarning warning;
    };

    WarningState warning_state(const EcuFrames& ecu) {
        if (!demand_) {
            return ecu.output().state();
        }
        demand_->warning.update(courses_[demand_->index].risks.back());
        return demand_->warning.state();
    }

    InProcessRun& run_;
    const rsi::Parameters& parameters_;
    const IndexReaders readers_;
    RunObserver& also_;
    OutcomeObserver outcome_{};
    std::uint64_t codes_{0U};
    std::vector<IndexCourse> courses_{};
    std::optional<Demand> demand_{};  // none: the firmware's warning
};

CampaignWorld::CampaignWorld(const CampaignSettings& settings) : settings_{settings} {
    for (const CampaignVehicle& vehicle : settings.vehicles) {
        vehicles_.push_back({std::filesystem::path{vehicle.parameters}.stem().string(),
                             load_vehicle(vehicle.parameters),
                             load_calibration(vehicle.calibration, settings.changes),
                             {}});
        for (std::size_t i = 0U; i < settings.manoeuvres.size(); ++i) {
            vehicles_.back().learning.push_back(std::make_unique<LearningDrive>());
        }
    }
    for (const CampaignManoeuvre& manoeuvre : settings.manoeuvres) {
        manoeuvres_.push_back(campaign_manoeuvre(manoeuvre.name));
    }
}

// One run with what watches it.
class CampaignWorld::Drive {
 public:
    Drive(const CampaignWorld& world, DrawnRun drawn, RunWatch* watch)
        : world_{world},
          drawn_{std::move(drawn)},
          run_{drawn_.vehicle, drawn_.manoeuvre,           drawn_.options, drawn_.sensors, drawn_.calibration,
               nullptr,        world.learnt_before(drawn_)},
          recorder_{run_, drawn_.calibration, world.settings_.intervention,
                    watch != nullptr ? static_cast<RunObserver&>(*watch) : no_observer_} {
        if (watch != nullptr) {
            watch->begin(run_, drawn_);
        }
    }

    InProcessRun& run() { return run_; }
    RunObserver& observer() { return recorder_; }
    std::uint64_t number() const { return drawn_.draw.number; }

    // Once the run has ended.
    CampaignRow row() {
        CampaignRow row;
        row.draw = drawn_.draw;
        row.vehicle = world_.vehicles_[drawn_.draw.vehicle].name;
        row.in_class = world_.settings_.vehicles[drawn_.draw.vehicle].in_class;
        row.manoeuvre = drawn_.manoeuvre.name;
        row.speed_kmh = drawn_.manoeuvre.initial_speed_mps * drawn_.draw.speed_factor * 3.6;
        row.outcome = recorder_.outcome();
        if (run_.events().warning) {
            row.warning_time_s = run_.events().warning->time_s;
        }
        row.judgement = run_.events().judgement;
        row.codes = recorder_.codes();
        if (const std::optional<InterventionEffect>& intervention = run_.plant().intervention()) {
            row.interventions = intervention->times();
            row.intervention_s = intervention->duration_s();
        }
        row.indices = recorder_.scores();
        return row;
    }

 private:
    const CampaignWorld& world_;
    const DrawnRun drawn_;
    InProcessRun run_;
    RunObserver no_observer_{};
    IndexRecorder recorder_;
};

CampaignRow CampaignWorld::run(std::uint64_t number, RunWatch* watch) const {
    Drive drive{*this, prepare(number), watch};
    drive.run().run(drive.observer());
    return drive.row();
}

// The lanes of one thread.
class CampaignWorld::Lanes {
 public:
    Lanes(const CampaignWorld& world, const NextRun& next, const TakeRow& take)
        : world_{world}, next_{next}, take_{take} {}

    void drive() {
        for (std::size_t lane = 0U; lane < drives_.size(); ++lane) {
            fill(lane);
        }
        while (wanted_ && std::any_of(drives_.begin(), drives_.end(),
                                      [](const auto& drive) { return drive != nullptr; })) {
            const auto ended = cycle();
            for (std::size_t lane = 0U; wanted_ && lane < drives_.size(); ++lane) {
                if (ended[lane]) {
                    finish(lane);
                    fill(lane);
                }
            }
        }
    }

 private:
    [[noreturn]] static void fail(std::uint64_t number, const std::exception& error) {
        throw std::runtime_error("run " + std::to_string(number) + ": " + error.what());
    }

    // Draws as many runs as there are lanes, and finds together what their drivers ask for.
    void draw_ahead() {
        while (drawn_.size() < RunBatch::lane_count) {
            const std::optional<std::uint64_t> number = next_();
            if (!number) {
                break;
            }
            try {
                drawn_.push_back(world_.prepare(*number));
            } catch (const std::exception& error) {
                fail(*number, error);
            }
        }
        std::vector<const VehicleParameters*> vehicles;
        for (const DrawnRun& drawn : drawn_) {
            if (drawn.manoeuvre.asks_for_handwheel_angle) {
                vehicles.push_back(&drawn.vehicle);
            }
        }
        find_handwheel_angles_ahead(vehicles);
    }

    void fill(std::size_t lane) {
        while (wanted_ && !drives_[lane]) {
            if (drawn_.empty()) {
                draw_ahead();
            }
            if (drawn_.empty()) {
                return;
            }
            DrawnRun drawn = std::move(drawn_.front());
            drawn_.pop_front();
            const std::uint64_t number = drawn.draw.number;
            try {
                drives_[lane] = std::make_unique<Drive>(world_, std::move(drawn), nullptr);
                if (!batch_.begin(lane, drives_[lane]->run(), drives_[lane]->observer())) {
                    finish(lane);
                }
            } catch (const std::exception& error) {
                fail(number, error);
            }
        }
    }

    std::array<bool, RunBatch::lane_count> cycle() {
        try {
            return batch_.cycle();
        } catch (const std::exception& error) {
            fail(drives_[batch_.lane_at_work()]->number(), error);
        }
    }

    void finish(std::size_t lane) {
        wanted_ = take_(drives_[lane]->row());
        drives_[lane].reset();
    }

    const CampaignWorld& world_;
    const NextRun& next_;
    const TakeRow& take_;
    std::deque<DrawnRun> drawn_{};  // not yet begun
    std::array<std::unique_ptr<Drive>, RunBatch::lane_count> drives_{};
    RunBatch batch_{};
    bool wanted_{true};
};

void CampaignWorld::run_together(const NextRun& next, const TakeRow& take) const {
    Lanes{*this, next, take}.drive();
}

// Manoeuvres that leave the vehicle as it is share the drive of the first of them.
CampaignWorld::LearningDrive& CampaignWorld::learning_drive_before(const RunDraw& draw) const {
    const auto same = [](const Manoeuvre& manoeuvre) { return !manoeuvre.adapt_vehicle; };
    const auto own = manoeuvres_.begin() + static_cast<std::ptrdiff_t>(draw.manoeuvre);
    const auto driven = same(*own) ? std::find_if(manoeuvres_.begin(), manoeuvres_.end(), same) : own;
    return *vehicles_[draw.vehicle].learning[static_cast<std::size_t>(driven - manoeuvres_.begin())];
}

// The drive is that of the vehicle as its file and the manoeuvre have it, with sensors without bias; what it
// shows is learnt with the errors of this run's calibration and mass sensor.
std::optional<rsi::LearntLoad> CampaignWorld::learnt_before(const DrawnRun& drawn) const {
    if (settings_.learning_s == 0.0) {
        return std::nullopt;
    }
    LearningDrive& learning = learning_drive_before(drawn.draw);
    std::call_once(learning.driven, [&] {
        const KnownVehicle& known = vehicles_[drawn.draw.vehicle];
        const Manoeuvre& manoeuvre = manoeuvres_[drawn.draw.manoeuvre];
        const VehicleParameters vehicle =
            manoeuvre.adapt_vehicle ? manoeuvre.adapt_vehicle(known.parameters) : known.parameters;
        RunDraw nothing_drawn;
        nothing_drawn.vehicle = drawn.draw.vehicle;
        nothing_drawn.sensor_seed = settings_.seed + drawn.draw.vehicle;
        learning.inputs = learning_drive(vehicle, drawn_sensors(settings_, nothing_drawn, vehicle),
                                         known.calibration, settings_.learning_s);
    });
    return learnt_load(learning.inputs, drawn.calibration, drawn.draw.mass_sensor_error);
}

DrawnRun CampaignWorld::prepare(std::uint64_t number) const {
    const RunDraw draw = draw_run(settings_, number);
    const KnownVehicle& known = vehicles_[draw.vehicle];
    return drawn_run(settings_, draw, known.parameters, known.calibration, manoeuvres_[draw.manoeuvre]);
}

}  // namespace sil
