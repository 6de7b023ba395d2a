// Lane step: compiled for x86 with AVX-512.
#define RSI_PROCESSOR avx512_lanes
#include "sil/world/vehicle/lane_step_body.hpp"

LaneStep avx512_lane_step() {
    return {"AVX-512", make, step, atan, sin, sin_and_cos};
}

}  // namespace sil
