// Lane-change track of ISO 3888-2 (obstacle avoidance): three lanes between cones.
#pragma once

#include <array>

namespace sil {

struct LaneSection {
    double begin_m{0.0};
    double end_m{0.0};
    double right_m{0.0};  // edges, y to the left
    double left_m{0.0};
};

// Sections 1, 3 and 5, between which the cones leave the vehicle free for 13.5 and 12.5 m. Section 1 is
// centred on the x axis and begins at x = `begin_m`; section 5 is centred on it too; section 3 lies to the
// left, one metre from edge to edge. Widths follow from the vehicle's width b: 1.1 b + 0.25, b + 1, and
// 1.3 b + 0.25 but at least 3 m.
std::array<LaneSection, 3> lane_change_track(double begin_m, double vehicle_width_m);

}  // namespace sil
