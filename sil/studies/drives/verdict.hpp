// Verdict: what a replayed drive says about the warning, in a word.
#pragma once

#include "sil/studies/drives/drive_replay.hpp"

namespace sil {

enum class Verdict : unsigned char {
    ahead,            // two wheels lifted; a warning of the side that falls was in force
    wrong_side,       // two wheels lifted; the warning in force named the other side
    late,             // two wheels lifted; the right warning came after
    missed,           // two wheels lifted without a warning, or after one that came and went
    one_wheel_alarm,  // a wheel lifted, but not two of a side; there was a warning
    near_alarm,       // no wheel lifted, but the largest |LTR| reached 0.9; there was a warning
    false_alarm,      // no wheel lifted; there was a warning, and |LTR| is below 0.9 or not known. Or whether
                      // wheels lifted is not known, and about a warning |LTR| cannot have reached 0.7
    unavailable,      // no two wheels lifted (or not known) and no warning; for some time there could be none
    quiet,            // no two wheels lifted and no warning
    warning,          // there was a warning; whether wheels lifted is not known, and one can have
    no_warning        // there was none; whether wheels lifted is not known
};

Verdict verdict(const DriveReplay& replay);

// Whether no wheel can have lifted about it, as far as the accelerometers show.
bool cannot_lift(const ReplayWarning& warning);

// "ahead", "late", "missed", "one-wheel alarm", ...
const char* to_string(Verdict verdict);

}  // namespace sil
