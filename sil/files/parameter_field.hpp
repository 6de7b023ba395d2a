// Parameter field: name and range of a number of the calibration, found by its member.
#pragma once

#include <algorithm>
#include <array>

#include "rsi/parameters.hpp"

namespace sil {

// `member` must be one of the component's numbers; every float of rsi::Parameters is.
inline const rsi::ParameterField& parameter_field(float rsi::Parameters::* member) {
    return *std::find_if(rsi::parameter_fields.begin(), rsi::parameter_fields.end(),
                         [member](const rsi::ParameterField& each) { return each.member == member; });
}

}  // namespace sil
