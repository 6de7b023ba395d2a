#include "tests/application/bench.hpp"

#include <cmath>

namespace testing_application {

Bench::Bench(const rsi::Parameters& parameters, rsi::hal::Time ecu_delay)
    : ecu_delay_{ecu_delay}, answer_{ecu_.init(parameters)} {
    drive(Motion{});
}

void Bench::drive(const Motion& motion) {
    motion_ = [motion](double) { return motion; };
}

void Bench::run_cycles(int count) {
    for (int index = 0; index < count; ++index) {
        const rsi::hal::Time time = rsi::hal::Time::from_milliseconds(10 * cycle_number_) + clock_offset_;
        clock_.set(time);
        send_sensor_frames();
        clock_.set(time + ecu_delay_);
        step_ecu();
        ++cycle_number_;
    }
}

void Bench::run_for(double seconds) {
    run_cycles(static_cast<int>(std::lround(seconds * 100.0)));
}

void Bench::run_until_ready() {
    run_for(0.2);
}

void Bench::stop_all() {
    for (const Sensor sensor : all_sensors) {
        stop(sensor);
    }
}

void Bench::resume_all() {
    for (const Sensor sensor : all_sensors) {
        resume(sensor);
    }
}

void Bench::lose_frames(Sensor sensor, unsigned count) {
    line(sensor).counter = (line(sensor).counter + count) % 15U;
}

void Bench::send_sensor_frames() {
    const Motion motion = motion_(static_cast<double>(cycle_number_) * 0.01);
    send(line(Sensor::imu), motion.imu);
    send(line(Sensor::roll_angle), motion.roll_angle);
    send(line(Sensor::vehicle_motion), motion.vehicle_motion);
    if (std::isfinite(motion.vehicle_mass.mass_kg)) {
        send(mass_line_, motion.vehicle_mass);
    }
}

template <typename Message>
void Bench::send(Line& line, const Message& message) {
    if (line.silent) {
        return;
    }
    rsi::hal::CanFrame frame = frame_of(message, line.counter);
    if (!line.counter_stands) {
        line.counter = (line.counter + 1U) % 15U;
    }
    if (line.change) {
        line.change(frame);
    }
    line.last = frame;
    last_sensor_time_ = clock_.now();
    bus_.endpoint(world).send(frame);
}

void Bench::step_ecu() {
    ecu_.step(missed_cycles_);
    Cycle cycle;
    cycle.time = clock_.now();
    rsi::hal::CanFrame frame;
    while (bus_.endpoint(world).receive(frame) == rsi::hal::ReceiveResult::frame) {
        cycle.frames.push_back(frame);
        switch (frame.identifier) {
            case rsi::can_dbc::RolloverWarning::identifier:
                cycle.warning = rsi::can_dbc::decode<rsi::can_dbc::RolloverWarning>(frame.data);
                break;
            case rsi::can_dbc::RollCentreEstimate::identifier:
                cycle.estimate = rsi::can_dbc::decode<rsi::can_dbc::RollCentreEstimate>(frame.data);
                break;
            case rsi::can_dbc::RolloverDiagnosis::identifier:
                cycle.diagnosis = rsi::can_dbc::decode<rsi::can_dbc::RolloverDiagnosis>(frame.data);
                break;
            case rsi::can_dbc::RolloverStatus::identifier:
                cycle.status = rsi::can_dbc::decode<rsi::can_dbc::RolloverStatus>(frame.data);
                break;
            default:
                break;
        }
    }
    cycles_.push_back(std::move(cycle));
}

}  // namespace testing_application
