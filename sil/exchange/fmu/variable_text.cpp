// Variable text: the table of variables for the script that packs the FMU, so that modelDescription.xml is
// made of the binary beside it.
#include <cstdio>
#include <memory>
#include <string>

#include "sil/exchange/fmu/model.hpp"

namespace {

std::string exact(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

// One line a row, fields between tabs: role, kind, name, start, least, largest, may be missing, unit, choices
// between commas, meaning.
std::string line_of(const fmu::Variable& variable) {
    constexpr const char* roles[] = {"time", "parameter", "input", "output"};
    constexpr const char* kinds[] = {"number", "integer", "boolean", "text", "choice"};
    std::string choices;
    for (const std::string& choice : variable.choices) {
        choices += (choices.empty() ? "" : ",") + choice;
    }
    std::string line;
    for (const std::string& field :
         {std::string{roles[static_cast<std::size_t>(variable.role)]},
          std::string{kinds[static_cast<std::size_t>(variable.kind)]}, variable.name,
          variable.kind == fmu::Kind::text ? variable.start_text : exact(variable.start),
          exact(variable.least), exact(variable.largest), std::string{variable.may_be_missing ? "1" : "0"},
          variable.unit, choices, variable.meaning}) {
        line += (line.empty() ? "" : "\t") + field;
    }
    return line + "\n";
}

}  // namespace

// Hands the text to `take`.
extern "C" __attribute__((visibility("default"))) void rsi_fmu_variables(void (*take)(const char*)) {
    const std::unique_ptr<fmu::Model> model = fmu::make_model();
    std::string text;
    for (const fmu::Variable& variable : model->variables()) {
        text += line_of(variable);
    }
    take(text.c_str());
}
