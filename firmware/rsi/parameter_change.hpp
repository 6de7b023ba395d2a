// Parameter change: other parameters for a component that is running, prepared over as many cycles as it
// takes.
#pragma once

#include "rsi/measurement/roll_bank_observer.hpp"
#include "rsi/types.hpp"

namespace rsi {

class ParameterChange {
 public:
    // From the parameters in use, `from`, to others. Accepts, or names the first field that is refused and
    // why; then there is nothing to prepare.
    [[gnu::cold]] Validation begin(const Parameters& from, const Parameters& to);

    // One cycle's share of the work, less than a step. True when the component may go on with it, which most
    // changes are at once: what is found by iterating is that of the vehicle.
    [[gnu::cold]] bool prepare();

    const Parameters& parameters() const { return to_; }

    // Whether they describe another vehicle: its masses, lengths, springs or dampers.
    bool is_another_vehicle() const { return is_another_vehicle_; }

    // Whether they describe other sensors: their noise, their resolution, or what the vehicle has.
    bool has_other_sensors() const { return has_other_sensors_; }

    // Whether the published estimator uses other units.
    bool has_other_units() const { return has_other_units_; }

    // Whether the observer settles to other gains.
    bool has_gains() const { return has_gains_; }
    const ObserverGains& gains() const { return search_.gains(); }

 private:
    Parameters to_{};
    bool is_another_vehicle_{false};
    bool has_other_sensors_{false};
    bool has_other_units_{false};
    bool has_gains_{false};
    ObserverGainsSearch search_{};
};

}  // namespace rsi
