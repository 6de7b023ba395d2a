// Indicator level: every indicator on one scale, 0 without risk and 1 where it says "warn".
#pragma once

#include <cstdint>

#include "rsi/output_table.hpp"
#include "rsi/types.hpp"

namespace rsi {

// Output of an indicator for one sample.
struct IndicatedRisk {
    float level;      // 0 to 20; NaN where the indicator is not available
    float direction;  // < 0 in a right turn (the vehicle would fall to the left); its size means nothing
    float opposite;   // level towards the other side, 0 to 20; 0 of an indicator that knows but one
};

// Reads the indicator that the parameters choose for the warning.
class WarningIndicator {
 public:
    WarningIndicator() = default;
    [[gnu::cold]] explicit WarningIndicator(const Parameters& parameters);

    // From outputs that have been computed, as the table of outputs says for the chosen index.
    IndicatedRisk evaluate(const Outputs& outputs, float roll_angle_rad) const;

 private:
    float level(LevelScale scale, float value) const;
    static float direction(RiskSide side, float value, const Outputs& outputs, float roll_angle_rad);

    std::int32_t indicator_{RSI_INDICATOR_PUBLISHED};
    float static_stability_inverse_{};  // 1 / SSF
    float time_to_rollover_limit_s_{};
};

// The level alone, to compare many indicators.
float indicator_level(const Outputs& outputs, const Parameters& parameters);

}  // namespace rsi
