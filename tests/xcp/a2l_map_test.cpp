// Facts that an A2L relies on: addresses and names of values, and that no frame has XCP's identifiers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "rsi/ecu/application/calibration_epk.hpp"
#include "tests/xcp/bench.hpp"

namespace testing_xcp {
namespace {

TEST(Epk, HasVersionAndBothLayoutsAndIsFilledUp) {
    Bench bench;
    bench.connect();
    std::string text;
    for (std::uint32_t at = 0U; at < 32U; at += 4U) {
        for (const std::uint8_t letter : bench.upload(map::epk_at + at, 4U)) {
            text += static_cast<char>(letter);
        }
    }
    const std::string begin = "rsi " RSI_VERSION " ";
    ASSERT_EQ(text.substr(0U, begin.size()), begin);
    const std::string words = text.substr(begin.size(), 17U);
    char layout[9];
    std::snprintf(layout, sizeof layout, "%08X", static_cast<unsigned>(rsi::application::section::layout));
    EXPECT_EQ(words.substr(0U, 8U), layout);
    EXPECT_EQ(words[8], ' ');
    EXPECT_TRUE(
        std::all_of(words.begin() + 9, words.end(), [](unsigned char c) { return std::isxdigit(c); }));
    EXPECT_EQ(text.substr(begin.size() + 17U), std::string(32U - begin.size() - 17U, '\0'));
    // The compiler's evaluation, repeated here.
    std::array<std::uint8_t, 32> again{};
    again = rsi::application::make_calibration_epk();
    EXPECT_EQ(std::string(again.begin(), again.end()), text);
}

TEST(Identifiers, AreNoFramesAndLowerInPriority) {
    for (const std::uint32_t xcp :
         {rsi::xcp::default_identifiers.command, rsi::xcp::default_identifiers.answer}) {
        for (const std::uint32_t frame : rsi::application::sent_identifiers) {
            EXPECT_LT(frame, xcp);
        }
        for (const std::uint32_t frame : rsi::application::received_identifiers) {
            EXPECT_LT(frame, xcp);
        }
    }
}

}  // namespace
}  // namespace testing_xcp
