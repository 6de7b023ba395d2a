#include "sil/faults/known_shortfall.hpp"

#include <algorithm>

namespace sil {

const std::vector<KnownShortfall>& known_shortfalls() {
    static const char* const no_plausibility = "Signals are not yet compared with each other.";
    static const std::vector<KnownShortfall> all{
        {FaultKind::frozen, {}, {}, no_plausibility},
        {FaultKind::offset, {}, {}, no_plausibility},
        {FaultKind::drift, {}, {}, no_plausibility},
        {FaultKind::noise, {}, {}, no_plausibility},
        {FaultKind::sign_flip, {}, {}, no_plausibility},
        {FaultKind::saturated, {}, {}, "The range of a signal is not yet checked but by its code."},
        {FaultKind::delayed,
         {FaultPlace::roll_angle_frame},
         {"before the turn"},
         "A constant delay leaves counter and receive time in order; only the first gap shows."},
    };
    return all;
}

bool concerns(const KnownShortfall& known, const Fault& fault, const std::string& scene) {
    const auto holds = [](const auto& list, const auto& value) {
        return list.empty() || std::find(list.begin(), list.end(), value) != list.end();
    };
    return known.kind == fault.kind && holds(known.places, fault.place) && holds(known.scenes, scene);
}

}  // namespace sil
