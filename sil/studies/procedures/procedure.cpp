#include "sil/studies/procedures/procedure.hpp"

#include <algorithm>

namespace sil {

const char* to_string(Bound bound) {
    switch (bound) {
        case Bound::at_most:
            return "at most";
        case Bound::below:
            return "below";
        default:
            return "at least";
    }
}

bool Criterion::met() const {
    if (!measured.value) {
        return false;
    }
    switch (bound) {
        case Bound::at_most:
            return *measured.value <= limit;
        case Bound::below:
            return *measured.value < limit;
        default:
            return *measured.value >= limit;
    }
}

bool ProcedureStep::met() const {
    return std::all_of(criteria.begin(), criteria.end(),
                       [](const Criterion& criterion) { return !criterion.asked || criterion.met(); });
}

const char* to_string(ProcedureOutcome outcome) {
    switch (outcome) {
        case ProcedureOutcome::met:
            return "met";
        case ProcedureOutcome::not_met:
            return "not met";
        default:
            return "measured";
    }
}

ProcedureOutcome outcome_of(const std::vector<ProcedureStep>& steps) {
    return std::all_of(steps.begin(), steps.end(), [](const ProcedureStep& step) { return step.met(); })
               ? ProcedureOutcome::met
               : ProcedureOutcome::not_met;
}

}  // namespace sil
