// Load adaptation: estimates the sprung body (mass, CG height, inertia) under the present load from ordinary
// driving.
#pragma once

#include <cstdint>

#include "rsi/adaptation/load_bounds.hpp"
#include "rsi/adaptation/load_regression.hpp"
#include "rsi/measurement/plausible_motion.hpp"
#include "rsi/model/vehicle.hpp"
#include "rsi/numeric/bounded.hpp"
#include "rsi/numeric/saturating_count.hpp"
#include "rsi/types.hpp"

namespace rsi {

// A long stop is slower than 0.5 m/s for more than 60 s. An unavailable speed neither starts nor ends a stop.
class LongStop {
 public:
    // One sample. True once in each long stop, when its 60 s have passed.
    bool begins(float speed_mps) {
        if (!is_within_magnitude(speed_mps, largest_plausible_speed_mps)) {
            return false;
        }
        if (absolute(speed_mps) >= standing_mps) {
            samples_ = 0U;
            return false;
        }
        count_up(samples_);
        return samples_ == first_long_sample;
    }

    bool is_standing() const { return samples_ > 0U; }

 private:
    static constexpr float standing_mps = 0.5F;
    static constexpr float long_stop_s = 60.0F;
    static constexpr std::uint32_t first_long_sample =
        1U + static_cast<std::uint32_t>(long_stop_s / sample_time_s);

    std::uint32_t samples_{0U};
};

// A calibration describes one load. The roll response shows by how much another load changes the product m_s
// H (sprung mass times roll arm, LoadRegression). Its split into mass and height needs the vehicle's mass, if
// another control unit sends it (load_split.hpp), and driving has to confirm that mass. The estimate is kept
// over gaps in the inputs; its variance is raised after a long stop and after power-on, because the load may
// have changed.
class LoadAdaptation {
 public:
    struct Constants {
        Constants() = default;
        [[gnu::cold]] explicit Constants(const Parameters& parameters);

        SprungBody calibrated{};
        float moment_arm_inverse{};  // 1 / (m_s H) as calibrated
        float unsprung_mass_kg{};
        float used_share{};             // of the learnt load, 0 to 1: parameter load_adaptation
        float margin{};                 // of the warning level, per unit of excess_deviation()
        float largest_moment_factor{};  // of m_s H: beyond it the calibrated roll stiffness is too low
        LoadRegression::Constants regression;
    };

    // One sample. `load`: load transfer of the same sample as `motion`. `measured_angle`: the roll angle is
    // the sensor's; nothing is learnt from the observer's, which follows from the calibrated equation itself.
    void update(const Constants& constants, const Inputs& inputs, const RollMotion& motion,
                const TransferredLoad& load, bool measured_angle);

    // Discards the learnt load; keeps the received mass.
    [[gnu::cold]] void reset_learnt();

    // The calibrated body, corrected by used_share of the learnt load.
    SprungBody body(const Constants& constants) const;

    // Sprung mass over the calibrated one, from the received vehicle mass, weighted by used_share; 1 if none
    // was received, or if driving refutes it.
    float known_mass_factor(const Constants& constants) const {
        return 1.0F + constants.used_share * accepted_mass_change();
    }

    // By how much the roll angle may be larger than the calibrated body's before it is taken for wrong: with
    // the known mass, or with the used load up to largest_taught_load. `moment_arm_kgm`: m_s H of body().
    float roll_factor(const Constants& constants, float moment_arm_kgm) const {
        return larger(known_mass_factor(constants),
                      smaller(constants.moment_arm_inverse * moment_arm_kgm, 1.0F + largest_taught_load));
    }

    // Factor on the warning level for the uncertainty of the load, 1 to 1.1.
    float level_weight(const Constants& constants) const;

    // The learnt load, regardless of used_share.
    LearntLoad learnt() const { return regression_.learnt(); }
    // Restores a load learnt before a restart. `doubted`: the load may have changed since, so the variance is
    // raised. False, with nothing restored, for values out of range.
    [[gnu::cold]] bool restore(const LearntLoad& learnt, bool doubted);

 private:
    void follow_mass(const Constants& constants, float vehicle_mass_kg);
    void doubt();
    [[gnu::noinline]] void weigh_mass();
    float accepted_mass_change() const { return mass_is_used_ ? mass_factor_ - 1.0F : 0.0F; }

    float mass_factor_{1.0F};  // sprung mass over the calibrated one, from the received vehicle mass
    bool mass_known_{false};
    float learnt_at_mass_factor_{1.0F};  // mass_factor_ to which the learnt load belongs
    // The used part of both for body(), as of the last sample.
    float used_mass_change_{0.0F};
    float used_excess_{0.0F};
    bool mass_is_used_{false};
    LongStop stop_{};
    LoadRegression regression_;
};

}  // namespace rsi
