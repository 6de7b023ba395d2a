// Live drive: one drive of a vehicle with its sensors and the firmware, cycle by cycle, with its driver and
// its faults.
#pragma once

#include <optional>
#include <string>

#include "sil/live/live_ecu.hpp"
#include "sil/simulation/closed_loop.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/studies/faults/signal_fault.hpp"
#include "sil/world/manoeuvres/free_drive.hpp"

namespace sil {

// Driver, vehicle and faults of a drive.
struct LiveVehicle {
    VehicleParameters vehicle{};
    MakeLiveEcu make_ecu{};  // with a calibration without a load: the firmware receives none
    std::string ecu_text{};  // where it is, as the page says it
    SensorFlaws sensors{};
    std::optional<Manoeuvre> manoeuvre{};  // none: the page's user drives
};

class LiveDrive final : private RunObserver {
 public:
    // From `wish.speed_mps` on, with so much on the roof. `wish` must outlive the drive. Throws what
    // `what.make_ecu` throws.
    LiveDrive(const LiveVehicle& what, const DriverWish& wish, double roof_load_kg);

    // One cycle of 10 ms, of which `also` sees everything; false after the last one: the vehicle lies on its
    // side, or the time is over. Not to be called again then.
    bool cycle(RunObserver& also);

    // From the next cycle on; none: all sensors are good.
    void break_sensor(const std::optional<Fault>& fault);
    const std::optional<Fault>& fault() const { return fault_; }

    // From the next cycle on: whether a stability function brakes while the ECU warns.
    void brake_on_warning(bool brakes) { brakes_on_warning_ = brakes; }

    const ManoeuvreRun& plant() const { return plant_; }
    const ClosedLoop& loop() const { return loop_; }
    const Manoeuvre& manoeuvre() const { return manoeuvre_; }
    // See LiveEcu.
    const rsi::Outputs* outputs() const { return ecu_->outputs(); }

 private:
    SensorSample reported(const SensorSample& sample) override;
    void cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
               const RunEvents& events) override;
    void step(const Truth& truth) override;

    Manoeuvre manoeuvre_;
    ManoeuvreRun plant_;
    SensorSuite sensors_;
    std::unique_ptr<LiveEcu> ecu_;
    ClosedLoop loop_;
    bool brakes_on_warning_{false};
    std::optional<Fault> fault_{};
    std::optional<SignalFault> broken_{};
    RunObserver* also_{nullptr};
};

}  // namespace sil
