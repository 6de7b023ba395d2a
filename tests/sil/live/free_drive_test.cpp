// Free drive: the vehicle does what is wished, no faster than hands and feet do it.
#include "sil/world/manoeuvres/free_drive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sil/files/calibration_file.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace {

constexpr double step_s = 0.01;

class Hands {
 public:
    explicit Hands(const sil::DriverWish& wish, double start_mps = 20.0)
        : start_mps_{start_mps}, driver_{sil::free_drive(wish, start_mps).make_driver({})} {}

    // After another step: angle and wished speed.
    sil::DriverCommand next() {
        truth_.time_s += step_s;
        return driver_->command(truth_);
    }
    sil::DriverCommand after(int steps) {
        for (int i = 1; i < steps; ++i) {
            next();
        }
        return next();
    }
    double speed_mps(const sil::DriverCommand& command) const { return command.speed_share * start_mps_; }

 private:
    double start_mps_;
    std::unique_ptr<sil::Driver> driver_;
    sil::Truth truth_{};
};

TEST(FreeDrive, TurnsAsFastAsHandsInAnEmergency) {
    sil::DriverWish wish{sil::from_degrees(300.0), 20.0};
    Hands hands{wish};
    EXPECT_NEAR(hands.next().steering_wheel_angle_rad, sil::from_degrees(8.0), 1e-9);
    EXPECT_NEAR(hands.after(40).steering_wheel_angle_rad, sil::from_degrees(300.0), 1e-9);
    wish.steering_wheel_angle_rad = -sil::from_degrees(300.0);
    EXPECT_NEAR(hands.next().steering_wheel_angle_rad, sil::from_degrees(292.0), 1e-9);
}

TEST(FreeDrive, ChangesItsSpeedAsPeopleDo) {
    sil::DriverWish wish{0.0, 25.0};
    Hands hands{wish};
    EXPECT_NEAR(hands.speed_mps(hands.next()), 20.03, 1e-9);
    EXPECT_NEAR(hands.speed_mps(hands.after(300)), 25.0, 1e-9);
    wish.speed_mps = 10.0;
    EXPECT_NEAR(hands.speed_mps(hands.next()), 24.97, 1e-9);
}

TEST(FreeDrive, KeepsWithinItsLimits) {
    const sil::DriverWish wild{-100.0, 1000.0};
    const sil::DriverCommand fast = Hands{wild}.after(2000);
    EXPECT_EQ(fast.steering_wheel_angle_rad, -sil::DriverWish::largest_angle_rad);
    EXPECT_NEAR(20.0 * fast.speed_share, sil::DriverWish::highest_speed_mps, 1e-9);
    const sil::DriverWish backwards{100.0, -1000.0};
    const sil::DriverCommand slow = Hands{backwards}.after(2000);
    EXPECT_EQ(slow.steering_wheel_angle_rad, sil::DriverWish::largest_angle_rad);
    EXPECT_NEAR(20.0 * slow.speed_share, sil::DriverWish::lowest_speed_mps, 1e-9);
}

TEST(FreeDrive, KeepsWhatWasWishedBeforeWhenItIsNotANumber) {
    sil::DriverWish wish{sil::from_degrees(8.0), 20.0};
    Hands hands{wish};
    hands.after(5);
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    wish = {nothing, nothing};
    const sil::DriverCommand command = hands.after(5);
    EXPECT_NEAR(command.steering_wheel_angle_rad, sil::from_degrees(8.0), 1e-9);
    EXPECT_NEAR(hands.speed_mps(command), 20.0, 1e-9);
}

TEST(FreeDrive, BeginsWithinItsLimitsToo) {
    const sil::DriverWish wish{0.0, 0.0};
    EXPECT_EQ(sil::free_drive(wish, 0.0).initial_speed_mps, sil::DriverWish::lowest_speed_mps);
    EXPECT_EQ(sil::free_drive(wish, 1.0e3).initial_speed_mps, sil::DriverWish::highest_speed_mps);
}

TEST(FreeDrive, HoldsTheSpeedAndTurnsTheWayThatIsWished) {
    const sil::VehicleParameters vehicle =
        sil::load_vehicle(std::string{RSI_SOURCE_DIR} + "/sil/vehicles/van.toml");
    const sil::DriverWish wish{sil::from_degrees(45.0), 15.0};
    const sil::Manoeuvre manoeuvre = sil::free_drive(wish, wish.speed_mps);
    sil::RunOptions options;
    options.duration_s = 5.0;
    sil::ManoeuvreRun run{vehicle, manoeuvre, options};
    while (!run.finished()) {
        run.step();
    }
    EXPECT_NEAR(run.truth().speed_mps, 15.0, 0.3);
    EXPECT_GT(run.truth().lateral_acceleration_mps2, 1.0);
}

}  // namespace
