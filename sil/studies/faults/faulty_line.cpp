#include "sil/studies/faults/faulty_line.hpp"

namespace sil {

FaultyLine::FaultyLine(const rsi::Parameters& calibration) : ecu_{calibration} {
    inject({});
}

void FaultyLine::inject(const std::array<ScheduledFault, 2U>& faults) {
    faults_ = faults;
    ecu_.inject(faults_[0].fault);
    first_.reset();  // before what it sends on
    second_ = std::make_unique<FaultyBus>(ecu_.world_bus(), faults_[1].fault);
    first_ = std::make_unique<FaultyBus>(*second_, faults_[0].fault);
    for (std::size_t index = 0U; index < sensors_.size(); ++index) {
        sensors_[index].emplace(faults_[index].fault);
    }
}

std::optional<EcuAnswer> FaultyLine::cycle(std::uint64_t number, const std::optional<SensorSample>& sample) {
    const bool first = faults_[0].is_active(number);
    const bool second = faults_[1].is_active(number);
    ecu_.begin_cycle(number, first);
    second_->begin_cycle(second);
    first_->begin_cycle(first);
    if (sample) {
        frames_.send(*first_, sensors_[1]->apply(sensors_[0]->apply(*sample, first), second));
    }
    const bool stepped = ecu_.step();
    const int feeds = ecu_.watchdog_feeds() - fed_;
    fed_ = ecu_.watchdog_feeds();
    fed_once_ = feeds == (stepped ? 1 : 0);
    if (!stepped || (first && faults_[0].fault.kind == FaultKind::bus_off)) {
        return std::nullopt;
    }
    return reader_.read(ecu_.world_bus());
}

}  // namespace sil
