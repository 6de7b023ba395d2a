#include "sil/live/live_request.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "sil/input_error.hpp"
#include "sil/studies/faults/sensor_signal.hpp"

namespace sil {
namespace {

std::vector<LiveFaults> make_live_faults() {
    std::vector<LiveFaults> all;
    for (const SensorSignal& signal : sensor_signals) {
        if (signal.place == FaultPlace::bank_angle) {
            continue;  // no live vehicle has that sensor
        }
        LiveFaults faults{signal.place, {}};
        for (const std::vector<Fault>* list : {&all_faults(), &further_faults()}) {
            for (const Fault& fault : *list) {
                if (fault.place == signal.place && is_signal_fault(fault.kind) &&
                    fault.kind != FaultKind::out_of_range) {  // which is a code of a frame
                    faults.kinds.push_back(fault);
                }
            }
        }
        all.push_back(faults);
    }
    return all;
}

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& why) {
    throw InputError("The page asked for something that is not understood: " + why);
}

double number(const Json& value, const std::string& key, double least, double most) {
    if (!value.is_number()) {
        refuse(key + " wants a number");
    }
    const double found = value.get<double>();
    if (!(found >= least && found <= most)) {
        refuse(fmt::format("{} wants a number from {} to {}", key, least, most));
    }
    return found;
}

bool truth_value(const Json& value, const std::string& key) {
    if (!value.is_boolean()) {
        refuse(key + " wants true or false");
    }
    return value.get<bool>();
}

FaultChoice choice(const Json& value) {
    if (value.is_null()) {
        return {-1, 0};
    }
    if (!value.is_object() || value.size() != 2U || !value.contains("place") || !value.contains("kind") ||
        !value["place"].is_number_unsigned() || !value["kind"].is_number_unsigned()) {
        refuse("fault wants null, or place and kind as whole numbers");
    }
    return {static_cast<int>(number(value["place"], "place", 0.0, 1.0e3)),
            static_cast<int>(number(value["kind"], "kind", 0.0, 1.0e3))};
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

LiveRequest parse_live_request(std::string_view text) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) {
        refuse("it is no JSON object");
    }
    LiveRequest request;
    for (const auto& [key, value] : json.items()) {
        if (key == "steering_deg") {
            request.steering_deg = number(value, key, -360.0, 360.0);
        } else if (key == "speed_kmh") {
            request.speed_kmh = number(value, key, 10.0, 160.0);
        } else if (key == "load_kg") {
            request.load_kg = number(value, key, 0.0, heaviest_roof_load_kg);
        } else if (key == "pause") {
            request.pause = truth_value(value, key);
        } else if (key == "brake_on_warning") {
            request.brake_on_warning = truth_value(value, key);
        } else if (key == "again") {
            request.again = truth_value(value, key);
        } else if (key == "fault") {
            request.fault = choice(value);
        } else {
            refuse("it has a key of another name than those that there are");
        }
    }
    return request;
}

}  // namespace sil
