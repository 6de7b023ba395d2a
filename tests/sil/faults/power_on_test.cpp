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
        record(straight);
    }

    void record(const sil::Manoeuvre& manoeuvre) {
        const auto recorded =
            sil::record_drive(vehicle, manoeuvre, {}, {sil::recording_sensors(vehicle)}).front();
        static_cast<sil::RecordedDrive&>(drive) = recorded;
        drive.fault_end = drive.samples.size();
    }

    // Cycle of the first warning; that of the end without one.
    int first_warning(const Fault& fault) const {
        const sil::FaultyRun run = sil::run_with_fault(drive, fault, calibration);
        const auto found = std::find_if(run.answers.begin(), run.answers.end(), [](const auto& answer) {
            return answer->state == sil::WarningState::warning;
        });
        return static_cast<int>(found - run.answers.begin());
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

// Another vehicle's mass, one axle's, or a trailer's in it; nor does it warn if no warning is due.
TEST_P(AtPowerOn, AWrongMassLeavesTheLeadOfAWarning) {
    for (const char* const name : {"j-turn-110", "fishhook-1a"}) {
        record(sil::with_lead_in(sil::find_manoeuvre(name), 2.0));
        const int without = first_warning({});
        for (const double gain : {0.7, 0.8, 0.9, 1.1, 1.2, 1.3, 1.6, 2.0}) {
            EXPECT_NEAR(first_warning({FaultKind::gain, FaultPlace::vehicle_mass, gain}), without, 10)
                << gain;
        }
        EXPECT_NEAR(first_warning({FaultKind::offset, FaultPlace::vehicle_mass, 1000.0}), without, 10);
    }
}

INSTANTIATE_TEST_SUITE_P(OfEachVehicle, AtPowerOn, ::testing::Values("large_suv", "ordinary_suv", "van"),
                         [](const auto& tested) { return std::string{tested.param}; });

}  // namespace
}  // namespace faults_test
