// Mass check: the received vehicle mass against what is plausible for the calibration, against the mass
// before and against the load that driving has shown.
#pragma once

#include "rsi/adaptation/load_bounds.hpp"
#include "rsi/adaptation/load_split.hpp"
#include "rsi/ecu/monitoring/diagnostic_memory.hpp"
#include "rsi/ecu/monitoring/symptom.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/types.hpp"

namespace rsi::monitoring {

class MassCheck {
 public:
    // Keeps the mass that it knows: a stall loads no vehicle.
    void start(const rsi::Parameters& parameters) noexcept {
        unsprung_mass_kg_ = parameters.unsprung_mass_kg;
        sprung_mass_kg_ = parameters.sprung_mass_kg;
    }

    // One cycle; NaN where there is no mass to use. A mass that is not available is no fault, and without
    // parameters there is no judgement. One that is another than at the last stop is not used: a load comes
    // at a stop.
    float qualify(float mass_kg, float speed_mps, DiagnosticMemory& memory) noexcept {
        by_mass_ = rsi::not_available;
        if (!rsi::is_finite(mass_kg) || (sprung_mass_kg_ <= 0.0F)) {
            return rsi::not_available;
        }
        const float by_mass = (mass_kg - unsprung_mass_kg_) / sprung_mass_kg_ - 1.0F;
        const bool valid =
            rsi::is_within(by_mass, rsi::least_mass_factor - 1.0F, rsi::largest_mass_factor - 1.0F);
        memory.report(DiagnosticCode::vehicle_mass_invalid, !valid);
        memory.add_tested(set_of(DiagnosticCode::vehicle_mass_invalid));
        if (!valid) {
            return rsi::not_available;
        }
        const bool stands = rsi::is_within_magnitude(speed_mps, standing_mps);
        if (stands || !known_) {
            loaded_mass_kg_ = mass_kg;
            known_ = true;
        }
        const bool changes =
            !rsi::is_within_magnitude(mass_kg - loaded_mass_kg_, largest_change * sprung_mass_kg_);
        memory.report(DiagnosticCode::vehicle_mass_jump, changes);
        memory.add_tested(set_of(DiagnosticCode::vehicle_mass_jump));
        if (changes) {
            return rsi::not_available;
        }
        by_mass_ = by_mass;
        return mass_kg;
    }

    // The mass of this cycle against the load as the component knew it a cycle before; nothing while that is
    // not sure.
    Symptoms symptoms_with(const rsi::Outputs& before) const noexcept {
        const bool known =
            rsi::is_finite(by_mass_) && (before.load_excess_deviation < rsi::sure_load_deviation);
        return symptom_if(known, Symptom::load_valid) |
               symptom_if(
                   known && rsi::contradicts_load(by_mass_, before.load_excess, before.load_excess_deviation),
                   Symptom::load_beyond);
    }

 private:
    static constexpr float standing_mps = 0.5F;
    static constexpr float largest_change = 0.05F;  // of the sprung mass

    float unsprung_mass_kg_{0.0F};
    float sprung_mass_kg_{0.0F};
    float by_mass_{rsi::not_available};  // change of the sprung mass, as a share; NaN: none to judge
    float loaded_mass_kg_{0.0F};         // at the last stop, or the first one
    bool known_{false};
};

}  // namespace rsi::monitoring
