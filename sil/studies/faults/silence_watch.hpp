// Silence watch: what became of each warning that was due.
#pragma once

#include <optional>

#include "sil/studies/faults/ecu_answer.hpp"
#include "sil/studies/faults/endurance.hpp"

namespace sil {

// A warning is due while the second ECU warns and its level may not leave the warning yet. Thereafter it
// merely holds what it has said, and an ECU that could not say it then has nothing to hold.
class SilenceWatch {
 public:
    explicit SilenceWatch(float warning_off) : warning_off_{warning_off} {}

    // `near`: a fault is there, or was within the last two seconds. True in the first cycle of a silence.
    bool cycle(const std::optional<EcuAnswer>& faulty, const EcuAnswer& right, float right_level, bool near,
               EnduranceResult& result);

 private:
    void count(EnduranceResult& result) const;

    float warning_off_;
    bool warned_{false};
    bool with_fault_{false};
    bool answered_{false};
    bool reported_{false};
    bool silent_{false};
    int silence_ms_{0};
};

}  // namespace sil
