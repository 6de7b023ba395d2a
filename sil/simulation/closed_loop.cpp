#include "sil/simulation/closed_loop.hpp"

#include <cmath>

namespace sil {
namespace {

// Beyond this the vehicle has rolled over; what the model does on its side is of no interest.
constexpr double rolled_over_rad = 1.2;

}  // namespace

ClosedLoop::ClosedLoop(ManoeuvreRun& plant, SensorSuite& sensors, rsi::hal::CanBus& bus, Pace& pace)
    : plant_{plant},
      sensors_{sensors},
      bus_{bus},
      pace_{pace},
      events_{static_stability_factor(plant.vehicle().parameters())} {}

void ClosedLoop::run(RunObserver& observer) {
    while (cycle(observer)) {
    }
}

bool ClosedLoop::cycle(RunObserver& observer) {
    if (number_ > 0U) {
        for (int step = 0; step < steps_per_cycle; ++step) {
            plant_.step();
            see_step(observer);
        }
    }
    return exchange(observer);
}

void ClosedLoop::see_step(RunObserver& observer) {
    sensors_.observe(plant_.truth());
    events_.observe(plant_.truth());
    observer.step(plant_.truth());
}

bool ClosedLoop::exchange(RunObserver& observer) {
    if (number_ == 0U) {
        sensors_.observe(plant_.truth());
    }
    const SensorSample sample = observer.reported(sensors_.report(plant_.truth()));
    exchange_frames(number_, sample);
    ++number_;
    observer.cycle(plant_.truth(), sample, ecu_, events_.events());
    return !plant_.finished() && !observer.settled() &&
           std::abs(plant_.truth().roll_angle_rad) <= rolled_over_rad;
}

void ClosedLoop::exchange_frames(std::uint32_t number, const SensorSample& sample) {
    pace_.begin_cycle(number);
    sensor_frames_.send(bus_, sample);
    pace_.frames_sent(number);
    bool answered = false;
    rsi::hal::CanFrame frame;
    do {
        while (bus_.receive(frame) == rsi::hal::ReceiveResult::frame) {
            answered = take(frame) || answered;
        }
    } while (!answered && pace_.wait_for_answer(number));
}

// True for the frame that ends the ECU's answer.
bool ClosedLoop::take(const rsi::hal::CanFrame& frame) {
    const EcuFrameKind kind = ecu_.take(frame);
    if (kind == EcuFrameKind::warning) {
        events_.observe(ecu_.output(), pace_.reception_time_s(frame));
    }
    return kind == EcuFrameKind::status;
}

}  // namespace sil
