// Variables: what an FMU shows of a model, one row each, and the values that it holds of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fmu {

// number: Float64, or Real; integer: Int32; boolean: Boolean; text: String; choice: Enumeration, the position
// in `choices`.
enum class Kind : unsigned char { number, integer, boolean, text, choice };

// A parameter is fixed: it is set before initialisation ends.
enum class Role : unsigned char { time, parameter, input, output };

struct Variable {
    std::string name{};
    Role role{Role::output};
    Kind kind{Kind::number};
    double start{0.0};
    // Both admitted; the same where there is no range. A number is finite unless `may_be_missing`.
    double least{0.0};
    double largest{0.0};
    bool may_be_missing{false};
    std::string start_text{};
    std::vector<std::string> choices{};
    std::string unit{};  // empty: the name ends in it, or there is none
    std::string meaning{};

    bool has_range() const { return least < largest; }
};

// The position in the table is FMI's value reference; the first row is the time.
using Variables = std::vector<Variable>;

// By the same positions. `numbers` has all but the texts: whole numbers, and 0 or 1, as such.
struct Values {
    explicit Values(const Variables& variables) {
        for (const Variable& each : variables) {
            numbers.push_back(each.start);
            texts.push_back(each.start_text);
        }
    }

    std::vector<double> numbers{};
    std::vector<std::string> texts{};
};

}  // namespace fmu
