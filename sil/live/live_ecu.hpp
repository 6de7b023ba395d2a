// Live ECU: the firmware of a live drive, and how the world reaches it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "rsi/types.hpp"
#include "sil/simulation/pace.hpp"

namespace sil {

class LiveEcu {
 public:
    LiveEcu(const LiveEcu&) = delete;
    LiveEcu& operator=(const LiveEcu&) = delete;
    virtual ~LiveEcu() = default;

    virtual rsi::hal::CanBus& bus() = 0;
    // It must not wait: who serves the drive calls each cycle when it is due.
    virtual Pace& pace() = 0;
    // Outputs of the firmware in the latest cycle; null when it runs elsewhere.
    virtual const rsi::Outputs* outputs() const = 0;

 protected:
    LiveEcu() = default;
};

// For one drive.
using MakeLiveEcu = std::function<std::unique_ptr<LiveEcu>()>;

// The firmware in this process. Throws std::invalid_argument when the calibration is refused.
std::unique_ptr<LiveEcu> live_ecu_in_process(const rsi::Parameters& calibration);

}  // namespace sil
