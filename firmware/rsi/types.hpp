// The C interface's plain structures under their C++ names.
#pragma once

#include "rsi/language.hpp"

#include "rsi/rsi.h"

namespace rsi {

using Parameters = ::rsi_parameters;
using Inputs = ::rsi_inputs;
using Outputs = ::rsi_outputs;
using Validation = ::rsi_validation;
using LearntLoad = ::rsi_learnt_load;

inline constexpr float sample_time_s = RSI_SAMPLE_TIME_S;
inline constexpr float gravity_mps2 = 9.80665F;

}  // namespace rsi
