// The README's output of a run equals that of the run (sil/apps/console_summary.cpp).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "sil/units.hpp"
#include "tests/sil/acceptance/closed_run.hpp"

namespace rsi_test {
namespace readme_figures_test {
namespace {

// The lines that the README shows.
std::vector<std::string> shown() {
    std::ifstream file{std::string{RSI_SOURCE_DIR} + "/README.md"};
    std::string line;
    while (std::getline(file, line) && line != "## What a run shows") {
    }
    while (std::getline(file, line) && line != "```") {
    }
    std::vector<std::string> lines;
    while (std::getline(file, line) && line != "```") {
        lines.push_back(line);
    }
    return lines;
}

std::string line_of(double time_s, const std::string& what) {
    return fmt::format("{:7.3f} s  >> {}", time_s, what);
}

std::string line_of(const sil::EventMoment& moment, const std::string& what) {
    return line_of(moment.time_s, fmt::format("{} at {:+.3f} g, roll {:+.2f} deg", what,
                                              moment.lateral_acceleration_mps2 / sil::g_mps2,
                                              moment.roll_angle_rad * sil::degrees_per_radian));
}

// The first cycle with that state.
std::string line_of(const RunResult& run, sil::WarningState state) {
    const auto first = std::find(run.states.begin(), run.states.end(), state);
    if (first == run.states.end()) {
        return "never";
    }
    const auto cycle = static_cast<std::size_t>(first - run.states.begin());
    return line_of(run.truths[cycle].time_s,
                   fmt::format("ECU: {}, {} side", sil::to_string(state), sil::to_string(run.sides[cycle])));
}

TEST(Readme, ShowsWhatTheLockStepRunPrints) {
    const RunResult run = drive({"j-turn-110"});
    ASSERT_TRUE(run.events.warning && run.events.one_wheel_lift && run.events.two_wheel_lift &&
                run.events.ssf_crossing);
    std::vector<std::string> printed{
        line_of(run, sil::WarningState::advisory),
        line_of(run, sil::WarningState::warning),
        line_of(*run.events.one_wheel_lift, "one wheel lifts"),
        line_of(*run.events.two_wheel_lift, "two wheels of one side have lifted"),
        line_of(*run.events.ssf_crossing, "static stability factor crossed"),
    };
    std::sort(printed.begin(), printed.end());  // of equal width, so in the order of time
    printed.push_back(fmt::format("  {:<22} {:7.3f} s before two-wheel lift-off, {} side", "lead time",
                                  run.events.judgement.lead_s.value(),
                                  sil::to_string(run.events.judgement.falling_side)));
    EXPECT_EQ(shown(), printed);
}

}  // namespace
}  // namespace readme_figures_test
}  // namespace rsi_test
