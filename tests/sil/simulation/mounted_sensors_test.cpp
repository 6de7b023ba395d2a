#include "sil/simulation/mounted_sensors.hpp"

#include <gtest/gtest.h>

namespace testing_simulation {
namespace {

TEST(MountedSensors, SitWhereTheVehicleFileSays) {
    sil::VehicleParameters vehicle;
    vehicle.imu_mount = {0.3, -0.1, 0.2};
    const sil::SensorOptions options = sil::mounted_sensors(vehicle, {});
    EXPECT_EQ(options.imu.position.x_m, 0.3);
    EXPECT_EQ(options.imu.position.y_m, -0.1);
    EXPECT_EQ(options.imu.position.z_m, 0.2);
    EXPECT_EQ(options.imu.lateral_acceleration_mps2.noise_rms, 0.0);
    EXPECT_EQ(options.imu.lateral_acceleration_mps2.bias, 0.0);
    EXPECT_EQ(options.roll.reference, sil::RollReference::road);
    EXPECT_FALSE(options.roll.reports_bank);
    EXPECT_FALSE(options.mass.fitted);
    EXPECT_EQ(options.mass.scale_error, 0.0);
}

TEST(MountedSensors, HaveTheFlawsAskedFor) {
    sil::SensorFlaws flaws;
    flaws.noise = true;
    flaws.seed = 7U;
    flaws.bias_g = 0.005;
    flaws.quantisation_g = 0.001;
    flaws.bank_sensor = true;
    flaws.attitude_sensor = true;
    flaws.mass_sensor = true;
    const sil::SensorOptions options = sil::mounted_sensors(sil::VehicleParameters{}, flaws);
    EXPECT_EQ(options.seed, 7U);
    for (const sil::ChannelOptions& channel :
         {options.imu.lateral_acceleration_mps2, options.imu.vertical_acceleration_mps2}) {
        EXPECT_GT(channel.noise_rms, 0.0);
        EXPECT_DOUBLE_EQ(channel.bias, 0.005 * 9.80665);
        EXPECT_DOUBLE_EQ(channel.quantisation_step, 0.001 * 9.80665);
    }
    EXPECT_EQ(options.imu.roll_rate_radps.bias, 0.0);
    EXPECT_EQ(options.roll.reference, sil::RollReference::horizon);
    EXPECT_TRUE(options.roll.reports_bank);
    EXPECT_TRUE(options.mass.fitted);
    EXPECT_NE(options.mass.scale_error, 0.0);
}

}  // namespace
}  // namespace testing_simulation
