// Slowly increasing steer after NHTSA's rollover resistance test: 13.5 degrees per second to 270 degrees at
// 50 mph, held for two seconds.
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>

#include "sil/straight_line.hpp"
#include "sil/world/manoeuvres/manoeuvre.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/vehicle/vehicle_batch.hpp"

namespace sil {
namespace {

constexpr double straight_s = 1.0;
constexpr double rate_radps = from_degrees(13.5);
constexpr double largest_angle_rad = from_degrees(270.0);
constexpr double held_s = 2.0;
constexpr double coarse_step_s = 0.002;  // twice the nominal one moves the angle by 0.05 %
constexpr double fit_from_mps2 = 0.1 * gravity_mps2;
constexpr double fit_to_mps2 = 0.375 * gravity_mps2;
constexpr double read_at_mps2 = 0.3 * gravity_mps2;

Manoeuvre steer_from(double start_s) {
    Manoeuvre manoeuvre;
    manoeuvre.initial_speed_mps = from_mph(50.0);
    manoeuvre.duration_s = start_s + largest_angle_rad / rate_radps + held_s;
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = open_loop([start_s](double time_s) {
        return DriverCommand{ramp_and_hold(time_s, start_s, rate_radps, largest_angle_rad),
                             SpeedPolicy::held};
    });
    return manoeuvre;
}

// A run of it until the angle is known.
class AngleSearch {
 public:
    AngleSearch(const VehicleParameters& parameters, bool mirrored)
        : direction_{mirrored ? -1.0 : 1.0}, run_{parameters, steer_from(0.0), options(mirrored)} {}

    ManoeuvreRun& run() { return run_; }

    // After each step of the run.
    void see() {
        const double acceleration = direction_ * run_.truth().lateral_acceleration_mps2;
        const double angle_rad = direction_ * run_.truth().steering_wheel_angle_rad;
        if (acceleration > read_at_mps2 && !reached_rad_) {
            reached_rad_ = angle_rad;
        }
        if (acceleration > fit_to_mps2) {
            angle_rad_ = line_.at(read_at_mps2);
        } else if (run_.finished()) {
            angle_rad_ = reached_rad_;
        } else if (acceleration > fit_from_mps2) {
            line_.add(acceleration, angle_rad);
        }
    }
    bool finished() const { return angle_rad_ || run_.finished(); }
    const std::optional<double>& angle_rad() const { return angle_rad_; }

 private:
    static RunOptions options(bool mirrored) {
        RunOptions options;
        options.step_s = coarse_step_s;
        options.mirrored = mirrored;
        return options;
    }

    double direction_;
    ManoeuvreRun run_;
    StraightLine line_{};                  // of the handwheel angle over the acceleration
    std::optional<double> reached_rad_{};  // where the acceleration first passes that of the angle
    std::optional<double> angle_rad_{};
};

// Vehicles whose angle to the left this thread has found ahead of being asked for it.
struct KnownAngle {
    BasicVehicleParameters<double> vehicle;
    double angle_rad;
};
thread_local std::vector<KnownAngle> known_angles;

std::optional<double> known_angle_rad(const VehicleParameters& parameters) {
    const BasicVehicleParameters<double>& vehicle = parameters;
    for (const KnownAngle& known : known_angles) {
        if (std::memcmp(&known.vehicle, &vehicle, sizeof(vehicle)) == 0) {
            return known.angle_rad;
        }
    }
    return std::nullopt;
}

}  // namespace

Manoeuvre slowly_increasing_steer();
Manoeuvre slowly_increasing_steer() {
    Manoeuvre manoeuvre = steer_from(straight_s);
    manoeuvre.name = "slowly-increasing-steer";
    manoeuvre.description = "NHTSA's slowly increasing steer: 50 mph, held, 13.5 degrees/s up to 270 degrees";
    return manoeuvre;
}

double handwheel_angle_at_0_3_g_rad(const VehicleParameters& parameters, bool mirrored) {
    if (!mirrored) {
        if (const std::optional<double> known = known_angle_rad(parameters)) {
            return *known;
        }
    }
    AngleSearch search{parameters, mirrored};
    while (!search.finished()) {
        search.run().step();
        search.see();
    }
    if (search.angle_rad()) {
        return *search.angle_rad();
    }
    throw std::runtime_error(
        "The vehicle '" + parameters.name +
        "' does not reach 0.3 g in a slowly increasing steer at 50 mph, so the manoeuvre's handwheel "
        "angle cannot be found. Look at its steering ratio and its tyres' friction.");
}

void find_handwheel_angles_ahead(const std::vector<const VehicleParameters*>& vehicles) {
    known_angles.clear();
    VehicleBatch batch;
    std::array<DriverInput, lane_count> inputs{};
    for (std::size_t first = 0U; first < vehicles.size(); first += lane_count) {
        std::array<std::unique_ptr<AngleSearch>, lane_count> searches;
        std::size_t left = std::min(lane_count, vehicles.size() - first);
        for (std::size_t lane = 0U; lane < left; ++lane) {
            searches[lane] = std::make_unique<AngleSearch>(*vehicles[first + lane], false);
            batch.enter(lane, searches[lane]->run().vehicle_to_step());
        }
        while (left > 0U) {
            for (std::size_t lane = 0U; lane < lane_count; ++lane) {
                if (searches[lane]) {
                    inputs[lane] = searches[lane]->run().next_input();
                }
            }
            batch.step(inputs, coarse_step_s, VehicleBatch::TruthWanted::motion);
            for (std::size_t lane = 0U; lane < lane_count; ++lane) {
                if (!searches[lane]) {
                    continue;
                }
                searches[lane]->see();
                if (searches[lane]->finished()) {
                    if (searches[lane]->angle_rad()) {
                        known_angles.push_back({*vehicles[first + lane], *searches[lane]->angle_rad()});
                    }
                    batch.leave(lane);
                    searches[lane].reset();
                    --left;
                }
            }
        }
    }
}

}  // namespace sil
