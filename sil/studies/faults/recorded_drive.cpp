#include "sil/studies/faults/recorded_drive.hpp"

#include <cmath>
#include <memory>
#include <type_traits>
#include <utility>

#include "sil/judge/two_wheel_lift.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/units.hpp"
#include "sil/world/sensors/sensor_suite.hpp"

namespace sil {
namespace {

double load_transfer_of(const Truth& truth) {
    const auto& load = truth.wheel_load_n;
    const double left = load[front_left] + load[rear_left];
    const double right = load[front_right] + load[rear_right];
    const double sum = left + right;
    return sum > 0.0 ? (right - left) / sum : 0.0;
}

// Several sets of sensors in one vehicle.
class Recorder {
 public:
    explicit Recorder(const std::vector<SensorOptions>& sensors)
        : suites_{sensors.begin(), sensors.end()}, drives_(sensors.size()) {}

    void observe(const Truth& truth) {
        for (SensorSuite& suite : suites_) {
            suite.observe(truth);
        }
    }
    void report(const Truth& truth) {
        for (std::size_t index = 0U; index < suites_.size(); ++index) {
            drives_[index].samples.push_back(suites_[index].report(truth));
            drives_[index].load_transfer.push_back(load_transfer_of(truth));
        }
    }
    void lifts(std::size_t cycle) {
        for (RecordedDrive& drive : drives_) {
            drive.two_wheel_lift = cycle;
        }
    }
    std::vector<RecordedDrive> drives() && { return std::move(drives_); }

 private:
    std::vector<SensorSuite> suites_;
    std::vector<RecordedDrive> drives_;
};

// One driver after the other; none is one who goes straight ahead.
class TwoDrivers final : public Driver {
 public:
    // `speed_share`: of the run's speed, at which the first one drives.
    TwoDrivers(std::unique_ptr<Driver> first, double speed_share, std::unique_ptr<Driver> second,
               double change_s)
        : first_{std::move(first)},
          speed_share_{speed_share},
          second_{std::move(second)},
          change_s_{change_s} {}

    std::unique_ptr<Driver> copy() const override {
        return std::make_unique<TwoDrivers>(first_ ? first_->copy() : nullptr, speed_share_, second_->copy(),
                                            change_s_);
    }

    DriverCommand command(const Truth& truth) override {
        if (truth.time_s < change_s_) {
            DriverCommand command = first_ ? first_->command(truth) : DriverCommand{};
            command.speed_share *= speed_share_;
            return command;
        }
        Truth late = truth;
        late.time_s -= change_s_;
        return second_->command(late);
    }

 private:
    std::unique_ptr<Driver> first_;
    double speed_share_;
    std::unique_ptr<Driver> second_;
    double change_s_;
};

}  // namespace

std::size_t cycle_count(double seconds) {
    return static_cast<std::size_t>(seconds / cycle_time_s + 0.5);
}

SensorOptions recording_sensors(const VehicleParameters& vehicle) {
    SensorFlaws flaws;
    flaws.noise = true;
    flaws.seed = recording_noise_seed;
    flaws.bank_sensor = true;
    flaws.mass_sensor = true;
    return mounted_sensors(vehicle, flaws);
}

std::vector<RecordedDrive> record_drive(const VehicleParameters& vehicle, const Manoeuvre& manoeuvre,
                                        const RunOptions& options,
                                        const std::vector<SensorOptions>& sensors) {
    ManoeuvreRun plant{vehicle, manoeuvre, options};
    Recorder recorder{sensors};
    TwoWheelLiftObserver two_wheels;
    recorder.observe(plant.truth());
    for (;;) {
        const Truth& truth = plant.truth();
        two_wheels.observe({truth.time_s, truth.lateral_acceleration_mps2, truth.roll_angle_rad},
                           left_side_has_lifted(truth), right_side_has_lifted(truth));
        if (two_wheels.lift_off()) {
            recorder.lifts(cycle_count(two_wheels.lift_off()->moment.time_s));
        }
        recorder.report(truth);
        if (plant.finished() || std::abs(truth.roll_angle_rad) > recorded_roll_rad) {
            return std::move(recorder).drives();
        }
        for (int step = 0; step < recorded_steps; ++step) {
            plant.step();
            recorder.observe(plant.truth());
        }
    }
}

std::vector<RecordedDrive> record_rest(const VehicleParameters& vehicle, double duration_s,
                                       const std::vector<SensorOptions>& sensors) {
    Truth truth;
    truth.mass_kg = total_mass_kg(vehicle);
    truth.specific_force_mps2 = {0.0, 0.0, g_mps2};
    Recorder recorder{sensors};
    for (std::size_t cycle = 0U; cycle <= cycle_count(duration_s); ++cycle) {
        truth.time_s = static_cast<double>(cycle) * cycle_time_s;
        recorder.observe(truth);
        recorder.report(truth);
    }
    return std::move(recorder).drives();
}

RecordedDrive part_of(const RecordedDrive& drive, std::size_t begin, std::size_t end) {
    const auto range = [begin, end](const auto& all) {
        return std::decay_t<decltype(all)>{all.begin() + static_cast<std::ptrdiff_t>(begin),
                                           all.begin() + static_cast<std::ptrdiff_t>(end)};
    };
    RecordedDrive part{range(drive.samples), range(drive.load_transfer), {}};
    if (drive.two_wheel_lift && *drive.two_wheel_lift >= begin) {
        part.two_wheel_lift = *drive.two_wheel_lift - begin;
    }
    return part;
}

Manoeuvre with_lead_in(const Manoeuvre& manoeuvre, double lead_in_s, const Manoeuvre* lead_in) {
    Manoeuvre both = manoeuvre;
    both.duration_s += lead_in_s;
    double share = manoeuvre.start_speed_share;
    if (lead_in != nullptr) {
        share = lead_in->initial_speed_mps / manoeuvre.initial_speed_mps;
        both.start_speed_share = share;
    }
    both.make_driver = [first = lead_in != nullptr ? lead_in->make_driver : nullptr, share,
                        second = manoeuvre.make_driver, lead_in_s](const VehicleParameters& parameters) {
        return std::make_unique<TwoDrivers>(first ? first(parameters) : nullptr, share, second(parameters),
                                            lead_in_s);
    };
    return both;
}

}  // namespace sil
