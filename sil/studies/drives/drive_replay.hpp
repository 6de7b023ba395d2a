// Drive replay: a drive, or a log of sensor frames, through the firmware, cycle by cycle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/files/candump_log.hpp"
#include "sil/judge/warning_judgement.hpp"
#include "sil/results/diagnostic_codes.hpp"
#include "sil/results/ecu_output.hpp"
#include "sil/results/events.hpp"
#include "sil/studies/drives/drive.hpp"
#include "sil/studies/drives/lift_off.hpp"

namespace sil {

// One cycle of 10 ms.
struct ReplayCycle {
    DriveSample sample;      // sensor values before they became frames; of a log: those in its frames
    rsi::Outputs outputs{};  // outputs of the component
    EcuOutput ecu;           // content of the ECU's frames
    CodeSets codes;          // as far as its frames have told, one code a frame
    double load_transfer_ratio{EcuOutput::not_available};  // of the wheel loads
    double warning_level{EcuOutput::not_available};  // of the indicator that drives the warning; 1: warn
};

// A warning, and how near to lifting the vehicle can have been about it.
struct ReplayWarning {
    NamedWarning named;
    // Largest |LTR| from a second before it to a second after it, as the accelerometers and the calibration's
    // heights have it; NaN where they have none.
    double largest_load_transfer_ratio{EcuOutput::not_available};
};

struct DriveReplay {
    std::vector<ReplayCycle> cycles;
    std::vector<ReplayWarning> warnings;
    // The lateral acceleration is the one that the component measured, the roll angle the sensor's.
    RunEvents events;
    LiftOff lift_off;
    std::uint64_t confirmed_codes{0U};  // at any time
    // Before two-wheel lift-off where there is one; NaN when there was no value.
    double largest_load_transfer_ratio{EcuOutput::not_available};  // |LTR|
    double largest_warning_level{EcuOutput::not_available};
    std::size_t silent_cycles{0U};  // without any sensor frame
    std::uint64_t frames_sent{0U};
    std::uint64_t frames_received{0U};
};

// Asked at every cycle; true ends the replay by ReplayInterrupted.
using Interruption = std::function<bool()>;
class ReplayInterrupted : public std::runtime_error {
 public:
    ReplayInterrupted() : std::runtime_error{"interrupted"} {}
};

// The samples become the frames that the car's sensors send, every 10 ms (resample.hpp). Throws
// std::invalid_argument when the parameters are refused, ReplayInterrupted.
DriveReplay replay_drive(const Drive& drive, const rsi::Parameters& parameters,
                         const Interruption& interrupted = {});

// The log's own frames at their own times, stepped every 10 ms from the first; times count from it. Throws
// ReplayError (sil/simulation/replay.hpp) too.
DriveReplay replay_drive(const std::vector<LoggedFrame>& log, const rsi::Parameters& parameters,
                         const Interruption& interrupted = {});

// c_w / (2 h), h the height of the sprung CG, as the paper and the simulated vehicle count it.
double static_stability_factor(const rsi::Parameters& parameters);

}  // namespace sil
