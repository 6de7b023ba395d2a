// Index component: every index as the firmware would compute it if that index drove the warning.
#pragma once

#include "rsi/component.hpp"

namespace sil {

// The firmware computes the paper's other indices in every second sample and holds them in between, unless
// one of them drives the warning. A held peak counts twice and would pass the confirmation of a warning
// alone, so who compares indices looks at this component, in which each is new in every sample, and not at
// the one that drives. The outputs have nothing to say of the warning.
class IndexComponent {
 public:
    // Throws std::invalid_argument with the field's name when the parameters are refused.
    explicit IndexComponent(const rsi::Parameters& parameters);

    // One sample of 10 ms, with what the driving component was given. The reference holds for the object's
    // life.
    const rsi::Outputs& step(const rsi::Inputs& inputs) {
        component_.step(inputs, outputs_);
        return outputs_;
    }

 private:
    rsi::Component component_{};
    rsi::Outputs outputs_{};
};

}  // namespace sil
