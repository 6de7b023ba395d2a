// Live request: requests of the page, and the answers to others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "sil/input_error.hpp"
#include "sil/live/live_request.hpp"
#include "sil/studies/faults/sensor_signal.hpp"

namespace live_request_test {
namespace {

void expect_refused(const std::string& text, const std::string& why) {
    try {
        sil::parse_live_request(text);
        FAIL() << "was understood: " << text;
    } catch (const sil::InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(why)) << text;
    }
}

TEST(LiveRequest, SaysWhatTheDriverWants) {
    const sil::LiveRequest request = sil::parse_live_request(R"({"steering_deg": -90.5, "speed_kmh": 80})");
    EXPECT_EQ(request.steering_deg, -90.5);
    EXPECT_EQ(request.speed_kmh, 80.0);
    EXPECT_FALSE(request.pause);
    EXPECT_FALSE(request.fault);
    EXPECT_FALSE(request.again);
}

TEST(LiveRequest, BeginsAgainPausesAndBreaks) {
    const sil::LiveRequest again =
        sil::parse_live_request(R"({"again": true, "load_kg": 150, "speed_kmh": 60})");
    EXPECT_TRUE(again.again);
    EXPECT_EQ(again.load_kg, 150.0);
    EXPECT_EQ(sil::parse_live_request(R"({"pause": false})").pause, false);
    EXPECT_EQ(sil::parse_live_request(R"({"brake_on_warning": true})").brake_on_warning, true);
    expect_refused(R"({"brake_on_warning": 1})", "brake_on_warning wants true or false");
    const sil::LiveRequest broken = sil::parse_live_request(R"({"fault": {"place": 2, "kind": 1}})");
    ASSERT_TRUE(broken.fault);
    EXPECT_EQ(broken.fault->place, 2);
    EXPECT_EQ(broken.fault->kind, 1);
    EXPECT_EQ(sil::parse_live_request(R"({"fault": null})").fault->place, -1);
    EXPECT_FALSE(sil::parse_live_request("{}").again);
}

TEST(LiveRequest, HasLimits) {
    for (const auto& [key, least, most] : {std::tuple{"steering_deg", -360, 360},
                                           std::tuple{"speed_kmh", 10, 160}, std::tuple{"load_kg", 0, 300}}) {
        const auto text = [name = key](int value) {
            return "{\"" + std::string{name} + "\": " + std::to_string(value) + "}";
        };
        EXPECT_NO_THROW(sil::parse_live_request(text(least)));
        EXPECT_NO_THROW(sil::parse_live_request(text(most)));
        expect_refused(text(least - 1), std::string{key} + " wants a number from");
        expect_refused(text(most + 1), std::string{key} + " wants a number from");
    }
}

TEST(LiveRequest, RefusesWhatIsNotUnderstood) {
    expect_refused("", "no JSON object");
    expect_refused("[1]", "no JSON object");
    expect_refused("{\"steering_deg\": 1", "no JSON object");
    expect_refused("\xff\xfe", "no JSON object");
    expect_refused(R"({"steering_deg": "left"})", "steering_deg wants a number");
    expect_refused(R"({"steering_deg": NaN})", "no JSON object");
    expect_refused(R"({"speed_kmh": 1e999})", "");
    expect_refused(R"({"pause": 1})", "pause wants true or false");
    expect_refused(R"({"again": null})", "again wants true or false");
    expect_refused(R"({"fault": 1})", "fault wants null");
    expect_refused(R"({"fault": {"place": -1, "kind": 0}})", "fault wants null");
    expect_refused(R"({"fault": {"place": 1}})", "fault wants null");
    expect_refused(R"({"fault": {"place": 1, "kind": 0, "more": 1}})", "fault wants null");
    expect_refused(R"({"fault": {"place": 5000, "kind": 0}})", "place wants a number from 0 to 1000");
    expect_refused(R"({"brake": 1})", "a key of another name");
}

TEST(LiveFaults, AreThoseThatChangeASampleOfEverySensorThatIsThere) {
    ASSERT_EQ(sil::live_faults().size(), sil::sensor_signals.size() - 1U);  // no sensor of the bank
    for (const sil::LiveFaults& faults : sil::live_faults()) {
        EXPECT_GE(faults.kinds.size(), 5U) << sil::to_string(faults.place);
        for (const sil::Fault& fault : faults.kinds) {
            EXPECT_EQ(fault.place, faults.place);
            EXPECT_TRUE(sil::is_signal_fault(fault.kind));
            EXPECT_NE(fault.kind, sil::FaultKind::out_of_range);
            EXPECT_NE(fault.place, sil::FaultPlace::bank_angle);
        }
    }
    const auto json = nlohmann::json::parse(sil::live_faults_json());
    EXPECT_EQ(json[0]["place"], "lateral acceleration");
    EXPECT_EQ(json[0]["kinds"].size(), sil::live_faults()[0].kinds.size());
}

TEST(LiveFaults, AreChosenByTheirPlacesInTheList) {
    EXPECT_FALSE(sil::chosen_fault({-1, 0}));
    EXPECT_EQ(sil::fault_text(std::nullopt), "");
    EXPECT_EQ(sil::fault_text(sil::chosen_fault({0, 0})), "lateral acceleration: frozen");
    const int last = static_cast<int>(sil::live_faults().size()) - 1;
    const int last_kind = static_cast<int>(sil::live_faults().back().kinds.size()) - 1;
    EXPECT_TRUE(sil::chosen_fault({last, last_kind}));
    EXPECT_THROW(sil::chosen_fault({last, last_kind + 1}), sil::InputError);
    EXPECT_THROW(sil::chosen_fault({last + 1, 0}), sil::InputError);
    EXPECT_THROW(sil::chosen_fault({0, -1}), sil::InputError);
}

}  // namespace
}  // namespace live_request_test
