// Intervention: what a stability function, or the driver himself, does while a warning is in force.
#pragma once

#include <cstdint>
#include <deque>

#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

enum class InterventionKind : std::uint8_t {
    brake,   // a stability function releases the throttle and brakes all wheels
    driver,  // the driver releases the throttle and turns the handwheel back
};

struct Intervention {
    InterventionKind kind{InterventionKind::brake};
    double delay_s{
        0.0};  // from the demand to the first effect, and from its end to the first decay; 0 or more
    double ramp_s{0.0};  // from no effect to all of it, and back; 0: at once
    // `brake`: deceleration of the vehicle, above 0, that the brakes would give on a straight, level road.
    // Without an anti-lock system: a wheel that carries too little for its share locks.
    double deceleration_mps2{0.0};
    double steer_back_share{0.0};  // `driver`: of the handwheel angle, 0 to 1 (straight ahead)
};

// As the study of prevention has it (sil/studies/prevention).
inline constexpr Intervention stability_function{InterventionKind::brake, 0.1, 0.2, 4.0, 0.0};

// Effect of an intervention on one run.
class InterventionEffect {
 public:
    InterventionEffect(const Intervention& intervention, const VehicleParameters& vehicle);

    // Whether it is demanded from this time on. To be called in the order of time.
    void demand(bool wanted, double time_s);

    // The command with the effect at this time. To be called once a step, in the order of time.
    DriverCommand changed(DriverCommand command, double time_s);

    double effect() const { return effect_; }       // of the latest step, 0 to 1
    unsigned times() const { return times_; }       // how often it has begun
    double duration_s() const { return acted_s_; }  // for how long there was any effect

 private:
    struct Demand {
        bool wanted;
        double time_s;
    };

    Intervention intervention_;
    double whole_brake_;          // 0 to 1, of the whole effect
    std::deque<Demand> ahead_{};  // changes of the demand whose delay is not over
    bool demanded_{false};
    bool acts_{false};
    double effect_{0.0};
    double last_s_{0.0};
    unsigned times_{0U};
    double acted_s_{0.0};
};

}  // namespace sil
