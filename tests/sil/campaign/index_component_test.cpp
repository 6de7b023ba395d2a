// Index component: what a campaign compares is what the firmware would warn by.
#include "sil/studies/campaign/index_component.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "rsi/indicator/indicator_level.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/studies/campaign/drawn_run.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/sensors/sensor_options.hpp"
#include "sil/world/simulation/in_process_run.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/sil/campaign/small_campaign.hpp"

namespace {

// Levels of a run, sample by sample.
struct Levels {
    std::vector<float> driving{};   // of the indicator that drives the warning, as the firmware has it
    std::vector<float> compared{};  // of the watched one, as the comparison has it
    std::vector<float> shown{};     // of the watched one, as the firmware shows it
};

class Recorder final : public sil::RunObserver {
 public:
    Recorder(const sil::InProcessRun& run, const rsi::Parameters& driving, const rsi::Parameters& watched)
        : run_{run}, watched_{watched}, component_{driving} {}

    void cycle(const sil::Truth&, const sil::SensorSample&, const sil::EcuFrames&,
               const sil::RunEvents&) override {
        levels.driving.push_back(run_.outputs().warning_level);
        levels.compared.push_back(rsi::indicator_level(component_.step(run_.inputs()), watched_));
        levels.shown.push_back(rsi::indicator_level(run_.outputs(), watched_));
    }

    Levels levels{};

 private:
    const sil::InProcessRun& run_;
    const rsi::Parameters& watched_;
    sil::IndexComponent component_;
};

// Of a hard turn with noise: `driver` drives the warning, and `indicator` is watched.
Levels drive(std::int32_t driver, std::int32_t indicator) {
    const sil::CampaignVehicle vehicle = testing_campaign::small_campaign(1U).vehicles.front();
    rsi::Parameters calibration = sil::load_calibration(vehicle.calibration);
    calibration.warning_indicator = driver;
    sil::InProcessRun run{sil::load_vehicle(vehicle.parameters), sil::find_manoeuvre("j-turn-110"),
                          sil::RunOptions{}, sil::noisy_sensors(3U), calibration};
    rsi::Parameters watched = calibration;
    watched.warning_indicator = indicator;
    Recorder recorder{run, calibration, watched};
    run.run(recorder);
    return recorder.levels;
}

// However the run's own firmware is told to warn.
TEST(IndexComponent, GivesEachIndexAsTheFirmwareThatWarnsByIt) {
    for (std::int32_t indicator = 0; indicator <= RSI_INDICATOR_TIME_TO_ROLLOVER; ++indicator) {
        const std::vector<float> expected = drive(indicator, indicator).driving;
        ASSERT_GT(expected.size(), 100U);
        EXPECT_EQ(drive(RSI_INDICATOR_PUBLISHED, indicator).compared, expected) << indicator;
        EXPECT_EQ(drive(RSI_INDICATOR_ENERGY, indicator).compared, expected) << indicator;
    }
}

// Why it is needed: the firmware holds an index that it does not warn by.
TEST(IndexComponent, HoldsNoIndexOverTwoSamples) {
    const Levels levels = drive(RSI_INDICATOR_PUBLISHED, RSI_INDICATOR_ENERGY);
    std::size_t held = 0U;
    std::size_t repeated = 0U;
    for (std::size_t k = 1U; k < levels.shown.size(); ++k) {
        held += (levels.shown[k] == levels.shown[k - 1U]) ? 1U : 0U;
        repeated += (levels.compared[k] == levels.compared[k - 1U]) ? 1U : 0U;
    }
    EXPECT_GT(held, levels.shown.size() / 3U);
    EXPECT_LT(repeated, levels.shown.size() / 5U);
}

TEST(IndexComponent, RefusesWhatTheFirmwareRefuses) {
    rsi::Parameters nothing{};
    EXPECT_THROW(sil::IndexComponent{nothing}, std::invalid_argument);
}

}  // namespace
