// Faulty run: one drive with one fault, and all that the ECU answered.
#pragma once

#include <optional>
#include <vector>

#include "rsi/types.hpp"
#include "sil/studies/faults/ecu_answer.hpp"
#include "sil/studies/faults/fault.hpp"
#include "sil/studies/faults/recorded_drive.hpp"

namespace sil {

struct FaultyRun {
    std::vector<std::optional<EcuAnswer>> answers{};  // one a cycle; none while the ECU's processor stands
    std::optional<std::size_t> visible{};             // first cycle in which the fault could be seen
    std::size_t over{0U};                             // first cycle in which it is there no longer
    bool watchdog_fed{true};                          // once in each cycle that was computed
};

// Without a fault (kind `none`): the drive as it is, with a sensor of bank or mass if the place is that.
// Throws std::invalid_argument when the calibration is refused.
FaultyRun run_with_fault(const FaultedDrive& drive, const Fault& fault, const rsi::Parameters& calibration);

// Without a fault, with and without a sensor of bank or mass: what a run with a fault is compared with.
class RightRuns {
 public:
    RightRuns(const FaultedDrive& drive, const rsi::Parameters& calibration);

    const FaultyRun& of(const Fault& fault) const {
        if (fault.place == FaultPlace::vehicle_mass) {
            return with_mass_;
        }
        return fault.place == FaultPlace::bank_angle ? with_bank_ : without_bank_;
    }

 private:
    FaultyRun without_bank_;
    FaultyRun with_bank_;
    FaultyRun with_mass_;
};

// Most vehicles have no sensors of bank and mass; only a fault of one needs it.
SensorSample as_equipped(SensorSample sample, const Fault& fault);

}  // namespace sil
