#include "rsi/indicator/further_indicators.hpp"

namespace rsi {

void FurtherIndicators::init(const Parameters& parameters) {
    filter_.init(parameters);
    extended_.init(parameters);
    load_transfer_.init(parameters);
    steering_demand_.init(parameters);
    moment_arm_error_.init(parameters);
    predictor_.init(parameters);
    classic_.init(parameters);
}

void FurtherIndicators::update(const Inputs& inputs, const Measurement& measured, Outputs& outputs) {
    const RollMotion motion = filter_.update(measured);
    const float suspension_nm =
        load_transfer_.suspension_moment_nm(motion.roll_angle_rad, motion.roll_rate_radps);
    const DemandedForce demand = steering_demand_.evaluate(inputs, measured);
    const float moment_arm_error = moment_arm_error_.update(motion, suspension_nm, load_transfer_ratio_,
                                                            measured.roll_source == RSI_ROLL_SENSOR);
    const Prediction prediction =
        predictor_.evaluate(motion, demand, load_transfer_, extended_, suspension_nm, moment_arm_error);
    load_transfer_ratio_ = prediction.present.load_transfer_ratio;
    outputs.rsi_extended = prediction.present.rsi_extended;
    outputs.load_transfer_ratio = prediction.present.load_transfer_ratio;
    outputs.predicted_load_transfer_ratio = prediction.worst.load_transfer_ratio;
    outputs.predicted_rsi = prediction.worst.rsi_extended;

    const ClassicIndexValues classic = classic_.evaluate(measured, motion);
    outputs.static_stability_level = classic.static_stability_level;
    outputs.dynamic_stability_index = classic.dynamic_stability_index;
    outputs.dynamic_stability_index_late = classic.dynamic_stability_index_late;
    outputs.energy_margin = classic.energy_margin;
    outputs.rollover_index = classic.rollover_index;
    outputs.time_to_rollover_s = classic.time_to_rollover_s;
}

}  // namespace rsi
