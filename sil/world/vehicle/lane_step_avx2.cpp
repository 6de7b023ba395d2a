// Lane step: compiled for x86 with AVX2.
#define RSI_PROCESSOR avx2_lanes
#include "sil/world/vehicle/lane_step_body.hpp"

LaneStep avx2_lane_step() {
    return {"AVX2", make, step, atan, sin, sin_and_cos};
}

}  // namespace sil
