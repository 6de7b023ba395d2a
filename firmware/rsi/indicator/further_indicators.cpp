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
    classic_in_every_sample_ = (parameters.warning_indicator >= RSI_INDICATOR_STATIC_STABILITY_FACTOR);
}

void FurtherIndicators::update(const Inputs& inputs, const Measurement& measured, bool fresh,
                               Outputs& outputs) {
    const RollMotion motion = filter_.update(measured);
    const float suspension_nm =
        load_transfer_.suspension_moment_nm(motion.roll_angle_rad, motion.roll_rate_radps);
    if (measured.odd_sample && !fresh) {
        demand_ = steering_demand_.evaluate(inputs, measured);
        moment_arm_error_.update(motion, suspension_nm, load_transfer_ratio_,
                                 measured.roll_source == RSI_ROLL_SENSOR);
    }
    const Prediction prediction = predictor_.evaluate(motion, demand_, load_transfer_, extended_,
                                                      suspension_nm, moment_arm_error_.value());
    load_transfer_ratio_ = prediction.present.load_transfer_ratio;
    outputs.rsi_extended = prediction.present.rsi_extended;
    outputs.load_transfer_ratio = prediction.present.load_transfer_ratio;
    outputs.predicted_load_transfer_ratio = prediction.worst.load_transfer_ratio;
    outputs.predicted_rsi = prediction.worst.rsi_extended;

    if (measured.odd_sample || fresh || classic_in_every_sample_) {
        classic_values_ = classic_.evaluate(measured, motion);
    }
    outputs.static_stability_level = classic_values_.static_stability_level;
    outputs.dynamic_stability_index = classic_values_.dynamic_stability_index;
    outputs.dynamic_stability_index_late = classic_values_.dynamic_stability_index_late;
    outputs.energy_margin = classic_values_.energy_margin;
    outputs.rollover_index = classic_values_.rollover_index;
    outputs.time_to_rollover_s = classic_values_.time_to_rollover_s;
}

}  // namespace rsi
