// The calibration in its own section of the image.
#pragma once

#include "rsi/types.hpp"

namespace image {

extern const rsi::Parameters parameters;

}  // namespace image
