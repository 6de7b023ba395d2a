// Load adaptation: the body for the rest of the component, learnt from ordinary driving.
#pragma once

#include "rsi/adaptation/load_regression.hpp"
#include "rsi/adaptation/long_stop.hpp"
#include "rsi/model/vehicle.hpp"
#include "rsi/types.hpp"

namespace rsi {

// A calibration is one of one load. Another load shows in how far the vehicle rolls (LoadRegression);
// only the vehicle's mass, if other control units send it, shows its shares of mass and height
// (load_split.hpp). It lasts through gaps and is doubted after a long stop and a restart.
class LoadAdaptation {
 public:
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters);

        SprungBody calibrated{};
        float unsprung_mass_kg{};
        float used_share{};      // of what has been learnt
        float margin{};          // of the level for each unit of the deviation
        float largest_factor{};  // of m_s H that the springs hold up
        LoadRegression::Constants regression;
    };

    // One sample; `load` is that of `motion`. Learns only from a `measured_angle`: the observer's comes from
    // the calibrated equation itself.
    void update(const Constants& constants, const Inputs& inputs, const RollMotion& motion,
                const TransferredLoad& load, bool measured_angle);

    // Forgets what driving has shown, not the mass.
    [[gnu::cold]] void reset_learnt();

    // With as much of what has been learnt as the calibration wants to be used: none leaves the calibrated
    // body.
    SprungBody body(const Constants& constants) const;

    // m_s over the calibrated one, as the vehicle's mass says and as far as it is used; 1 where it is not
    // known.
    float known_mass_factor(const Constants& constants) const {
        return 1.0F + constants.used_share * (mass_factor_ - 1.0F);
    }

    // Factor on the warning's level for the uncertainty, 1 to 1.1.
    float level_weight(const Constants& constants) const;

    // The learnt load, used or not.
    LearntLoad learnt() const { return regression_.learnt(); }
    // After a restart; `doubted`: in between the load may have changed. False where it cannot be what was
    // learnt.
    [[gnu::cold]] bool restore(const LearntLoad& learnt, bool doubted);

 private:
    void follow_mass(const Constants& constants, float vehicle_mass_kg);
    void doubt();

    float mass_factor_{1.0F};  // m_s over the calibrated one, as the vehicle's mass says
    bool mass_known_{false};
    float learnt_at_mass_factor_{1.0F};  // mass of the learnt load
    LongStop stop_{};
    LoadRegression regression_;
};

}  // namespace rsi
