// Judge of the component's outputs: what must hold whatever the inputs are.
#pragma once

#include <cmath>

#include "tests/quality/fuzz/support/input_fields.hpp"
#include "tests/quality/fuzz/support/require.hpp"
#include "tests/rsi/support/output_fields.hpp"

namespace fuzz {

// Requirements on the outputs at each step, given the inputs so far.
class ComponentJudge {
 public:
    ComponentJudge(const rsi_parameters& parameters, bool accepted)
        : parameters_{parameters}, accepted_{accepted} {}

    void judge(const rsi_inputs& inputs, const rsi_outputs& outputs) {
        follow(inputs);
        require(outputs.state <= RSI_STATE_WARNING, "the state is one of four");
        require(outputs.side <= RSI_SIDE_RIGHT, "the side is one of three");
        require(outputs.roll_source <= RSI_ROLL_OBSERVER, "the roll angle has one of three sources");
        require((outputs.roll_sensor_disagrees | outputs.estimate_frozen | 1) == 1, "a flag is 0 or 1");
        require((outputs.state >= RSI_STATE_ADVISORY) || (outputs.side == RSI_SIDE_NONE),
                "only a risk has a side");
        if (outputs.state == RSI_STATE_UNAVAILABLE) {
            steps_at_warning_level_ = 0;
        }
        if (!possible_) {
            require(outputs.state == RSI_STATE_UNAVAILABLE, "unavailable without what is necessary");
            require(rsi_test::all_not_available(outputs), "no number without what is necessary");
            return;
        }
        if (outputs.state == RSI_STATE_UNAVAILABLE && rsi_test::all_not_available(outputs)) {
            return;
        }
        require(rsi_test::all_finite(outputs), "every number is finite");
        judge_optional(outputs);
        judge_ranges(outputs);
        judge_state(outputs);
    }

 private:
    void follow(const rsi_inputs& inputs) {
        const bool necessary = is_available(inputs.lateral_specific_force_mps2, 60.0F) &&
                               is_available(inputs.roll_rate_radps, 10.0F);
        const bool observable =
            is_available(inputs.yaw_rate_radps, 10.0F) && is_available(inputs.speed_mps, 150.0F);
        possible_ = accepted_ && necessary && (is_available(inputs.roll_angle_rad, 2.2F) || observable);
        possible_steps_ = possible_ ? possible_steps_ + 1 : 0;
    }

    static void judge_optional(const rsi_outputs& outputs) {
        for (const rsi::NumberOutput& field : rsi::number_outputs) {
            require(!std::isinf(outputs.*field.member), "no number is infinite");
        }
    }

    static bool within(float value, float lowest, float highest) {
        return std::isnan(value) || (value >= lowest && value <= highest);
    }

    void judge_ranges(const rsi_outputs& outputs) const {
        require(within(outputs.warning_level, 0.0F, 20.0F), "warning_level is 0 to 20");
        require(within(outputs.rsi, 0.0F, 1.0F), "rsi is 0 to 1");
        require(within(outputs.rsi_bank_free, 0.0F, 20.0F), "rsi_bank_free is 0 to 20");
        require(within(outputs.rsi_extended, 0.0F, 20.0F), "rsi_extended is 0 to 20");
        require(within(outputs.load_transfer_ratio, -20.0F, 20.0F), "load_transfer_ratio is -20 to 20");
        require(within(outputs.predicted_load_transfer_ratio, -20.0F, 20.0F),
                "predicted_load_transfer_ratio is -20 to 20");
        require(within(outputs.time_to_rollover_s, 0.0F, 10.0F), "time_to_rollover_s is 0 to 10");
        require(outputs.road_normal_force_mps2 > 0.9F, "the normal force never comes near zero");
        require(outputs.lateral_acceleration_threshold_mps2 != 0.0F, "the threshold is never zero");
        if (parameters_.estimator == RSI_ESTIMATOR_CONSIDER_KALMAN) {
            require(std::fabs(outputs.roll_centre_vertical_m) <= parameters_.roll_centre_limit_m,
                    "the roll centre's movement stays within its limit");
        }
    }

    void judge_state(const rsi_outputs& outputs) {
        const int recovery_steps = static_cast<int>(parameters_.recovery_s * 100.0F + 0.5F);
        require(possible_steps_ >= recovery_steps || outputs.state == RSI_STATE_UNAVAILABLE,
                "unavailable until the inputs were good for the recovery time");
        require(outputs.state == RSI_STATE_UNAVAILABLE || outputs.roll_source != RSI_ROLL_NONE,
                "no statement without a roll angle");
        if (outputs.state == RSI_STATE_UNAVAILABLE) {
            return;
        }
        require(outputs.state != RSI_STATE_READY || outputs.warning_level < parameters_.advisory_on,
                "never ready at a level that asks for an advisory");
        if (outputs.warning_level < parameters_.warning_on) {
            steps_at_warning_level_ = 0;
            return;
        }
        ++steps_at_warning_level_;
        const int confirmation_steps = static_cast<int>(parameters_.warning_confirmation_s * 100.0F + 0.5F);
        require(steps_at_warning_level_ < confirmation_steps || outputs.state == RSI_STATE_WARNING,
                "warned of a risk once it is confirmed");
    }

    rsi_parameters parameters_;
    bool accepted_;
    bool possible_{false};
    int possible_steps_{0};
    int steps_at_warning_level_{0};
};

}  // namespace fuzz
