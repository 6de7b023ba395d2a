// Outcomes of a warning that was due, counted from answers that are written by hand.
#include "sil/studies/faults/silence_watch.hpp"

#include <gtest/gtest.h>

#include "tests/sil/faults/written_answer.hpp"

namespace faults_test::silence_watch_test {
namespace {

using sil::EcuAnswer;
using sil::WarningSide;
using sil::WarningState;

constexpr float warning_off = 0.75F;
constexpr bool near = true;
constexpr bool far = false;

EcuAnswer saying(WarningState state, sil::DiagnosticCodes codes = 0U) {
    return written_answer(state, WarningSide::none, codes);
}

const EcuAnswer ready = saying(WarningState::ready);
const EcuAnswer warning = saying(WarningState::warning);
const EcuAnswer advisory = saying(WarningState::advisory);

// Two ECUs, of which the second one says what is right.
class Watched {
 public:
    // Adds this number of cycles in which a warning is due. Counts the silences that begin.
    Watched& due(int cycles, const std::optional<EcuAnswer>& faulty, bool fault = near,
                 float level = warning_off) {
        return cycles_of(cycles, faulty, warning, level, fault);
    }
    Watched& no_longer_due() { return cycles_of(1, ready, ready, 0.0F, far); }

    sil::EnduranceResult result{};
    int silences{0};

 private:
    Watched& cycles_of(int cycles, const std::optional<EcuAnswer>& faulty, const EcuAnswer& right,
                       float level, bool fault) {
        for (int cycle = 0; cycle < cycles; ++cycle) {
            silences += watch_.cycle(faulty, right, level, fault, result) ? 1 : 0;
        }
        return *this;
    }

    sil::SilenceWatch watch_{warning_off};
};

struct Counts {
    std::uint64_t with_fault;
    std::uint64_t warned;
    std::uint64_t told;
    std::uint64_t silenced;
};

void expect_counts(const sil::EnduranceResult& result, const Counts& expected) {
    EXPECT_EQ(result.due_with_fault, expected.with_fault);
    EXPECT_EQ(result.due_with_fault_warned, expected.warned);
    EXPECT_EQ(result.due_with_fault_reported, expected.told);
    EXPECT_EQ(result.due_with_fault_silenced, expected.silenced);
}

TEST(SilenceWatch, CountsAWarningThatCameInSpiteOfTheFault) {
    const Watched watched = Watched{}.due(5, warning).no_longer_due();
    EXPECT_EQ(watched.result.warnings_due, 1U);
    expect_counts(watched.result, {1U, 1U, 0U, 0U});
    EXPECT_EQ(watched.silences, 0);
    EXPECT_EQ(watched.result.longest_silence_ms, 0);
}

TEST(SilenceWatch, CountsEachWarningByItself) {
    const Watched watched = Watched{}
                                .due(3, ready)
                                .no_longer_due()
                                .due(3, warning)
                                .no_longer_due()
                                .due(3, advisory)
                                .no_longer_due();
    EXPECT_EQ(watched.result.warnings_due, 3U);
    expect_counts(watched.result, {3U, 1U, 0U, 1U});
}

TEST(SilenceWatch, CountsAWarningOnceItIsOver) {
    Watched watched = Watched{}.due(5, warning);
    EXPECT_EQ(watched.result.warnings_due, 1U);
    expect_counts(watched.result, {0U, 0U, 0U, 0U});
    watched.no_longer_due().no_longer_due();
    expect_counts(watched.result, {1U, 1U, 0U, 0U});
}

TEST(SilenceWatch, CountsNoFateWithoutAFault) {
    EXPECT_EQ(Watched{}.due(5, warning, far).no_longer_due().result.warnings_due, 1U);
    expect_counts(Watched{}.due(5, warning, far).no_longer_due().result, {0U, 0U, 0U, 0U});
    expect_counts(
        Watched{}.due(5, warning, far).due(1, warning, near).due(5, warning, far).no_longer_due().result,
        {1U, 1U, 0U, 0U});
}

TEST(SilenceWatch, OneCycleOfReadyWithoutACodeIsASilence) {
    const Watched watched = Watched{}.due(5, warning).due(1, ready).due(5, warning).no_longer_due();
    expect_counts(watched.result, {1U, 0U, 0U, 1U});
    EXPECT_EQ(watched.silences, 1);
    EXPECT_EQ(watched.result.longest_silence_ms, 10);
}

TEST(SilenceWatch, ReportsTheFirstCycleOfASilenceOfEachWarning) {
    const Watched watched =
        Watched{}.due(2, ready).due(1, warning).due(3, ready).no_longer_due().due(4, ready).no_longer_due();
    EXPECT_EQ(watched.silences, 2);
    EXPECT_EQ(watched.result.longest_silence_ms, 40);
}

TEST(SilenceWatch, MeasuresTheLongestSilenceWithoutABreak) {
    EXPECT_EQ(Watched{}.due(3, ready).due(1, warning).due(2, ready).result.longest_silence_ms, 30);
    EXPECT_EQ(Watched{}.due(2, ready).due(1, warning).due(3, ready).result.longest_silence_ms, 30);
    EXPECT_EQ(Watched{}.due(3, ready).no_longer_due().due(2, ready).result.longest_silence_ms, 30);
}

TEST(SilenceWatch, AReportIsNoSilence) {
    for (const EcuAnswer& told : {saying(WarningState::unavailable), saying(WarningState::ready, 4U),
                                  saying(WarningState::advisory, 4U)}) {
        const Watched watched = Watched{}.due(5, told).no_longer_due();
        expect_counts(watched.result, {1U, 0U, 1U, 0U});
        EXPECT_EQ(watched.silences, 0);
    }
    expect_counts(Watched{}.due(5, saying(WarningState::warning, 4U)).no_longer_due().result,
                  {1U, 1U, 0U, 0U});
    expect_counts(Watched{}.due(3, saying(WarningState::unavailable)).due(1, warning).no_longer_due().result,
                  {1U, 1U, 0U, 0U});
}

TEST(SilenceWatch, AReportOnceIsEnough) {
    const Watched watched =
        Watched{}.due(1, saying(WarningState::unavailable)).due(5, advisory).no_longer_due().due(1, advisory);
    expect_counts(watched.result, {1U, 0U, 1U, 0U});
    EXPECT_EQ(Watched{}.no_longer_due().no_longer_due().result.warnings_due, 0U);
}

TEST(SilenceWatch, AnAdvisoryOrAnEcuThatIsNotHeardIsNeitherSilenceNorWarning) {
    for (const std::optional<EcuAnswer>& other :
         {std::optional<EcuAnswer>{advisory}, std::optional<EcuAnswer>{}}) {
        const Watched watched = Watched{}.due(5, other).no_longer_due();
        expect_counts(watched.result, {1U, 0U, 0U, 0U});
        EXPECT_EQ(watched.silences, 0);
    }
}

// Below that level the second ECU merely holds what it has said.
TEST(SilenceWatch, AWarningIsDueFromTheLevelAtWhichItMayNotEnd) {
    const auto ready_at = [](float level) { return Watched{}.due(5, ready, near, level).no_longer_due(); };
    EXPECT_EQ(ready_at(warning_off).silences, 1);
    expect_counts(ready_at(warning_off).result, {1U, 0U, 0U, 1U});
    const float below = 0.7499F;
    EXPECT_EQ(ready_at(below).silences, 0);
    expect_counts(ready_at(below).result, {0U, 0U, 0U, 0U});
    EXPECT_EQ(ready_at(below).result.warnings_due, 1U);
    const auto after_a_due_cycle = [](const EcuAnswer& then) {
        return Watched{}.due(1, advisory).due(5, then, near, 0.7499F).no_longer_due().result;
    };
    expect_counts(after_a_due_cycle(warning), {1U, 0U, 0U, 0U});
    expect_counts(after_a_due_cycle(saying(WarningState::unavailable)), {1U, 0U, 0U, 0U});
}

}  // namespace
}  // namespace faults_test::silence_watch_test
