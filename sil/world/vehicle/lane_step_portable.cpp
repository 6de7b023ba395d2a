// Lane step: compiled for any processor.
#define RSI_PROCESSOR portable_lanes
#include "sil/world/vehicle/lane_step_body.hpp"

LaneStep portable_lane_step() {
    return {"any processor", make, step, atan, sin, sin_and_cos};
}

}  // namespace sil
