// Vehicle writer: the files are read back as the same vehicle, and the data sheet says what is true.
#include "sil/studies/population/vehicle_writer.hpp"

#include <gtest/gtest.h>

#include "sil/studies/identification/vehicle_data.hpp"
#include "sil/studies/population/vehicle_draw.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

// Both states: the ends of what load_vehicle admits are nearer to a loaded truck than to anything else.
TEST(VehicleWriter, ItsOutputIsReadBackToTheLastBit) {
    const test_support::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "vehicle.toml";
    for (std::uint64_t number = 0U; number < 200U; ++number) {
        const sil::DrawnVehicle drawn = sil::draw_vehicle(5U, number);
        for (const sil::VehicleParameters& vehicle :
             {drawn.parameters, sil::loaded(drawn.parameters, sil::vehicle_classes()[drawn.in_class].load)}) {
            const std::string text = sil::vehicle_toml(vehicle, "a remark");
            test_support::write_text(file, text);
            const sil::VehicleParameters read = sil::load_vehicle(file);
            EXPECT_EQ(sil::vehicle_toml(read, "a remark"), text);
            EXPECT_EQ(read.name, vehicle.name);
            EXPECT_EQ(read.mass.sprung_kg, vehicle.mass.sprung_kg);
            EXPECT_EQ(read.steering.compliance_radpn, vehicle.steering.compliance_radpn);
            EXPECT_EQ(read.imu_mount.z_m, vehicle.imu_mount.z_m);
        }
    }
}

TEST(VehicleWriter, TheDataSheetSaysWhatIsTrue) {
    const test_support::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "data.toml";
    for (std::uint64_t number = 0U; number < 16U; ++number) {
        const sil::VehicleParameters vehicle = sil::draw_vehicle(5U, number).parameters;
        test_support::write_text(file, sil::vehicle_data_toml(vehicle));
        const sil::VehicleData data = sil::load_vehicle_data(file);
        EXPECT_NEAR(data.sprung_mass_kg, vehicle.mass.sprung_kg, 1e-9 * vehicle.mass.sprung_kg);
        EXPECT_EQ(data.sprung_cg_height_m, vehicle.geometry.cg_height_m);
        EXPECT_EQ(data.unsprung_cg_height_m, vehicle.geometry.wheel_radius_m);
        EXPECT_EQ(data.track_width_m, vehicle.geometry.track_width_m);
        EXPECT_EQ(data.wheelbase_m, vehicle.geometry.front_axle_to_cg_m + vehicle.geometry.rear_axle_to_cg_m);
        EXPECT_EQ(data.steering_ratio, vehicle.steering.ratio);
        EXPECT_EQ(data.imu_x_m, vehicle.imu_mount.x_m);
        EXPECT_EQ(data.imu_y_m, vehicle.imu_mount.y_m);
        EXPECT_EQ(data.imu_z_m, vehicle.imu_mount.z_m);
        EXPECT_FALSE(data.roll_centre_height_m) << "no data sheet has it";
        EXPECT_TRUE(data.assumptions.empty());
    }
}

}  // namespace
