// Live session: the messages to the page match the drive.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "sil/files/calibration_file.hpp"
#include "sil/input_error.hpp"
#include "sil/live/live_request.hpp"
#include "sil/live/live_session.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace live_session_test {
namespace {

using Json = nlohmann::json;

struct Kept {
    int begun{0};
    int finished{0};
    int cycles{0};
    int steps{0};
    double last_lateral_mps2{0.0};
    double last_speed_mps{0.0};
};

class Recorder final : public sil::LiveRecorder {
 public:
    explicit Recorder(Kept& kept) : kept_{kept} { ++kept_.begun; }
    void cycle(const sil::Truth& truth, const sil::SensorSample& sample, const sil::EcuFrames&,
               const sil::RunEvents&) override {
        ++kept_.cycles;
        kept_.last_speed_mps = truth.speed_mps;
        kept_.last_lateral_mps2 = sample.lateral_acceleration_mps2;
    }
    void step(const sil::Truth&) override { ++kept_.steps; }
    void finish() override { ++kept_.finished; }

 private:
    Kept& kept_;
};

std::string project_file(const std::string& path) {
    return std::string{RSI_SOURCE_DIR} + "/" + path;
}

class LiveSession : public ::testing::Test {
 protected:
    static sil::LiveVehicle what(const std::string& manoeuvre = "") {
        sil::LiveVehicle vehicle;
        vehicle.vehicle = sil::load_vehicle(project_file("sil/vehicles/large_suv.toml"));
        vehicle.make_ecu = [] {
            return sil::live_ecu_in_process(
                sil::load_calibration(project_file("firmware/calibrations/large_suv.toml")));
        };
        vehicle.ecu_text = "the firmware of this test";
        if (!manoeuvre.empty()) {
            vehicle.manoeuvre = sil::find_manoeuvre(manoeuvre);
        }
        return vehicle;
    }
    static void cycles(sil::LiveSession& session, int count) {
        for (int i = 0; i < count; ++i) {
            session.cycle();
        }
    }
    static Json news(sil::LiveSession& session) {
        const std::string text = session.news();
        return text.empty() ? Json::object() : Json::parse(text);
    }
    static void break_sensor(sil::LiveSession& session, std::size_t place, sil::FaultKind kind) {
        const std::vector<sil::Fault>& kinds = sil::live_faults().at(place).kinds;
        const auto found = std::find_if(kinds.begin(), kinds.end(),
                                        [kind](const sil::Fault& fault) { return fault.kind == kind; });
        ASSERT_NE(found, kinds.end());
        session.take("{\"fault\": {\"place\": " + std::to_string(place) +
                     ", \"kind\": " + std::to_string(found - kinds.begin()) + "}}");
    }
    // All that the page would have at the end; fetched every 20 ms.
    static Json drive(sil::LiveSession& session, int count) {
        Json all = Json::object();
        all["rows"] = Json::array();
        for (int i = 0; i < count; i += 2) {
            cycles(session, 2);
            const Json now = news(session);
            for (const auto& [name, value] : now.items()) {
                if (name != "rows") {
                    all[name] = value;
                }
            }
            for (const Json& row : now.value("rows", Json::array())) {
                all["rows"].push_back(row);
            }
        }
        return all;
    }
    // Speed of a hard turn, half a second after its warning.
    double speed_after_warning_mps() {
        session.take(R"({"steering_deg": -360})");
        bool warned = false;
        for (int i = 0; i < 400 && !warned; ++i) {
            cycles(session, 1);
            const Json now = news(session);
            warned = now.contains("events") && now["events"].contains("warning") &&
                     !now["events"]["warning"].is_null();
        }
        EXPECT_TRUE(warned);
        cycles(session, 50);
        return kept.last_speed_mps;
    }
    sil::MakeLiveRecorder recorders() {
        return [this](const sil::LiveDrive&) { return std::make_unique<Recorder>(kept); };
    }

    Kept kept{};
    sil::LiveSession session{what(), 80.0, recorders()};
};

TEST_F(LiveSession, BeginsWithTheVehicleAndItsFaults) {
    const Json first = Json::parse(session.begin());
    EXPECT_EQ(first["drive"]["title"], "Live drive");
    EXPECT_EQ(first["drive"]["driven"], true);
    EXPECT_EQ(first["drive"]["input"]["speed_kmh"], 80);
    EXPECT_EQ(first["drive"]["vehicle"]["roof_load_kg"], 0.0);
    EXPECT_EQ(first["drive"]["columns"][0], "time_s");
    EXPECT_EQ(first["drive"]["faults"].size(), 7U);
    EXPECT_EQ(first["notice"], "");
    EXPECT_EQ(first["paused"], false);
    EXPECT_EQ(first.count("rows"), 0U);
}

TEST_F(LiveSession, TellsEveryCycleOnce) {
    session.begin();
    const Json all = drive(session, 100);
    ASSERT_EQ(all["rows"].size(), 100U);
    for (std::size_t row = 0U; row < 100U; ++row) {
        EXPECT_NEAR(all["rows"][row][0].get<double>(), 0.01 * static_cast<double>(row), 1e-9);
    }
    EXPECT_EQ(session.news(), "");
    EXPECT_EQ(kept.cycles, 100);
    EXPECT_EQ(kept.steps, 990);
}

TEST_F(LiveSession, DropsTheOldestRowsThatAreNotFetched) {
    session.begin();
    cycles(session, static_cast<int>(sil::LiveSession::most_waiting_rows) + 5);
    const Json all = news(session);
    ASSERT_EQ(all["rows"].size(), sil::LiveSession::most_waiting_rows);
    EXPECT_NEAR(all["rows"][0][0].get<double>(), 0.05, 1e-9);
}

TEST_F(LiveSession, WarnsBeforeTheVehicleRollsOverToTheSideOfTheTurn) {
    session.begin();
    session.take(R"({"again": true, "load_kg": 150, "speed_kmh": 80})");
    EXPECT_EQ(kept.finished, 1);
    EXPECT_EQ(kept.begun, 2);
    session.take(R"({"steering_deg": -360})");
    const Json all = drive(session, 400);
    EXPECT_EQ(all["drive"]["vehicle"]["roof_load_kg"], 150.0);
    EXPECT_LT(all["events"]["warning"]["time_s"].get<double>(),
              all["events"]["two_wheel_lift"]["time_s"].get<double>());
    EXPECT_GT(all["judgement"]["lead_time_s"].get<double>(), 0.0);
    EXPECT_EQ(all["judgement"]["falling_side"], "left");
    EXPECT_THAT(all["notice"].get<std::string>(), testing::HasSubstr("rolled over"));
    EXPECT_EQ(kept.finished, 2);
    const int driven = kept.cycles;
    cycles(session, 10);
    EXPECT_EQ(kept.cycles, driven) << "it lies on its side";
    session.finish();
    EXPECT_EQ(kept.finished, 2);
}

TEST_F(LiveSession, BrakesOnAWarningIfThePageSaysSoAndAfterANewStart) {
    session.begin();
    const double without_mps = speed_after_warning_mps();
    session.take(R"({"brake_on_warning": true})");
    EXPECT_EQ(news(session)["brake_on_warning"], true);
    session.take(R"({"again": true, "speed_kmh": 80})");
    EXPECT_EQ(news(session)["brake_on_warning"], true);
    EXPECT_LT(speed_after_warning_mps(), without_mps - 0.5);
    session.take(R"({"brake_on_warning": false})");
    session.take(R"({"again": true, "speed_kmh": 80})");
    EXPECT_EQ(Json::parse(session.begin())["brake_on_warning"], false);
    EXPECT_EQ(speed_after_warning_mps(), without_mps);
}

TEST_F(LiveSession, StandsStillWhilePaused) {
    session.begin();
    session.take(R"({"pause": true})");
    cycles(session, 50);
    EXPECT_EQ(kept.cycles, 0);
    EXPECT_EQ(news(session)["paused"], true);
    session.take(R"({"pause": false})");
    cycles(session, 50);
    EXPECT_EQ(kept.cycles, 50);
}

TEST_F(LiveSession, BreaksASensorAndMendsIt) {
    session.begin();
    session.take(R"({"steering_deg": 60})");
    cycles(session, 200);
    const double turning = kept.last_lateral_mps2;
    EXPECT_GT(turning, 1.0);
    news(session);
    break_sensor(session, 0U, sil::FaultKind::not_available);
    const Json broken = drive(session, 60);
    EXPECT_THAT(broken["fault"].get<std::string>(),
                testing::StartsWith("lateral acceleration: not available"));
    EXPECT_TRUE(std::isnan(kept.last_lateral_mps2));
    EXPECT_THAT(broken["diagnosis"]["confirmed"].dump(), testing::HasSubstr("lateral acceleration"));
    // A page that connects now receives them, too.
    const Json joined = Json::parse(session.begin());
    EXPECT_EQ(joined["fault"], broken["fault"]);
    EXPECT_EQ(joined["diagnosis"], broken["diagnosis"]);
    ASSERT_EQ(joined["rows"].size(), 1U);
    EXPECT_EQ(joined["rows"][0], broken["rows"].back());
    session.take(R"({"fault": null})");
    EXPECT_EQ(drive(session, 10)["fault"], "");
    EXPECT_NEAR(kept.last_lateral_mps2, turning, 1.0);
}

// Straight ahead and in a turn, after one fault and after several that follow each other.
TEST_F(LiveSession, HealsWithinTheTimeThatThePageStates) {
    EXPECT_TRUE(Json::parse(session.begin())["drive"]["heals_within_s"].is_null()) << "without noise";
    sil::LiveVehicle noisy = what();
    noisy.sensors.noise = true;
    sil::LiveSession drives{noisy, 80.0, recorders()};
    EXPECT_EQ(Json::parse(drives.begin())["drive"]["heals_within_s"], sil::LiveSession::heals_within_s);
    drive(drives, 200);
    for (std::size_t place = 0U; place < sil::live_faults().size(); ++place) {
        drives.take(place < 4U ? R"({"steering_deg": 0})" : R"({"steering_deg": 40})");
        break_sensor(drives, place, sil::FaultKind::offset);
        drive(drives, 200);
        break_sensor(drives, place, sil::FaultKind::not_available);
        const Json broken = drive(drives, 200);
        EXPECT_FALSE(broken["diagnosis"]["set"].empty()) << place;
        if (place % 2U == 0U) {
            continue;  // the next fault follows at once
        }
        drives.take(R"({"fault": null})");
        drive(drives, static_cast<int>(100.0 * sil::LiveSession::heals_within_s));
        const Json healed = Json::parse(drives.begin())["diagnosis"];
        EXPECT_EQ(healed["set"], Json::array()) << place;
        EXPECT_EQ(healed["confirmed"], Json::array()) << place;
        EXPECT_EQ(healed["degradation"], "full") << place;
    }
}

TEST_F(LiveSession, IsAsItWasAfterARequestThatIsRefused) {
    session.begin();
    EXPECT_THROW(session.take(R"({"again": true, "fault": {"place": 99, "kind": 0}})"), sil::InputError);
    EXPECT_THROW(session.take("nonsense"), sil::InputError);
    EXPECT_EQ(kept.begun, 1);
    EXPECT_EQ(kept.finished, 0);
    EXPECT_EQ(session.news(), "");
}

TEST_F(LiveSession, EndsWithTheManoeuvreThatIsWatched) {
    sil::LiveSession watched{what("j-turn-45"), 80.0, recorders()};
    const Json first = Json::parse(watched.begin());
    EXPECT_EQ(first["drive"]["title"], "j-turn-45");
    EXPECT_EQ(first["drive"]["driven"], false);
    const int whole = static_cast<int>(100.0 * sil::find_manoeuvre("j-turn-45").duration_s);
    const Json all = drive(watched, whole + 10);
    EXPECT_THAT(all["notice"].get<std::string>(), testing::HasSubstr("The time of this drive is over"));
    EXPECT_EQ(kept.finished, 1);
}

}  // namespace
}  // namespace live_session_test
