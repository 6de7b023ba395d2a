#include "sil/live/live_drive.hpp"

#include "sil/world/vehicle/load.hpp"

namespace sil {
namespace {

// Half a metre of luggage.
constexpr double load_above_roof_m = 0.25;

VehicleParameters loaded(const VehicleParameters& vehicle, double roof_load_kg) {
    const double roof_m = vehicle.geometry.cg_height_m + vehicle.hull.top_above_cg_m;
    return roof_load_kg > 0.0 ? with_load(vehicle, roof_load_kg, roof_m + load_above_roof_m) : vehicle;
}

}  // namespace

LiveDrive::LiveDrive(const LiveVehicle& what, const DriverWish& wish, double roof_load_kg)
    : manoeuvre_{what.manoeuvre ? *what.manoeuvre : free_drive(wish, wish.speed_mps)},
      plant_{loaded(what.vehicle, roof_load_kg), manoeuvre_},
      sensors_{mounted_sensors(plant_.vehicle().parameters(), what.sensors)},
      ecu_{what.make_ecu()},
      loop_{plant_, sensors_, ecu_->bus(), ecu_->pace()} {
    plant_.add_intervention(stability_function);
}

bool LiveDrive::cycle(RunObserver& also) {
    also_ = &also;
    return loop_.cycle(*this);
}

void LiveDrive::break_sensor(const std::optional<Fault>& fault) {
    fault_ = fault;
    broken_.reset();
    if (fault) {
        broken_.emplace(*fault);
    }
}

SensorSample LiveDrive::reported(const SensorSample& sample) {
    return broken_ ? broken_->apply(sample, true) : sample;
}

void LiveDrive::cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
                      const RunEvents& events) {
    plant_.demand_intervention(brakes_on_warning_ && ecu.output().state() == WarningState::warning);
    also_->cycle(truth, sample, ecu, events);
}

void LiveDrive::step(const Truth& truth) {
    also_->step(truth);
}

}  // namespace sil
