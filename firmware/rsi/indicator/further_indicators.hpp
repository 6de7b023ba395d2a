// Further indicators: everything beside the published RSI, behind one door.
#pragma once

#include "rsi/indicator/classic_indices.hpp"
#include "rsi/indicator/extended_indicator.hpp"
#include "rsi/indicator/load_transfer.hpp"
#include "rsi/indicator/moment_arm_error.hpp"
#include "rsi/indicator/prediction.hpp"
#include "rsi/indicator/roll_motion.hpp"
#include "rsi/indicator/steering_demand.hpp"

namespace rsi {

class FurtherIndicators {
 public:
    [[gnu::cold]] void init(const Parameters& parameters);

    // Start, or start again after a gap: the signals are taken to have been where they are.
    void reset(const Measurement& measured) {
        filter_.reset(measured);
        moment_arm_error_.reset();
        load_transfer_ratio_ = 1.0F;
    }

    // Writes rsi_extended, load_transfer_ratio and all that follows in rsi_outputs; every one is finite.
    void update(const Inputs& inputs, const Measurement& measured, Outputs& outputs);

 private:
    RollMotionFilter filter_{};
    ExtendedIndicator extended_{};
    LoadTransfer load_transfer_{};
    SteeringDemand steering_demand_{};
    MomentArmError moment_arm_error_{};
    RollPredictor predictor_{};
    float load_transfer_ratio_{
        1.0F};  // of the cycle before; 1, at which nothing is learnt, where there is none
    ClassicIndices classic_{};
};

}  // namespace rsi
