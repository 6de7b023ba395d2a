// The C face's plain structures under their C++ names.
#pragma once

#include "rsi/rsi.h"

namespace rsi {

using Parameters = ::rsi_parameters;
using Inputs = ::rsi_inputs;
using Outputs = ::rsi_outputs;
using Validation = ::rsi_validation;

inline constexpr float sample_time_s = RSI_SAMPLE_TIME_S;
// What moves slowly runs in every second sample, one half of it in the even, the other in the odd ones, so
// that every step costs about the same.
inline constexpr float slow_sample_time_s = 2.0F * sample_time_s;
inline constexpr float gravity_mps2 = 9.80665F;

}  // namespace rsi
