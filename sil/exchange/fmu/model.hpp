// Model: what is behind an FMU of this project, stepped every 10 ms, and the variables that it shows, one row
// each; it knows nothing of FMI.
#pragma once

#include <cstddef>
#include <memory>
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

inline constexpr double cycle_s = 0.01;

// Empty: nothing is wrong. Else a sentence: what, where, and what to do.
using Complaint = std::string;

class Model {
 public:
    Model() = default;
    Model& operator=(const Model&) = delete;
    virtual ~Model() = default;

    virtual const Variables& variables() const = 0;

    // Begins anew with the parameters among `values` and writes the outputs of the first instant. May be
    // called again.
    virtual Complaint start(Values& values) = 0;

    // One cycle under the inputs among `values`; writes the outputs at its end.
    virtual Complaint cycle(Values& values) = 0;

    // All of it as it is now.
    virtual std::unique_ptr<Model> copy() const = 0;

    // The same as bytes, for a process with the same FMU; empty if a model cannot be serialised.
    virtual std::string to_bytes() const { return {}; }
    // False, and nothing has changed, where these are no bytes of to_bytes().
    virtual bool from_bytes(const std::string& /*bytes*/) { return false; }

 protected:
    Model(const Model&) = default;
};

// The model of this FMU.
std::unique_ptr<Model> make_model();

}  // namespace fmu
