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

const char* to_string(Outcome outcome) {
    switch (outcome) {
        case Outcome::met:
            return "met";
        case Outcome::not_met:
            return "not met";
        default:
            return "measured";
    }
}

Outcome outcome_of(const std::vector<ProcedureStep>& steps) {
    return std::all_of(steps.begin(), steps.end(), [](const ProcedureStep& step) { return step.met(); })
               ? Outcome::met
               : Outcome::not_met;
}

}  // namespace sil
