// Written by sil/studies/predictors/run --weights; do not edit.
#pragma once

#include <array>

namespace rsi {

// A row for each signal, as in ForecastMatrix, a number for each lag.
inline constexpr std::array<std::array<float, 3>, 5> forecast_weights{{
    {{0.941F, -0.667F, 0.505F}},
    {{1.983F, -2.581F, 1.271F}},
    {{0.145F, 0.480F, -0.493F}},
    {{2.021F, -1.941F, 0.049F}},
    {{1.805F, -2.539F, 0.756F}},
}};

}  // namespace rsi
