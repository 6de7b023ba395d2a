// The indices of a campaign: what it compares is what the firmware would warn by.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "rsi/output_table.hpp"
#include "rsi/warning/indicator_level.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/judge/index_score.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/studies/campaign/drawn_run.hpp"
#include "sil/studies/campaign/indices.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/sil/campaign/small_campaign.hpp"

namespace {

constexpr auto index_count = static_cast<std::int32_t>(rsi::index_outputs.size());

// Levels of a run, sample by sample.
struct Levels {
    std::vector<float> driving{};  // of the indicator that drives the warning
    std::vector<float> shown{};    // of the watched one
};

class Recorder final : public sil::RunObserver {
 public:
    Recorder(const sil::InProcessRun& run, const rsi::Parameters& watched) : run_{run}, watched_{watched} {}

    void cycle(const sil::Truth&, const sil::SensorSample&, const sil::EcuFrames&,
               const sil::RunEvents&) override {
        levels.driving.push_back(run_.outputs().warning_level);
        levels.shown.push_back(rsi::indicator_level(run_.outputs(), watched_));
    }

    Levels levels{};

 private:
    const sil::InProcessRun& run_;
    const rsi::Parameters& watched_;
};

// Levels of a hard turn with noise: `driver` drives the warning, and `indicator` is watched.
Levels drive(std::int32_t driver, std::int32_t indicator) {
    const sil::CampaignVehicle vehicle = testing_campaign::small_campaign(1U).vehicles.front();
    rsi::Parameters calibration = sil::load_calibration(vehicle.calibration);
    calibration.warning_indicator = driver;
    sil::InProcessRun run{sil::load_vehicle(vehicle.parameters), sil::find_manoeuvre("j-turn-110"),
                          sil::RunOptions{}, sil::noisy_sensors(3U), calibration};
    rsi::Parameters watched = calibration;
    watched.warning_indicator = indicator;
    Recorder recorder{run, watched};
    run.run(recorder);
    return recorder.levels;
}

// For any indicator of the run's own firmware.
TEST(CampaignIndex, IsThatOfTheFirmwareThatWarnsByIt) {
    for (std::int32_t indicator = 0; indicator < index_count; ++indicator) {
        const std::vector<float> expected = drive(indicator, indicator).driving;
        ASSERT_GT(expected.size(), 100U);
        EXPECT_EQ(drive(RSI_INDICATOR_PUBLISHED, indicator).shown, expected) << indicator;
        EXPECT_EQ(drive(RSI_INDICATOR_ENERGY, indicator).shown, expected) << indicator;
    }
}

// A held peak would count twice and pass the confirmation of a warning alone.
TEST(CampaignIndex, IsNewInEverySample) {
    const std::vector<float> shown = drive(RSI_INDICATOR_PUBLISHED, RSI_INDICATOR_ENERGY).shown;
    std::size_t repeated = 0U;
    for (std::size_t k = 1U; k < shown.size(); ++k) {
        repeated += (shown[k] == shown[k - 1U]) ? 1U : 0U;
    }
    EXPECT_LT(repeated, shown.size() / 5U);
}

// Outputs with another value for each index, for any calibration.
TEST(CampaignIndex, ReadsItsOwnOutput) {
    const sil::CampaignVehicle vehicle = testing_campaign::small_campaign(1U).vehicles.front();
    rsi::Parameters calibration = sil::load_calibration(vehicle.calibration);
    rsi::Outputs outputs{};
    for (std::size_t i = 0U; i < rsi::index_outputs.size(); ++i) {
        outputs.*rsi::index_outputs[i].member = 0.1F + 0.05F * static_cast<float>(i);
    }
    const sil::Truth truth;
    for (std::int32_t indicator = 0; indicator < index_count; ++indicator) {
        calibration.warning_indicator = indicator;
        const float expected = rsi::indicator_level(outputs, calibration);
        calibration.warning_indicator = RSI_INDICATOR_PUBLISHED;
        const sil::IndexReaders readers{calibration};
        const auto index = static_cast<std::size_t>(indicator);
        const std::string& name = sil::campaign_indices()[index].name;
        EXPECT_EQ(readers.level(index, {outputs, truth}), static_cast<double>(expected)) << name;
        EXPECT_GT(expected, 0.0F) << name;
    }
}

// The warning of a hard turn, cycle by cycle, and what the campaign makes of its indicator.
class WarningRecorder final : public sil::RunObserver {
 public:
    WarningRecorder(const sil::InProcessRun& run, const rsi::Parameters& calibration)
        : run_{run}, calibration_{calibration} {}

    void cycle(const sil::Truth& truth, const sil::SensorSample&, const sil::EcuFrames&,
               const sil::RunEvents&) override {
        const auto index = static_cast<std::size_t>(calibration_.warning_indicator);
        const sil::IndexSample sample{run_.outputs(), truth, run_.inputs().roll_angle_rad};
        course.times_s.push_back(truth.time_s);
        course.risks.push_back(sil::IndexReaders{calibration_}.risk(index, sample));
    }

    sil::IndexCourse course{};

 private:
    const sil::InProcessRun& run_;
    const rsi::Parameters& calibration_;
};

// At the firmware's own threshold the copy of its state machine must have its very lead.
TEST(CampaignIndex, WarnsAsTheFirmwareThatWarnsByIt) {
    const sil::CampaignVehicle vehicle = testing_campaign::small_campaign(1U).vehicles.front();
    int warned = 0;
    for (const char* manoeuvre : {"j-turn-110", "fishhook-1a"}) {
        for (std::int32_t indicator = 0; indicator < index_count; ++indicator) {
            rsi::Parameters calibration = sil::load_calibration(vehicle.calibration);
            calibration.warning_indicator = indicator;
            sil::InProcessRun run{sil::load_vehicle(vehicle.parameters), sil::find_manoeuvre(manoeuvre),
                                  sil::RunOptions{}, sil::SensorOptions{}, calibration};
            WarningRecorder recorder{run, calibration};
            const sil::RunEvents& events = run.run(recorder);
            ASSERT_TRUE(events.two_wheel_lift);
            const std::optional<double> lead_s =
                sil::index_lead_s(recorder.course, calibration, static_cast<double>(calibration.warning_on),
                                  {*events.two_wheel_lift, events.judgement.falling_side});
            EXPECT_NEAR(lead_s.value_or(-1.0), events.judgement.lead_s.value_or(-1.0), 1.0e-9)
                << manoeuvre << " " << indicator;
            warned += lead_s ? 1 : 0;
        }
    }
    EXPECT_GE(warned, 10);
}

}  // namespace
