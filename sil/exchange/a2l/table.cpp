// a2l-table: what an A2L needs to know of the firmware, from the firmware's own tables. Lines of fields that
// are separated by tabs:
//   constant   NAME VALUE
//   parameter  NAME ADDRESS LEAST LARGEST CHOICES         choices separated by commas; empty: a float
//   output     NAME ADDRESS LARGEST UNIT MEANING          largest of a code; empty: a float
//   input      NAME ADDRESS UNIT
//   code       NAME ADDRESS MASK MEANING                  a bit of a byte
#include <fmt/format.h>

#include <cstring>
#include <string>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/application/calibration_epk.hpp"
#include "rsi/ecu/application/calibration_pages.hpp"
#include "rsi/ecu/diagnosis/data_identifiers.hpp"
#include "rsi/ecu/monitoring/diagnostic_memory.hpp"
#include "rsi/ecu/xcp/daq.hpp"
#include "rsi/ecu/xcp/identifiers.hpp"
#include "rsi/parameters.hpp"
#include "rsi/rsi_outputs.h"

namespace {

namespace map = rsi::application::calibration_map;

template <typename Value>
void constant(const char* name, Value value) {
    fmt::print("constant\t{}\t{}\n", name, value);
}

void constants() {
    const auto* const letters =
        static_cast<const char*>(static_cast<const void*>(rsi::application::calibration_epk.data()));
    constant("epk", std::string{letters, ::strnlen(letters, rsi::application::calibration_epk.size())});
    constant("epk_at", map::epk_at);
    constant("parameters_at", map::parameters_at);
    constant("parameters_length", map::parameters_length);
    constant("change_at", map::change_at);
    constant("command_identifier", rsi::xcp::default_identifiers.command);
    constant("answer_identifier", rsi::xcp::default_identifiers.answer);
    constant("most_lists", rsi::xcp::most_lists);
    constant("most_parts", rsi::xcp::most_parts);
    constant("largest_entry", rsi::xcp::largest_entry);
    constant("packet_length", rsi::xcp::packet_length);
}

void parameters() {
    std::uint32_t address = map::parameters_at;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        fmt::print("parameter\t{}\t{}\t{}\t{}\t\n", field.name, address, field.minimum, field.maximum);
        address += 4U;
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        std::string choices;
        for (std::int32_t choice = 0; choice < field.choice_count; ++choice) {
            choices += (choice == 0 ? "" : ",") + std::string{field.choices[choice]};
        }
        fmt::print("parameter\t{}\t{}\t0\t{}\t{}\n", field.name, address, field.choice_count - 1, choices);
        address += 4U;
    }
}

void outputs() {
    const rsi::Outputs all{};
    const auto address_of = [&all](const void* member) {
        return map::outputs_at +
               static_cast<std::uint32_t>(static_cast<const char*>(member) -
                                          static_cast<const char*>(static_cast<const void*>(&all)));
    };
#define RSI_CODE(name, reset, largest, risk, meaning)                                                 \
    fmt::print("output\t{}\t{}\t{}\t\t{}\n", #name, address_of(&all.name), static_cast<int>(largest), \
               meaning);
#define RSI_NUMBER(name, unit, mirror, presence, risk, meaning) \
    fmt::print("output\t{}\t{}\t\t{}\t{}\n", #name, address_of(&all.name), unit, meaning);
#define RSI_INDEX(name, unit, mirror, CHOICE, number, choice, scale, side, meaning) \
    RSI_NUMBER(name, unit, mirror, always, detail, meaning)
    RSI_OUTPUTS(RSI_CODE, RSI_NUMBER, RSI_INDEX)
#undef RSI_INDEX
#undef RSI_NUMBER
#undef RSI_CODE
}

void inputs() {
    const rsi::Inputs all{};
    const auto* const begin = static_cast<const char*>(static_cast<const void*>(&all));
    for (const rsi::diagnosis::InputValue& each : rsi::diagnosis::input_values) {
        const auto* const at = static_cast<const char*>(static_cast<const void*>(&(all.*each.member)));
        fmt::print("input\t{}\t{}\t{}\n", each.name, map::inputs_at + static_cast<std::uint32_t>(at - begin),
                   each.unit);
    }
}

void codes(const char* prefix, std::uint32_t at, const char* meaning) {
    using Diagnosis = rsi::can_dbc::RolloverDiagnosis;
    for (std::uint32_t number = 1U; number < rsi::monitoring::diagnostic_code_count; ++number) {
        const char* const name = Diagnosis::name_of(static_cast<Diagnosis::Code>(number));
        fmt::print("code\t{}{}\t{}\t{}\t{}\n", prefix, name, at + number / 8U, 1U << (number % 8U), meaning);
    }
}

}  // namespace

int main() {
    constants();
    parameters();
    outputs();
    inputs();
    codes("code_", map::codes_at, "the monitoring has set or confirmed this diagnostic code");
    codes("confirmed_", map::codes_at + sizeof(rsi::monitoring::CodeSet),
          "the monitoring has confirmed this diagnostic code, which is not healed yet");
}
