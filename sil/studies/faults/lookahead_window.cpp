#include "sil/studies/faults/lookahead_window.hpp"

#include "sil/studies/faults/faulty_run.hpp"

namespace sil {

LookaheadWindow::LookaheadWindow(const VehicleParameters& vehicle, const rsi::Parameters& calibration,
                                 std::uint64_t seed, double duration_s)
    : world_{vehicle, seed, duration_s}, scout_{calibration} {
    while (ahead_.size() < cycles_ahead) {
        look();
    }
}

LookaheadWindow::Cycle LookaheadWindow::next() {
    look();
    const Cycle cycle = ahead_.front();
    ahead_.pop_front();
    return cycle;
}

void LookaheadWindow::look() {
    Cycle cycle{world_.next(), world_.stands()};
    std::optional<SensorSample> seen = cycle.sample;
    if (seen) {
        seen = as_equipped(*seen, Fault{});
    }
    const bool warns = scout_.cycle(number_, seen)->state == WarningState::warning;
    warning_begins_ = warns && !warned_;
    warned_ = warns;
    ++number_;
    ahead_.push_back(cycle);
}

}  // namespace sil
