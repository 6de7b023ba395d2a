// Errors that are there when the ECU starts, on a straight road: how long they warn.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sil/files/calibration_file.hpp"
#include "sil/studies/faults/faulty_run.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace faults_test {
namespace {

using sil::Fault;
using sil::FaultKind;
using sil::FaultPlace;

constexpr double degree = 0.017453292519943295;

class AtPowerOn : public ::testing::TestWithParam<const char*> {
 protected:
    AtPowerOn() {
        sil::Manoeuvre straight = sil::find_manoeuvre("straight");
        straight.duration_s = 5.0;
        const auto recorded =
            sil::record_drive(vehicle, straight, {}, {sil::recording_sensors(vehicle)}).front();
        static_cast<sil::RecordedDrive&>(drive) = recorded;
        drive.fault_end = drive.samples.size();
    }

    static std::string file(const char* folder) {
        return std::string{RSI_SOURCE_DIR} + "/" + folder + "/" + GetParam() + ".toml";
    }

    sil::VehicleParameters vehicle{sil::load_vehicle(file("sil/vehicles"))};
    rsi::Parameters calibration{sil::load_calibration(file("firmware/calibrations"))};
    sil::FaultedDrive drive;
};

TEST_P(AtPowerOn, ARollSensorThatIsFarOffDoesNotWarnAndGetsItsCode) {
    for (const double error_deg : {6.0, 10.0, 25.0, -6.0, -10.0, -25.0}) {
        const Fault fault{FaultKind::offset, FaultPlace::roll_angle, error_deg * degree};
        const sil::FaultyRun run = sil::run_with_fault(drive, fault, calibration);
        const auto warns = [](const auto& answer) { return answer->state == sil::WarningState::warning; };
        EXPECT_EQ(std::count_if(run.answers.begin(), run.answers.end(), warns), 0) << error_deg;
        EXPECT_TRUE(run.answers.at(60)->codes.any()) << error_deg;
        EXPECT_EQ(run.answers.back()->state, sil::WarningState::ready) << error_deg;
        EXPECT_EQ(run.answers.back()->roll_source, sil::RollSource::observer) << error_deg;
    }
}

INSTANTIATE_TEST_SUITE_P(OfEachVehicle, AtPowerOn, ::testing::Values("large_suv", "ordinary_suv", "van"),
                         [](const auto& tested) { return std::string{tested.param}; });

}  // namespace
}  // namespace faults_test
