// Lane keeping: towards a point on the x axis, some way ahead.
#include "sil/world/manoeuvres/lane_keeping.hpp"

#include "sil/world/manoeuvres/path_follower.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {
namespace {

constexpr double preview_s = 1.2;

class LaneKeepingDriver final : public CopiedDriver<LaneKeepingDriver> {
 public:
    explicit LaneKeepingDriver(const PathFollower& follower) : follower_{follower} {}

    DriverCommand command(const Truth& truth) override {
        const PathPoint target{truth.position_x_m + follower_.preview_m(truth), 0.0};
        return {follower_.handwheel_rad(truth, target)};
    }

 private:
    PathFollower follower_;
};

}  // namespace

std::function<std::unique_ptr<Driver>(const VehicleParameters&)> lane_keeping() {
    return [](const VehicleParameters& parameters) {
        const double gradient =
            understeer_gradient_s2pm(parameters, handwheel_angle_at_0_3_g_rad(parameters));
        return std::make_unique<LaneKeepingDriver>(PathFollower{parameters, gradient, preview_s});
    };
}

}  // namespace sil
