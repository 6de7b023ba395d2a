// The figures that the README shows are those of the run that it names.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include "tests/acceptance/closed_run.hpp"

namespace rsi_test {
namespace {

std::string readme() {
    std::ifstream file{std::string{RSI_SOURCE_DIR} + "/README.md"};
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// The first number that the expression catches; a failure when the README has no such line.
double figure(const std::string& expression) {
    static const std::string text = readme();
    std::smatch found;
    if (!std::regex_search(text, found, std::regex{expression})) {
        ADD_FAILURE() << "the README has no line like " << expression;
        return 0.0;
    }
    return std::stod(found[1]);
}

TEST(Readme, ShowsTheFiguresOfTheLockStepRun) {
    const RunResult run = drive({"j-turn-110"});
    ASSERT_TRUE(run.events.warning && run.events.one_wheel_lift && run.events.two_wheel_lift &&
                run.events.ssf_crossing);
    constexpr double half_a_millisecond = 0.0005 + 1.0e-9;
    EXPECT_NEAR(figure(R"(([0-9.]+) s  >> ECU: warning, right side)"), run.events.warning->time_s,
                half_a_millisecond);
    EXPECT_NEAR(figure(R"(([0-9.]+) s  >> one wheel lifts)"), run.events.one_wheel_lift->time_s,
                half_a_millisecond);
    EXPECT_NEAR(figure(R"(([0-9.]+) s  >> two wheels of one side)"), run.events.two_wheel_lift->time_s,
                half_a_millisecond);
    EXPECT_NEAR(figure(R"(([0-9.]+) s  >> static stability factor)"), run.events.ssf_crossing->time_s,
                half_a_millisecond);
    EXPECT_NEAR(figure(R"(lead time +([0-9.]+) s)"), run.events.lead_time_s().value(), half_a_millisecond);
    EXPECT_NEAR(figure(R"(the warning goes out, ([0-9.]+) s before)"), run.events.lead_time_s().value(),
                0.005);
}

}  // namespace
}  // namespace rsi_test
