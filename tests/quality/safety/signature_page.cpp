// Signature page: prints the tables of firmware/rsi/ecu/monitoring/signatures.hpp, from which it is compiled,
// as a page of docs/reports/safety.
#include <array>
#include <cstddef>
#include <iostream>
#include <string>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/monitoring/signatures.hpp"

namespace {

using rsi::monitoring::Action;
using rsi::monitoring::CodeSet;
using rsi::monitoring::SensorSignal;
using rsi::monitoring::Symptom;
using rsi::monitoring::Symptoms;

constexpr auto symptom_count = static_cast<std::size_t>(Symptom::count);

struct SymptomText {
    Symptom symptom;
    const char* name;
    const char* meaning;
};

// In the order of the enumeration.
constexpr std::array<SymptomText, symptom_count> symptom_texts{{
    {Symptom::turn_valid, "turn valid", "faster than 18 km/h, with lateral acceleration, yaw rate and speed"},
    {Symptom::turn_within, "turn within",
     "lateral acceleration agrees with yaw rate times speed in this cycle"},
    {Symptom::turn_beyond_banks, "turn beyond banks",
     "they differ by more than most roads' bank, over 0.3 s"},
    {Symptom::turn_beyond_slides, "turn beyond slides", "they differ by more than any slide, over 4 s"},
    {Symptom::turn_clear, "turn clear", "turn valid, and a turn in which a wrong signal would show"},
    {Symptom::spinning, "spinning", "yaws faster than tyres can turn it, or did within a second"},
    {Symptom::lateral_sign_alone, "lateral sign alone",
     "yaw rate and roll angle show a turn to the other side"},
    {Symptom::yaw_sign_alone, "yaw sign alone",
     "lateral acceleration and roll angle show a turn to the other side"},
    {Symptom::roll_force_valid, "roll force valid",
     "the force that rolls the body is known, no wheel far up"},
    {Symptom::roll_force_within, "roll force within", "lateral acceleration agrees with it"},
    {Symptom::lateral_alone, "lateral alone", "yaw rate times speed and roll force agree against it"},
    {Symptom::lateral_suspect, "lateral suspect", "both are against it, by half as much"},
    {Symptom::gain_valid, "gain valid", "turn and roll force valid, roll angle in use"},
    {Symptom::gain_beyond, "gain beyond",
     "too weak or too strong for both, in turns to both sides or clearly"},
    {Symptom::lateral_impossible, "lateral impossible",
     "more than turn, road and sway of a slow vehicle, or, over minutes, more than is corrected"},
    {Symptom::roll_valid, "roll valid", "roll angle and roll rate for 0.2 s"},
    {Symptom::roll_beyond_short, "roll beyond, short", "they come apart within 0.2 s, and no road twists so"},
    {Symptom::roll_beyond_long, "roll beyond, long", "they come apart within 1 s, and no road twists so"},
    {Symptom::roll_angle_frozen, "roll angle frozen", "repeats its value"},
    {Symptom::roll_rate_frozen, "roll rate frozen", "repeats its value"},
    {Symptom::leans_into_turn, "leans into turn", "of a clear lateral acceleration, by the roll angle"},
    {Symptom::observer_valid, "observer valid", "roll angle of the sensor and of the observer are known"},
    {Symptom::observer_within, "observer within", "they agree clearly"},
    {Symptom::observer_beyond, "observer beyond", "the component's check contradicts a sensor in use"},
    {Symptom::observer_far, "observer far", "they differ, and the sensor is out for another reason"},
    {Symptom::vertical_within, "vertical within",
     "vertical acceleration is that of a body that does not heave"},
    {Symptom::vertical_beyond, "vertical beyond", "it is not, by a larger bound while wheels may lift"},
    {Symptom::reference_valid, "reference valid", "a clear bank under a body that hardly rolls"},
    {Symptom::reference_beyond, "reference beyond",
     "the angle has long been against what the calibration says that it is not"},
    {Symptom::load_valid, "load valid", "a received mass, and a load that minutes of driving have shown"},
    {Symptom::load_beyond, "load beyond", "the mass is not that of this load"},
}};

constexpr bool are_in_order() {
    for (std::size_t index = 0U; index < symptom_count; ++index) {
        if (static_cast<std::size_t>(symptom_texts[index].symptom) != index ||
            symptom_texts[index].name == nullptr) {
            return false;
        }
    }
    return true;
}
static_assert(are_in_order());

struct SignalText {
    SensorSignal signal;
    const char* name;
};

constexpr std::array<SignalText, 9> signal_texts{{
    {&rsi::Inputs::lateral_specific_force_mps2, "lateral acceleration"},
    {&rsi::Inputs::vertical_specific_force_mps2, "vertical acceleration"},
    {&rsi::Inputs::roll_rate_radps, "roll rate"},
    {&rsi::Inputs::roll_angle_rad, "roll angle"},
    {&rsi::Inputs::yaw_rate_radps, "yaw rate"},
    {&rsi::Inputs::speed_mps, "speed"},
    {&rsi::Inputs::steering_wheel_angle_rad, "steering wheel angle"},
    {&rsi::Inputs::bank_angle_rad, "bank angle"},
    {&rsi::Inputs::vehicle_mass_kg, "vehicle mass"},
}};

const char* name_of(SensorSignal signal) {
    for (const SignalText& each : signal_texts) {
        if (each.signal == signal) {
            return each.name;
        }
    }
    return "?";
}

std::string code_name(std::size_t number) {
    using rsi::can_dbc::RolloverDiagnosis;
    return RolloverDiagnosis::name_of(static_cast<RolloverDiagnosis::Code>(number));
}

std::string joined(const std::string& list, const std::string& next) {
    return list.empty() ? next : list + ", " + next;
}

std::string symptom_names(Symptoms symptoms) {
    std::string all;
    for (const SymptomText& each : symptom_texts) {
        if ((symptoms & rsi::monitoring::symptoms(each.symptom)) != 0U) {
            all = joined(all, each.name);
        }
    }
    return all;
}

std::string code_names(CodeSet codes) {
    std::string all;
    for (std::size_t code = 0U; code < rsi::monitoring::diagnostic_code_count; ++code) {
        if (((codes >> code) & 1U) != 0U) {
            all = joined(all, code_name(code));
        }
    }
    return all;
}

const char* name_of(rsi::monitoring::OfRoll wrong) {
    return wrong == rsi::monitoring::OfRoll::rate ? "roll rate" : "roll angle";
}

const char* name_of(Action action) {
    constexpr std::array names{"sets", "holds", "clears"};
    return names[static_cast<std::size_t>(action)];
}

void print_symptoms() {
    std::cout << "\n## Symptoms\nSymptoms of one cycle, from the residuals between sensors. The first word "
                 "is the residual.\n\n"
                 "| symptom | shown when |\n|---|---|\n";
    for (const SymptomText& each : symptom_texts) {
        std::cout << "| " << each.name << " | " << each.meaning << " |\n";
    }
}

void print_signatures() {
    std::cout
        << "\n## Signatures\n"
           "The first row of each code that fits counts; if none does, it is neither set nor cleared. "
           "*Holds*: "
           "only a code that\nis confirmed. *Clears*: only one that is active. How many cycles it takes: "
           "[safety](../../safety.md#diagnostic-codes).\n\n"
           "| code | | when | unless |\n|---|---|---|---|\n";
    for (const rsi::monitoring::Signature& each : rsi::monitoring::signatures) {
        std::cout << "| " << code_name(static_cast<std::size_t>(each.code)) << " | " << name_of(each.action)
                  << " | " << symptom_names(each.pattern.needed) << " | "
                  << symptom_names(each.pattern.excuses) << " |\n";
    }
}

void print_proofs() {
    std::cout
        << "\n## Good tests\nCycles in which the check of a code has run and found nothing, unless a "
           "row above sets the code. After as many of\nthem in a row as heal it, its test (ISO 14229-1) "
           "is completed: [trouble codes](../../in_the_vehicle.md#trouble-codes).\n\n"
           "| when | good test of |\n|---|---|\n";
    for (const rsi::monitoring::Proof& each : rsi::monitoring::proofs) {
        std::cout << "| " << symptom_names(each.needed) << " | " << code_names(each.codes) << " |\n";
    }
}

void print_roll_fault_isolation() {
    std::cout
        << "\n## Roll rate against roll angle\n"
           "Which of the two is wrong: the first row that fits, when they begin to contradict each other.\n\n"
           "| when | unless | wrong |\n|---|---|---|\n";
    for (const rsi::monitoring::RollFaultIsolation& each : rsi::monitoring::roll_fault_isolation) {
        std::cout << "| " << symptom_names(each.pattern.needed) << " | "
                  << symptom_names(each.pattern.excuses) << " | " << name_of(each.wrong) << " |\n";
    }
    std::cout << "| otherwise | | " << name_of(rsi::monitoring::otherwise_wrong) << " |\n";
}

void print_consequences() {
    std::cout
        << "\n## Consequences\n"
           "| signal | no reference for others while active | not used while confirmed |\n|---|---|---|\n";
    for (const rsi::monitoring::Consequence& each : rsi::monitoring::consequences) {
        const bool is_of_roll =
            each.signal == &rsi::Inputs::roll_rate_radps || each.signal == &rsi::Inputs::roll_angle_rad;
        std::cout << "| " << name_of(each.signal) << " | " << code_names(each.no_reference) << " | "
                  << code_names(each.not_used);
        if (is_of_roll) {
            std::cout << ", " << code_names(rsi::monitoring::roll_contradictions)
                      << " if it is the wrong one";
        }
        std::cout << " |\n";
    }
}

}  // namespace

int main() {
    std::cout
        << "<!-- Written by tests/quality/safety/trace --document from "
           "firmware/rsi/ecu/monitoring/signatures.hpp; "
           "do not edit. -->\n"
           "# Fault signatures\n\n"
           "The relations between the sensors, and the tables by which the ECU decides which of them is "
           "wrong. Bounds and reasons:\n[safety](../../safety.md#diagnostic-codes).\n";
    print_symptoms();
    print_signatures();
    print_proofs();
    print_roll_fault_isolation();
    print_consequences();
}
