// Model: what is behind an FMU of this project, stepped every 10 ms; it knows nothing of FMI.
#pragma once

#include <memory>
#include <string>

#include "sil/exchange/fmu/variable.hpp"

namespace fmu {

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
