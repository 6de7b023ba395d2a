// The simulated vehicles, identified from their slow ramp and step steer; judged by what is known of them and
// by drives that the fit has not seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "rsi/parameters.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/studies/identification/calibration_writer.hpp"
#include "sil/studies/identification/identification.hpp"
#include "sil/studies/identification/simulated_drive.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/support/nominal_roll_model.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

struct Case {
    const char* vehicle;
    bool noise;
};

sil::VehicleParameters vehicle_of(const std::string& name) {
    return sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/" + name + ".toml");
}

sil::VehicleData data_of(const std::string& name) {
    return sil::load_vehicle_data(RSI_SOURCE_DIR "/sil/vehicles/data/" + name + ".toml");
}

sil::Drive drive(const std::string& vehicle, const char* manoeuvre, bool noise, std::uint64_t seed) {
    sil::SensorFlaws flaws;
    flaws.noise = noise;
    flaws.seed = seed;
    return sil::simulate_drive(vehicle_of(vehicle), sil::find_manoeuvre(manoeuvre), flaws);
}

sil::Identification identified(const Case& test) {
    return sil::identify(data_of(test.vehicle), {drive(test.vehicle, "slow-ramp", test.noise, 1U)},
                         {drive(test.vehicle, "step-steer", test.noise, 2U)});
}

class SimulatedVehicle : public testing::TestWithParam<Case> {};

TEST_P(SimulatedVehicle, DataFileAgreesWithTheVehicle) {
    const sil::VehicleParameters vehicle = vehicle_of(GetParam().vehicle);
    const sil::VehicleData data = data_of(GetParam().vehicle);
    EXPECT_NEAR(data.total_mass_kg, sil::total_mass_kg(vehicle), 0.1);
    EXPECT_NEAR(data.sprung_mass_kg, vehicle.mass.sprung_kg, 0.1);
    EXPECT_NEAR(data.sprung_cg_height_m, vehicle.geometry.cg_height_m, 1e-6);
    EXPECT_NEAR(data.track_width_m, vehicle.geometry.track_width_m, 1e-6);
    EXPECT_NEAR(data.imu_z_m, vehicle.imu_mount.z_m, 1e-6);
}

// Both curves as K/H, the part that does not depend on the roll centre.
TEST_P(SimulatedVehicle, StiffnessCurveIsTheNominalOne) {
    const sil::Identification result = identified(GetParam());
    const sil::VehicleParameters vehicle = vehicle_of(GetParam().vehicle);
    const rsi_test::NominalRollModel nominal = rsi_test::nominal_roll_model(vehicle.name);
    const double arm_m = vehicle.geometry.cg_height_m - nominal.roll_centre_height_m;
    for (const double phi : {0.02, 0.04, 0.06, 0.08, 0.095}) {
        const double square = phi * phi;
        const double expected = phi *
                                (nominal.stiffness_0_nmprad + square * nominal.stiffness_2_nmprad3 +
                                 square * square * nominal.stiffness_4_nmprad5) /
                                arm_m;
        EXPECT_NEAR(result.roll.moment_nm(phi) / result.roll.arm_m, expected, 0.025 * expected) << phi;
    }
}

// Tyres, and the axles' yaw-rate lag, make the body's effective inertia smaller than the rigid body's.
TEST_P(SimulatedVehicle, InertiaAndDampingAreOfTheBodysSize) {
    const sil::Identification result = identified(GetParam());
    const double rigid_kgm2 = vehicle_of(GetParam().vehicle).inertia.sprung_roll_kgm2;
    EXPECT_GT(result.roll.inertia_kgm2.value, 0.35 * rigid_kgm2);
    EXPECT_LT(result.roll.inertia_kgm2.value, 1.1 * rigid_kgm2);
    const double held_nmprad =
        result.roll.stiffness_nmprad.value - result.vehicle.sprung_mass_kg * 9.80665 * result.roll.arm_m;
    const double damping_ratio =
        result.roll.damping_nmsprad.value / (2.0 * std::sqrt(held_nmprad * result.roll.inertia_kgm2.value));
    EXPECT_GT(damping_ratio, 0.1);
    EXPECT_LT(damping_ratio, 0.8);
}

// Outputs of the component from the roll state against the wheels, in manoeuvres that the fit has not
// seen.
TEST_P(SimulatedVehicle, LoadTransferOfUnseenDrivesIsThatOfTheWheels) {
    const sil::Identification result = identified(GetParam());
    for (const char* manoeuvre : {"double-lane-change", "j-turn-45", "slalom"}) {
        const sil::PreparedDrive unseen = sil::prepare_drive(
            drive(GetParam().vehicle, manoeuvre, GetParam().noise, 3U), result.vehicle, {});
        const auto residuals = sil::load_transfer_residuals(result.vehicle, result.roll, {unseen});
        ASSERT_EQ(residuals.size(), 1U);
        EXPECT_LT(residuals.front().rms, 0.03) << manoeuvre;
    }
}

TEST_P(SimulatedVehicle, EachFittedValueBearsACorrection) {
    const sil::Identification result = identified(GetParam());
    for (const sil::IdentifiedValue& value : result.values) {
        const auto field =
            std::find_if(rsi::parameter_fields.begin(), rsi::parameter_fields.end(),
                         [&value](const rsi::ParameterField& each) { return value.key == each.name; });
        if (field == rsi::parameter_fields.end() || value.origin == "vehicle data") {
            continue;
        }
        for (const double share : {0.8, 1.2}) {
            EXPECT_GE(share * value.value, static_cast<double>(field->minimum)) << value.key;
            EXPECT_LE(share * value.value, static_cast<double>(field->maximum)) << value.key;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Vehicles, SimulatedVehicle,
                         testing::Values(Case{"large_suv", false}, Case{"large_suv", true},
                                         Case{"ordinary_suv", false}, Case{"ordinary_suv", true},
                                         Case{"van", false}, Case{"van", true}),
                         [](const auto& test) {
                             return std::string{test.param.vehicle} + (test.param.noise ? "_with_noise" : "");
                         });

// The van is the vehicle without hand tuning: its committed calibration is what the command writes.
TEST(VanCalibration, ComesFromIdentificationAlone) {
    const sil::Identification result = identified({"van", true});
    const test_support::ScratchFolder folder;
    const std::string path = folder.path() / "calibration.toml";
    test_support::write_text(path, sil::calibration_text(result));
    const rsi::Parameters fresh = sil::load_calibration(path);
    const rsi::Parameters committed = sil::load_calibration(RSI_SOURCE_DIR "/firmware/calibrations/van.toml");
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        const float expected = fresh.*field.member;
        EXPECT_NEAR(committed.*field.member, expected, 1e-3F * std::abs(expected) + 1e-9F)
            << field.name << ": renew the file as docs/calibration.md says";
    }
}

}  // namespace
