// Parts that manoeuvres share.
#include "sil/world/manoeuvres/manoeuvre.hpp"

#include <algorithm>
#include <utility>

namespace sil {
namespace {

class OpenLoopDriver final : public CopiedDriver<OpenLoopDriver> {
 public:
    explicit OpenLoopDriver(std::function<DriverCommand(double)> command) : command_{std::move(command)} {}
    DriverCommand command(const Truth& truth) override { return command_(truth.time_s); }

 private:
    std::function<DriverCommand(double)> command_;
};

}  // namespace

std::function<std::unique_ptr<Driver>(const VehicleParameters&)> open_loop(
    std::function<DriverCommand(double)> command) {
    return [command = std::move(command)](const VehicleParameters&) {
        return std::make_unique<OpenLoopDriver>(command);
    };
}

std::function<std::unique_ptr<Driver>(const VehicleParameters&)> at_rate(
    std::function<std::unique_ptr<Driver>(const VehicleParameters&, double handwheel_radps)> make_driver,
    double handwheel_radps) {
    return [make_driver = std::move(make_driver), handwheel_radps](const VehicleParameters& parameters) {
        return make_driver(parameters, handwheel_radps);
    };
}

MakeRoad flat_road() {
    return [](std::uint64_t) { return std::make_unique<PlaneRoad>(); };
}

double ramp_and_hold(double time_s, double start_s, double rate_radps, double angle_rad) {
    return std::clamp((time_s - start_s) * rate_radps, 0.0, angle_rad);
}

}  // namespace sil
