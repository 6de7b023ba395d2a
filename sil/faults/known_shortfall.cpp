#include "sil/faults/known_shortfall.hpp"

#include <algorithm>

namespace sil {

const std::vector<KnownShortfall>& known_shortfalls() {
    static const std::vector<KnownShortfall> all{};  // there is none
    return all;
}

bool concerns(const KnownShortfall& known, const Fault& fault, const std::string& scene) {
    const auto holds = [](const auto& list, const auto& value) {
        return list.empty() || std::find(list.begin(), list.end(), value) != list.end();
    };
    return known.kind == fault.kind && holds(known.places, fault.place) && holds(known.scenes, scene);
}

}  // namespace sil
