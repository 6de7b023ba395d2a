// ECU model: the component between physical signals, without CAN.
#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>

#include "rsi/parameters.hpp"
#include "rsi/rsi.h"
#include "rsi/rsi_outputs.h"
#include "sil/exchange/fmu/model.hpp"
#include "sil/exchange/fmu/sentence.hpp"
#include "sil/exchange/fmu/start_values.hpp"
#include "sil/simulation/component_inputs.hpp"

namespace fmu {
namespace {

Variable row(const char* name, Role role, Kind kind, const std::string& meaning) {
    Variable variable;
    variable.name = name;
    variable.role = role;
    variable.kind = kind;
    variable.meaning = meaning;
    return variable;
}

void add_parameters(Variables& table) {
    const double* start = start_values;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        Variable variable = row(field.name, Role::parameter, Kind::number, "");
        variable.start = *start++;
        variable.least = as_written(field.minimum);
        variable.largest = as_written(field.maximum);
        table.push_back(variable);
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        Variable variable = row(field.name, Role::parameter, Kind::choice, "");
        variable.start = *start++;
        variable.choices.assign(field.choices, field.choices + field.choice_count);
        variable.largest = static_cast<double>(field.choice_count - 1);
        table.push_back(variable);
    }
}

void add_inputs(Variables& table) {
    for (const sil::ComponentInput& input : sil::component_inputs) {
        Variable variable = row(input.name, Role::input, Kind::number,
                                std::string{input.meaning} + "; no number: not available");
        variable.start = std::numeric_limits<double>::quiet_NaN();
        variable.may_be_missing = true;
        table.push_back(variable);
    }
}

struct CodeWords {
    const char* name;
    std::vector<std::string> (*choices)();
};

// Codes with more than no and yes, in the words of their enumerations in rsi.h.
constexpr CodeWords code_words[] = {
    {"state", [] { return std::vector<std::string>{"unavailable", "ready", "advisory", "warning"}; }},
    {"side", [] { return std::vector<std::string>{"none", "left", "right"}; }},
    {"roll_source", [] { return std::vector<std::string>{"none", "sensor", "observer"}; }},
};

// In the order of rsi_outputs.h.
void add_outputs(Variables& table) {
    const auto code = [&table](const char* name, double reset, double largest, const char* meaning) {
        const auto* const words =
            std::find_if(std::begin(code_words), std::end(code_words),
                         [name](const CodeWords& each) { return each.name == std::string{name}; });
        const bool is_choice = words != std::end(code_words);
        Variable variable = row(name, Role::output, is_choice ? Kind::choice : Kind::boolean, meaning);
        if (is_choice) {
            variable.choices = words->choices();
        }
        variable.start = reset;
        variable.largest = largest;
        table.push_back(variable);
    };
    const auto number = [&table](const char* name, const char* unit, const char* meaning) {
        Variable variable = row(name, Role::output, Kind::number, meaning);
        variable.start = std::numeric_limits<double>::quiet_NaN();
        variable.may_be_missing = true;
        variable.unit = unit;
        table.push_back(variable);
    };
#define RSI_CODE(name, reset, largest, risk, meaning) code(#name, reset, largest, meaning);
#define RSI_NUMBER(name, unit, mirror, presence, risk, meaning) number(#name, unit, meaning);
#define RSI_INDEX(name, unit, mirror, CHOICE, number_, choice, scale, side, meaning) \
    number(#name, unit, meaning);
    RSI_OUTPUTS(RSI_CODE, RSI_NUMBER, RSI_INDEX)
#undef RSI_INDEX
#undef RSI_NUMBER
#undef RSI_CODE
}

Variables make_table() {
    Variables table{row("time", Role::time, Kind::number, "simulated time")};
    add_parameters(table);
    add_inputs(table);
    add_outputs(table);
    return table;
}

class EcuModel final : public Model {
 public:
    EcuModel() {
        const rsi_parameters refused{};
        rsi_init(&component_, &refused);
    }

    const Variables& variables() const override { return *table_; }

    Complaint start(Values& values) override {
        std::size_t place = 1U;
        rsi_parameters parameters{};
        for (const rsi::ParameterField& field : rsi::parameter_fields) {
            parameters.*field.member = static_cast<float>(values.numbers[place++]);
        }
        for (const rsi::SelectionField& field : rsi::selection_fields) {
            parameters.*field.member = static_cast<std::int32_t>(values.numbers[place++]);
        }
        const rsi_validation answer = rsi_init(&component_, &parameters);
        if (answer.accepted == 0) {
            return std::string{"parameter "} + answer.field + " " + answer.reason + "; change one of them";
        }
        return {};
    }

    Complaint cycle(Values& values) override {
        std::size_t place = 1U + rsi::parameter_fields.size() + rsi::selection_fields.size();
        rsi_inputs sample{};
        for (const sil::ComponentInput& input : sil::component_inputs) {
            sample.*input.input = static_cast<float>(values.numbers[place++]);
        }
        rsi_outputs answer{};
        rsi_step(&component_, &sample, &answer);
#define RSI_VALUE(name, ...) values.numbers[place++] = static_cast<double>(answer.name);
        RSI_OUTPUTS(RSI_VALUE, RSI_VALUE, RSI_VALUE)
#undef RSI_VALUE
        return {};
    }

    std::unique_ptr<Model> copy() const override { return std::make_unique<EcuModel>(*this); }

    std::string to_bytes() const override {
        return {component_.bytes, component_.bytes + sizeof component_.bytes};
    }

    bool from_bytes(const std::string& bytes) override {
        if (bytes.size() != sizeof component_.bytes) {
            return false;
        }
        std::memcpy(component_.bytes, bytes.data(), bytes.size());
        return true;
    }

 private:
    std::shared_ptr<const Variables> table_{std::make_shared<Variables>(make_table())};
    rsi_component component_{};
};

}  // namespace

std::unique_ptr<Model> make_model() {
    return std::make_unique<EcuModel>();
}

}  // namespace fmu
