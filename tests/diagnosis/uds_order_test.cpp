// The order of negative responses of ISO 14229-1, functional addressing, suppressed answers, and random
// requests.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "rsi/ecu/diagnosis/service_table.hpp"
#include "tests/diagnosis/tester.hpp"

namespace testing_diagnosis {
namespace {

class UdsOrder : public ::testing::Test {
 protected:
    Bytes ask(const Bytes& request) { return tester_.ask(request); }

    Memories memories_{};
    Tester tester_{memories_};
};

TEST_F(UdsOrder, UnknownServicesAreSaid) {
    for (unsigned id = 0U; id < 0x100U; ++id) {
        const auto service = static_cast<std::uint8_t>(id);
        const bool is_known =
            std::any_of(rsi::diagnosis::services.begin(), rsi::diagnosis::services.end(),
                        [&](const rsi::diagnosis::Service& each) { return each.id == service; });
        const bool is_answer = ((id & 0x40U) != 0U);
        if (!is_known) {
            EXPECT_EQ(ask({service}), is_answer ? Bytes{} : no(service, 0x11U)) << id;
            EXPECT_EQ(tester_.ask_functional({service}), Bytes{});
        }
    }
}

// The session counts before the key, the key before the length, the sub-function before the length.
TEST_F(UdsOrder, SessionThenAccessThenSubFunctionThenLength) {
    for (const std::uint8_t service :
         Bytes{0x11U, 0x14U, 0x27U, 0x28U, 0x2EU, 0x31U, 0x34U, 0x36U, 0x37U, 0x85U}) {
        EXPECT_EQ(ask({service}), no(service, 0x7FU));
        EXPECT_EQ(ask({service, 0x55U}), no(service, 0x7FU));
    }
    for (const std::uint8_t service : Bytes{0x10U, 0x19U, 0x3EU}) {
        EXPECT_EQ(ask({service}), no(service, 0x13U));
        EXPECT_EQ(ask({service, 0x55U}), no(service, 0x12U));
        EXPECT_EQ(ask({service, 0x55U, 0U, 0U, 0U, 0U, 0U}), no(service, 0x12U));
    }
    EXPECT_EQ(ask({0x22U}), no(0x22U, 0x13U));
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x86U, 0xF1U}), no(0x22U, 0x13U));
    EXPECT_EQ(ask({0x10U, 0x03U, 0x00U}), no(0x10U, 0x13U));
    EXPECT_EQ(ask({0x19U, 0x02U}), no(0x19U, 0x13U));
    EXPECT_EQ(ask({0x19U, 0x0AU, 0x00U}), no(0x19U, 0x13U));

    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x14U}), no(0x14U, 0x33U));
    for (const std::uint8_t service : Bytes{0x34U, 0x36U, 0x37U}) {
        EXPECT_EQ(ask({service}), no(service, 0x7FU));
    }
    for (const std::uint8_t service : Bytes{0x11U, 0x27U, 0x28U, 0x85U}) {
        EXPECT_EQ(ask({service}), no(service, 0x13U));
        EXPECT_EQ(ask({service, 0x55U}), no(service, 0x12U));
    }
    EXPECT_EQ(ask({0x28U, 0x02U, 0x01U}), no(0x28U, 0x12U)) << "reception is never switched off";
    EXPECT_EQ(ask({0x27U, 0x02U, 0x00U}), no(0x27U, 0x13U));
    EXPECT_EQ(ask({0x85U, 0x02U, 0x00U}), no(0x85U, 0x13U));
    EXPECT_EQ(ask({0x2EU, 0xF1U, 0x90U}), no(0x2EU, 0x13U));
    EXPECT_EQ(ask({0x2EU, 0x12U, 0x34U}), no(0x2EU, 0x13U)) << "no data, whatever they are of";
    EXPECT_EQ(ask({0x2EU, 0x12U, 0x34U, 0x00U}), no(0x2EU, 0x31U));
    EXPECT_EQ(ask({0x2EU, 0xF1U, 0x90U, 0x00U}), no(0x2EU, 0x13U)) << "the length before the key";

    ask({0x10U, 0x02U});
    for (const std::uint8_t service : Bytes{0x28U, 0x2EU, 0x85U}) {
        EXPECT_EQ(ask({service}), no(service, 0x7FU));
    }
    for (const std::uint8_t service : Bytes{0x36U, 0x37U}) {
        EXPECT_EQ(ask({service}), no(service, 0x33U));
    }
    tester_.unlock(0x03U);
    EXPECT_EQ(ask({0x14U, 0xFFU}), no(0x14U, 0x13U));
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x13U));
}

// ISO 14229-1 lists 0x14 for the default session as well, but not 0x27: nothing can be unlocked there, so the
// tester is sent to another session instead of to a key.
TEST_F(UdsOrder, ClearingIsNotOfTheDefaultSession) {
    tester_.unlock(0x03U);
    ask({0x10U, 0x01U});
    EXPECT_EQ(ask({0x27U, 0x01U}), no(0x27U, 0x7FU));
    EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x7FU));
    for (const std::uint8_t session : Bytes{0x03U, 0x02U}) {
        ask({0x10U, session});
        EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x33U));
        tester_.unlock(session);
        EXPECT_EQ(ask({0x14U, 0xFFU, 0xFFU, 0xFFU}), (Bytes{0x54U}));
    }
}

// Length, format, length again, range, then the key, then the conditions.
TEST_F(UdsOrder, ADownloadIsCheckedBeforeTheKeyAndTheKeyBeforeTheConditions) {
    const Bytes whole{0x34U, 0x00U, 0x24U, 0U, 0U, 0U, 0U, 0x01U, 0x5CU};
    ask({0x10U, 0x02U});
    tester_.inputs.speed_mps = 3.0F;
    for (const bool has_key : {false, true}) {
        EXPECT_EQ(ask({0x34U}), no(0x34U, 0x13U));
        EXPECT_EQ(ask({0x34U, 0x00U}), no(0x34U, 0x13U));
        EXPECT_EQ(ask({0x34U, 0x10U, 0x24U, 0U}), no(0x34U, 0x31U)) << "the format before the length";
        EXPECT_EQ(ask({0x34U, 0x00U, 0x24U, 0U}), no(0x34U, 0x13U));
        EXPECT_EQ(ask({0x34U, 0x00U, 0x24U, 0U, 0U, 0U, 1U, 0x01U, 0x5CU}), no(0x34U, 0x31U));
        EXPECT_EQ(ask(whole), no(0x34U, has_key ? 0x22U : 0x33U));
        tester_.inputs.speed_mps = 0.0F;
        tester_.unlock(0x02U);
        tester_.inputs.speed_mps = 3.0F;
    }
}

TEST_F(UdsOrder, Routines) {
    ask({0x10U, 0x03U});
    EXPECT_EQ(ask({0x31U, 0x01U, 0x02U}), no(0x31U, 0x13U));
    EXPECT_EQ(ask({0x31U, 0x77U, 0x12U, 0x34U}), no(0x31U, 0x31U));
    EXPECT_EQ(ask({0x31U, 0x01U, 0xFFU, 0x01U}), no(0x31U, 0x31U)) << "of another session";
    EXPECT_EQ(ask({0x31U, 0x77U, 0x02U, 0x03U}), no(0x31U, 0x12U));
    EXPECT_EQ(ask({0x31U, 0x02U, 0x02U, 0x03U}), no(0x31U, 0x12U)) << "it cannot be stopped";
    EXPECT_EQ(ask({0x31U, 0x01U, 0x02U, 0x03U, 0x00U}), no(0x31U, 0x13U));
    ask({0x10U, 0x02U});
    EXPECT_EQ(ask({0x31U, 0x01U, 0x02U, 0x03U}), no(0x31U, 0x31U));
    EXPECT_EQ(ask({0x31U, 0x77U, 0xFFU, 0x01U}), no(0x31U, 0x33U));
    tester_.unlock(0x02U);
    EXPECT_EQ(ask({0x31U, 0x03U, 0xFFU, 0x01U}), no(0x31U, 0x12U));
    EXPECT_EQ(ask({0x31U, 0x01U, 0xFFU, 0x01U, 0x00U}), no(0x31U, 0x13U));
    EXPECT_EQ(ask({0x31U, 0x01U, 0xFFU, 0x01U}), no(0x31U, 0x24U));
}

TEST_F(UdsOrder, FunctionalRequestsGetPositiveAnswersOnly) {
    EXPECT_EQ(tester_.ask_functional({0x10U, 0x55U}), Bytes{});
    EXPECT_EQ(tester_.ask_functional({0x22U, 0x00U, 0x01U}), Bytes{});
    EXPECT_EQ(tester_.ask_functional({0x85U, 0x01U}), Bytes{}) << "not in this session";
    EXPECT_EQ(tester_.ask_functional({0x10U}), no(0x10U, 0x13U));
    EXPECT_EQ(tester_.ask_functional({0x14U, 0xFFU, 0xFFU, 0xFFU}), Bytes{});
    EXPECT_EQ(tester_.ask_functional({0x22U, 0xF1U, 0x86U}), (Bytes{0x62U, 0xF1U, 0x86U, 0x01U}));
    EXPECT_EQ(tester_.ask_functional({0x10U, 0x03U})[0], 0x50U);
    EXPECT_EQ(tester_.ask_functional({0x14U, 0xFFU, 0xFFU, 0xFFU}), no(0x14U, 0x33U));
    for (const std::uint8_t service : Bytes{0x27U, 0x2EU, 0x31U, 0x34U, 0x36U, 0x37U}) {
        EXPECT_EQ(tester_.ask_functional({service, 0x01U}), Bytes{}) << "asked of one alone";
    }
    EXPECT_EQ(tester_.ask_functional({0x19U, 0x0AU}).size(), 3U + 4U * rsi::diagnosis::trouble_code_count);
}

TEST_F(UdsOrder, APositiveAnswerMayBeSuppressedANegativeOneNot) {
    EXPECT_EQ(ask({0x3EU, 0x80U}), Bytes{});
    EXPECT_EQ(ask({0x10U, 0x83U}), Bytes{});
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::extended);
    EXPECT_EQ(ask({0x85U, 0x82U}), Bytes{});
    EXPECT_EQ(ask({0x19U, 0x81U, 0xFFU}), Bytes{});
    EXPECT_EQ(ask({0x10U, 0xD5U}), no(0x10U, 0x12U));
    EXPECT_EQ(ask({0x3EU, 0x80U, 0x00U}), no(0x3EU, 0x13U));
    EXPECT_EQ(ask({0x22U, 0xF1U, 0x86U}).size(), 4U) << "no sub-function, nothing to suppress";
    tester_.cycles(100);  // the last record is a second old
    EXPECT_EQ(ask({0x31U, 0x81U, 0x02U, 0x03U}), Bytes{});
    EXPECT_EQ(ask({0x31U, 0x03U, 0x02U, 0x03U}).size(), 5U);
    tester_.inputs.speed_mps = 3.0F;
    EXPECT_EQ(ask({0x11U, 0x81U}), no(0x11U, 0x22U));
}

// A tester that was answered "later" gets the final answer.
TEST_F(UdsOrder, AfterLaterThereIsAnAnswer) {
    tester_.unlock();
    memories_.refuse(true);
    tester_.send({0x11U, 0x81U});
    EXPECT_EQ(tester_.receive(5), no(0x11U, 0x78U));
    memories_.refuse(false);
    EXPECT_EQ(tester_.receive(110), (Bytes{0x51U, 0x01U}));
    EXPECT_EQ(ask({0x3EU, 0x80U}), Bytes{}) << "the next request does not carry it";
}

// "Tester present" under functional addressing in the middle of a segmented request and of a segmented
// answer.
TEST_F(UdsOrder, TesterPresentDisturbsNothing) {
    tester_.unlock();
    const Bytes present{0x02U, 0x3EU, 0x80U};
    tester_.send_frame(Tester::physical, {0x10U, 20U, 0x2EU, 0xF1U, 0x90U, 'A', 'B', 'C'});
    tester_.cycle();
    tester_.send_frame(Tester::functional, present);
    tester_.send_frame(Tester::physical, {0x21U, 'D', 'E', 'F', 'G', 'H', '1', 'J'});
    tester_.cycle();
    tester_.send_frame(Tester::functional, present);
    tester_.send_frame(Tester::physical, {0x22U, 'K', 'L', 'M', 'N', '0', 'P', '9'});
    EXPECT_EQ(tester_.receive_final(20), (Bytes{0x6EU, 0xF1U, 0x90U}));

    tester_.send({0x22U, 0xF1U, 0x90U});
    tester_.send_frame(Tester::functional, present);
    tester_.cycle();
    tester_.send_frame(Tester::functional, present);
    EXPECT_EQ(tester_.receive(20).size(), 20U);
    EXPECT_EQ(tester_.ask_functional({0x3EU, 0x00U}), (Bytes{0x7EU, 0x00U}));
}

// Every 10 ms, and a physical request all the same.
TEST_F(UdsOrder, TesterPresentDoesNotStarvePhysicalRequests) {
    for (int time = 0; time < 20; ++time) {
        tester_.send_frame(Tester::functional, {0x02U, 0x3EU, 0x80U});
        tester_.cycle();
    }
    tester_.send_frame(Tester::physical, {0x03U, 0x22U, 0xF1U, 0x86U});
    Bytes answer;
    for (int cycle = 0; cycle < 2; ++cycle) {
        tester_.send_frame(Tester::functional, {0x02U, 0x3EU, 0x80U});
        tester_.cycle();
        answer = answer + tester_.payload();
    }
    EXPECT_EQ(answer, (Bytes{0x04U, 0x62U, 0xF1U, 0x86U, 0x01U, 0xCCU, 0xCCU, 0xCCU}));
    // And physical ones do not starve it: the session lasts.
    ask({0x10U, 0x03U});
    for (int cycle = 0; cycle < 1100; ++cycle) {
        tester_.send_frame(Tester::functional, {0x02U, 0x3EU, 0x80U});
        tester_.send_frame(Tester::physical, {0x01U, 0x7EU});
        tester_.cycle();
    }
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::extended);
}

// Those of another control unit, or its own that another node repeats: no dialogue of two ECUs, and no
// session that they keep alive.
TEST_F(UdsOrder, AnswersAreNotAnswered) {
    ask({0x10U, 0x03U});
    for (int cycle = 0; cycle < 600; ++cycle) {
        tester_.send_frame(Tester::physical, {0x03U, 0x7FU, 0x22U, 0x31U});
        tester_.cycle();
        tester_.send_frame(Tester::functional, {0x02U, 0x50U, 0x03U});
        tester_.cycle();
        ASSERT_EQ(tester_.payload(), Bytes{});
    }
    EXPECT_EQ(tester_.diagnosis().session(), rsi::diagnosis::Session::standard);
    EXPECT_EQ(ask({0xC5U, 0x02U}), Bytes{});
}

// Ten thousand requests of all kinds, most of them nearly right: no answer but those that the standard knows,
// at the rank that the standard gives them; nothing is unlocked, written or cleared.
TEST_F(UdsOrder, ARandomProberChangesNothing) {
    std::mt19937 random{14229U};
    const auto byte = [&] { return static_cast<std::uint8_t>(random() & 0xFFU); };
    const auto one_of = [&](const auto& from) { return from[random() % from.size()]; };
    const std::array<std::uint8_t, 14> services{0x10U, 0x11U, 0x14U, 0x19U, 0x22U, 0x27U, 0x28U,
                                                0x2EU, 0x31U, 0x34U, 0x36U, 0x37U, 0x3EU, 0x85U};
    const std::array<std::uint8_t, 12> likely{0x00U, 0x01U, 0x02U, 0x03U, 0x04U, 0x06U,
                                              0x0AU, 0x81U, 0xF1U, 0x90U, 0xFFU, 0x24U};
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(150);
    int answered = 0;
    for (int probe = 0; probe < 10000; ++probe) {
        Bytes request{(random() % 8U == 0U) ? byte() : one_of(services)};
        const std::size_t length = (random() % 16U == 0U) ? random() % 140U : random() % 8U;
        while (request.size() < 1U + length) {
            request.push_back((random() % 3U == 0U) ? byte() : one_of(likely));
        }
        const bool is_functional = (random() % 8U == 0U) && (request.size() <= 7U);
        Bytes answer = is_functional ? tester_.ask_functional(request, 4) : tester_.ask(request, 4);
        if (answer == no(request[0], 0x78U)) {  // a reset, which stores first
            answer = tester_.receive(600);
        }
        if (answer.empty()) {
            continue;
        }
        ++answered;
        if (answer[0] == 0x7FU) {
            ASSERT_EQ(answer.size(), 3U);
            ASSERT_EQ(answer[1], request[0]);
            ASSERT_TRUE(!is_functional || (answer[2] != 0x11U && answer[2] != 0x12U && answer[2] != 0x31U &&
                                           answer[2] != 0x7EU && answer[2] != 0x7FU));
        } else {
            ASSERT_EQ(answer[0], request[0] + 0x40U);
            ASSERT_TRUE(request[0] != 0x14U && request[0] != 0x2EU && request[0] != 0x34U &&
                        request[0] != 0x36U && request[0] != 0x37U)
                << "without a key";
        }
    }
    EXPECT_GT(answered, 5000);
    tester_.cycles(1000);
    EXPECT_EQ(tester_.ask({0x22U, 0xF1U, 0x90U}), Bytes({0x62U, 0xF1U, 0x90U}) + Bytes(17U, 0U));
    EXPECT_EQ(tester_.ask({0x19U, 0x02U, 0x01U}), (Bytes{0x59U, 0x02U, 0x7FU, 0xD1U, 0x20U, 0x87U, 0x2FU}));
    EXPECT_TRUE(memories_.section_one.record().empty());
    EXPECT_TRUE(memories_.section_other.record().empty());
}

}  // namespace
}  // namespace testing_diagnosis
