#include "sil/live/live_faults.hpp"

#include <nlohmann/json.hpp>

#include "sil/input_error.hpp"
#include "sil/studies/faults/sensor_signal.hpp"

namespace sil {
namespace {

std::vector<LiveFaults> make_live_faults() {
    std::vector<LiveFaults> all;
    for (const SensorSignal& signal : sensor_signals) {
        LiveFaults faults{signal.place, {}};
        for (const std::vector<Fault>* list : {&all_faults(), &further_faults()}) {
            for (const Fault& fault : *list) {
                if (fault.place == signal.place && is_signal_fault(fault.kind)) {
                    faults.kinds.push_back(fault);
                }
            }
        }
        all.push_back(faults);
    }
    return all;
}

}  // namespace

const std::vector<LiveFaults>& live_faults() {
    static const std::vector<LiveFaults> all = make_live_faults();
    return all;
}

std::optional<Fault> chosen_fault(const FaultChoice& choice) {
    if (choice.place < 0) {
        return std::nullopt;
    }
    const auto place = static_cast<std::size_t>(choice.place);
    const auto kind = static_cast<std::size_t>(choice.kind);
    if (choice.kind < 0 || place >= live_faults().size() || kind >= live_faults()[place].kinds.size()) {
        throw InputError("The page asked for a fault that is not in the list; reload it");
    }
    return live_faults()[place].kinds[kind];
}

std::string fault_text(const std::optional<Fault>& fault) {
    return fault ? std::string{to_string(fault->place)} + ": " + describe(*fault) : std::string{};
}

std::string live_faults_json() {
    nlohmann::json json = nlohmann::json::array();
    for (const LiveFaults& faults : live_faults()) {
        nlohmann::json kinds = nlohmann::json::array();
        for (const Fault& fault : faults.kinds) {
            kinds.push_back(describe(fault));
        }
        json.push_back({{"place", to_string(faults.place)}, {"kinds", kinds}});
    }
    return json.dump();
}

}  // namespace sil
