// Answers of an ECU, written by hand.
#pragma once

#include "sil/studies/faults/ecu_answer.hpp"

namespace faults_test {

inline sil::EcuAnswer written_answer(sil::WarningState state, sil::WarningSide side,
                                     sil::DiagnosticCodes codes) {
    sil::EcuAnswer one;
    one.complete = true;
    one.state = state;
    one.side = side;
    one.roll_source = sil::RollSource::sensor;
    one.degradation =
        state == sil::WarningState::unavailable ? sil::Degradation::unavailable : sil::Degradation::full;
    one.codes = codes;
    return one;
}

}  // namespace faults_test
