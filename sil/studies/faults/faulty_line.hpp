// Faulty line: one ECU and the way to it, on which two faults can be.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "sil/simulation/sensor_frames.hpp"
#include "sil/studies/faults/ecu_answer.hpp"
#include "sil/studies/faults/fault_schedule.hpp"
#include "sil/studies/faults/faulty_bus.hpp"
#include "sil/studies/faults/faulty_ecu.hpp"
#include "sil/studies/faults/signal_fault.hpp"

namespace sil {

class FaultyLine {
 public:
    // Without a fault. Throws std::invalid_argument when the calibration is refused.
    explicit FaultyLine(const rsi::Parameters& calibration);

    void inject(const std::array<ScheduledFault, 2U>& faults);

    // One cycle; nothing is sent without a sample. None while the ECU's processor stands or its
    // frames reach no receiver.
    std::optional<EcuAnswer> cycle(std::uint64_t number, const std::optional<SensorSample>& sample);

    // In the latest cycle: once after a step, not at all while the processor stands.
    bool fed_once() const { return fed_once_; }
    const rsi::Outputs& outputs() const { return ecu_.outputs(); }

 private:
    FaultyEcu ecu_;
    std::array<ScheduledFault, 2U> faults_{};
    std::unique_ptr<FaultyBus> second_{};
    std::unique_ptr<FaultyBus> first_{};
    std::array<std::optional<SignalFault>, 2U> sensors_{};
    SensorFrames frames_{};
    EcuAnswerReader reader_{};
    int fed_{0};
    bool fed_once_{true};
};

}  // namespace sil
