// The figures that the README shows are those of the run that it names.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "tests/sil/acceptance/closed_run.hpp"

namespace rsi_test {
namespace readme_figures_test {
namespace {

std::string readme() {
    std::ifstream file{std::string{RSI_SOURCE_DIR} + "/README.md"};
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// The number that stands right before `after`.
double number_before(const std::string& after) {
    static const std::string text = readme();
    const std::size_t end = text.find(after);
    if (end == std::string::npos) {
        ADD_FAILURE() << "the README does not say: " << after;
        return 0.0;
    }
    const std::size_t begin = text.find_last_not_of("0123456789.", end - 1U) + 1U;
    return std::stod(text.substr(begin, end - begin));
}

TEST(Readme, ShowsTheFiguresOfTheLockStepRun) {
    const RunResult run = drive({"j-turn-110"});
    ASSERT_TRUE(run.events.warning && run.events.one_wheel_lift && run.events.two_wheel_lift &&
                run.events.ssf_crossing);
    constexpr double half_a_millisecond = 0.0005 + 1.0e-9;
    EXPECT_NEAR(number_before(" s  >> ECU: warning, right side"), run.events.warning->time_s,
                half_a_millisecond);
    EXPECT_NEAR(number_before(" s  >> one wheel lifts"), run.events.one_wheel_lift->time_s,
                half_a_millisecond);
    EXPECT_NEAR(number_before(" s  >> two wheels of one side"), run.events.two_wheel_lift->time_s,
                half_a_millisecond);
    EXPECT_NEAR(number_before(" s  >> static stability factor"), run.events.ssf_crossing->time_s,
                half_a_millisecond);
    EXPECT_NEAR(number_before(" s before two-wheel lift-off"), run.events.judgement.lead_s.value(),
                half_a_millisecond);
}

}  // namespace
}  // namespace readme_figures_test
}  // namespace rsi_test
