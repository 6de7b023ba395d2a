// Fishhook 1a and 1b after NHTSA: steer, dwell, counter-steer, each at 720 degrees per second; the amplitude
// is 6.5 times the handwheel angle that gives 0.3 g in a slowly increasing steer. The throttle is released as
// the steering begins.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sil/world/manoeuvres/rule_book.hpp"
#include "sil/world/manoeuvres/slowly_increasing_steer.hpp"

namespace sil {
namespace {

constexpr double start_s = 2.0;
constexpr double nominal_rate_radps = from_degrees(720.0);
constexpr double fixed_dwell_s = 0.250;
constexpr double small_roll_rate_radps = from_degrees(1.5);
constexpr double countersteer_held_s = 3.0;
constexpr double return_s = 2.0;

class FishhookDriver final : public CopiedDriver<FishhookDriver> {
 public:
    FishhookDriver(double amplitude_rad, double rate_radps, FishhookReversal reversal)
        : amplitude_rad_{amplitude_rad}, rate_radps_{rate_radps}, reversal_{reversal} {}

    DriverCommand command(const Truth& truth) override {
        const double time_s = truth.time_s;
        if (!reversal_s_ && dwell_is_over(truth)) {
            reversal_s_ = time_s;
        }
        return {handwheel_rad(time_s), time_s < start_s ? SpeedPolicy::held : SpeedPolicy::off_throttle};
    }

 private:
    bool dwell_is_over(const Truth& truth) const {
        const double dwelt_s = truth.time_s - start_s - amplitude_rad_ / rate_radps_;
        if (reversal_ == FishhookReversal::after_a_fixed_dwell) {
            return dwelt_s >= fixed_dwell_s;
        }
        return dwelt_s >= 0.0 && std::abs(truth.angular_velocity_radps[0]) <= small_roll_rate_radps;
    }

    double handwheel_rad(double time_s) const {
        if (!reversal_s_) {
            return ramp_and_hold(time_s, start_s, rate_radps_, amplitude_rad_);
        }
        const double countersteer = ramp_and_hold(time_s, *reversal_s_, rate_radps_, 2.0 * amplitude_rad_);
        const double end_s = *reversal_s_ + 2.0 * amplitude_rad_ / rate_radps_ + countersteer_held_s;
        return amplitude_rad_ - countersteer +
               ramp_and_hold(time_s, end_s, amplitude_rad_ / return_s, amplitude_rad_);
    }

    double amplitude_rad_;
    double rate_radps_;
    FishhookReversal reversal_;
    std::optional<double> reversal_s_{};
};

Manoeuvre fishhook(FishhookReversal reversal, double speed_mps,
                   std::function<double(const VehicleParameters&)> amplitude_rad) {
    Manoeuvre manoeuvre;
    manoeuvre.duration_s = 10.0;
    manoeuvre.initial_speed_mps = speed_mps;
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver_at_rate = [reversal, amplitude_rad = std::move(amplitude_rad)](
                                        const VehicleParameters& parameters, double rate_radps) {
        return std::make_unique<FishhookDriver>(amplitude_rad(parameters), rate_radps, reversal);
    };
    manoeuvre.make_driver = at_rate(manoeuvre.make_driver_at_rate, nominal_rate_radps);
    return manoeuvre;
}

Manoeuvre fishhook_of_the_vehicle(FishhookReversal reversal) {
    Manoeuvre manoeuvre = fishhook(reversal, from_kmh(88.0), [](const VehicleParameters& parameters) {
        return fishhook_amplitude_factor * handwheel_angle_at_0_3_g_rad(parameters);
    });
    manoeuvre.asks_for_handwheel_angle = true;
    return manoeuvre;
}

}  // namespace

Manoeuvre fishhook(FishhookReversal reversal, double speed_mps, double amplitude_rad) {
    return fishhook(reversal, speed_mps, [amplitude_rad](const VehicleParameters&) { return amplitude_rad; });
}

Manoeuvre fishhook_1a() {
    Manoeuvre manoeuvre = fishhook_of_the_vehicle(FishhookReversal::after_a_fixed_dwell);
    manoeuvre.name = "fishhook-1a";
    manoeuvre.description =
        "NHTSA fishhook 1a at 88 km/h: 6.5 times the angle for 0.3 g, 720 degrees/s, dwell 250 ms";
    return manoeuvre;
}

Manoeuvre fishhook_1b() {
    Manoeuvre manoeuvre = fishhook_of_the_vehicle(FishhookReversal::at_small_roll_rate);
    manoeuvre.name = "fishhook-1b";
    manoeuvre.description =
        "NHTSA fishhook 1b at 88 km/h: as 1a, but reversed when the roll rate is within 1.5 degrees/s";
    return manoeuvre;
}

}  // namespace sil
